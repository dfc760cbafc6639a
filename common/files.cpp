#include "common/files.hpp"

#include <cerrno>
#include <chrono>
#include <fstream>
#include <random>
#include <system_error>
#include <thread>

#include "common/error.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

std::string name_of(const fs::path& path) {
  return path.empty() ? "(no file name)" : printable(path.string());
}

[[noreturn]] void fail_to_write(const fs::path& path, const std::string& reason) {
  throw OutputError("cannot write " + name_of(path) + ": " + printable(reason) +
                    "; free some space or choose a folder that you may write");
}

void check_readable_kind(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(name_of(path) + " is not there; check the path");
  if (status.type() == fs::file_type::none)
    throw InputError("cannot look at " + name_of(path) + ": " + error.message() +
                     "; check the path and its permissions");
  if (status.type() == fs::file_type::directory)
    throw InputError(name_of(path) + " is a folder; name a file in it");
  if (status.type() != fs::file_type::regular)
    throw InputError(name_of(path) + " is no regular file; name one");
}

// A name beside `path` that no other run picks: readers that look for `path` never see it.
fs::path temporary_beside(const fs::path& path) {
  std::random_device random;
  fs::path temporary = path;
  temporary += ".part" + std::to_string(random() % 1'000'000'000u);
  return temporary;
}

// What a failed operation on a stream left in errno, in words.
std::string last_error(const std::string& otherwise) {
  return errno ? std::generic_category().message(errno) : otherwise;
}

// Tries until it succeeds. Windows refuses a file that another program has open, be it to look for
// viruses, or that is being replaced: a moment later it agrees. Elsewhere one attempt tells all.
template <class Attempt>
void try_for_a_moment(const Attempt& attempt) {
#ifdef _WIN32
  constexpr int attempts = 200;
#else
  constexpr int attempts = 1;
#endif
  for (int i = 1; !attempt() && i < attempts; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

// Removes a temporary file unless it has been renamed away.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

std::string printable(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return line;
}

std::string read_file(const fs::path& path, std::size_t limit) {
  check_readable_kind(path);
  errno = 0;
  std::ifstream file;
  try_for_a_moment([&] {
    file.open(path, std::ios::binary | std::ios::ate);
    return file.is_open();
  });
  // The size of what was opened: the path may name another file by now.
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  if (size >= 0 && static_cast<std::uintmax_t>(size) > limit)
    throw InputError(name_of(path) + " has " + std::to_string(size) +
                     " bytes; name a file of at most " + std::to_string(limit));
  std::string bytes(size < 0 ? 0 : static_cast<std::size_t>(size), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file)
    throw InputError("cannot read " + name_of(path) + ": " + last_error("it ends early") +
                     "; check its permissions");
  return bytes;
}

void write_file_whole(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  // A link stays a link: what it points to is replaced.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (!target.has_filename()) fail_to_write(path, "that names no file");
  // Renaming over a folder would fail late, over a device it would replace the device.
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    fail_to_write(path, "that is a folder or a device, not a file");
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), error);
  if (error && !fs::is_directory(target.parent_path())) fail_to_write(path, error.message());

  const TemporaryFile temporary(temporary_beside(target));
  errno = 0;
  std::ofstream file(temporary.path(), std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) fail_to_write(path, last_error("it could not be finished"));
  try_for_a_moment([&] {
    fs::rename(temporary.path(), target, error);
    return !error;
  });
  if (error) fail_to_write(path, error.message());
}

}  // namespace lt
