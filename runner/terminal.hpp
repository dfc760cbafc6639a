/// @file
/// The terminal: is there one, how wide is it, may it be coloured, which key was pressed.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace lt {

[[nodiscard]] bool stdin_is_terminal();
[[nodiscard]] bool stdout_is_terminal();
[[nodiscard]] bool stderr_is_terminal();

/// Columns of the terminal on stdout, from 40 to 100; 80 where there is none.
[[nodiscard]] int terminal_columns();

/// Words in colour where stdout is a terminal and NO_COLOR is not set; plain elsewhere.
namespace ink {
[[nodiscard]] std::string bold(std::string_view text);
[[nodiscard]] std::string dim(std::string_view text);
[[nodiscard]] std::string red(std::string_view text);
[[nodiscard]] std::string green(std::string_view text);
[[nodiscard]] std::string yellow(std::string_view text);
[[nodiscard]] std::string cyan(std::string_view text);
}  // namespace ink

/// Keys one by one, without echo, while it lives. The terminal is as before afterwards, whichever
/// way the program ends: return, exception, or Ctrl-C (which run_process and key() turn into
/// Interrupted). Ctrl-Z and `fg` work.
class KeyReader {
 public:
  KeyReader();
  ~KeyReader();
  KeyReader(const KeyReader&) = delete;
  KeyReader& operator=(const KeyReader&) = delete;

  /// @return a letter, '\n', `resumed` after the program was in the background, `closed` if the
  ///         terminal has gone, or 0 if nothing was pressed in time. Arrow keys, mouse and pasted
  ///         text give 0.
  /// @throws Interrupted  Ctrl-C
  [[nodiscard]] char key(std::chrono::milliseconds wait);

  static constexpr char closed = 4;
  static constexpr char resumed = 1;
};

/// Clears the visible screen; what was scrolled off it stays.
void clear_screen();

}  // namespace lt
