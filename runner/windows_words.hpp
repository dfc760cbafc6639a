/// @file
/// Words as Windows wants them: UTF-16, a command in one line, an environment in one block.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lt {

/// UTF-8, which the course speaks, in the UTF-16 of Windows. Broken bytes become U+FFFD.
[[nodiscard]] std::wstring wide(const std::string& text);

/// The command in one line that programs take apart into the same words again, by the rules of
/// CommandLineToArgvW: words in quotes; a backslash stands for itself unless it, or a row of them,
/// comes before a quote.
[[nodiscard]] std::wstring command_line(const std::vector<std::string>& command);

/// Our environment with these variables added or replaced (names in any case), as CreateProcessW
/// wants it: sorted by name, a zero behind each entry and one more at the end.
[[nodiscard]] std::wstring environment_block(
    const std::vector<std::pair<std::string, std::string>>& added);

/// The file of a program: looked for in PATH, with .exe, unless it is named with its folder.
/// Empty if it is not there.
[[nodiscard]] std::wstring find_program(const std::string& name);

}  // namespace lt
