/// @file
/// Files are read whole and written whole: no reader ever sees half a file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace lt {

/// The bytes of a file.
/// @param path   a regular file
/// @param limit  the largest size that is accepted, in bytes
/// @throws InputError  missing, a directory, not readable, or larger than `limit`
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::size_t limit = std::size_t{1} << 30);

/// Writes `bytes` beside `path` and renames the result, so that `path` is old or new, never half.
/// Creates the folder of `path` if it is missing; a link is followed.
/// @throws OutputError  the folder cannot be written or the disk is full; the old file is intact
void write_file_whole(const std::filesystem::path& path, std::string_view bytes);

/// `text` fit for a message of one line: control characters become '?'.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace lt
