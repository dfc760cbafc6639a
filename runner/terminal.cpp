#include "runner/terminal.hpp"

#include <cstdlib>
#include <iostream>

namespace lt {

namespace {

bool is_coloured() {
  static const bool answer = [] {
    const char* no_color = std::getenv("NO_COLOR");
    const char* kind = std::getenv("TERM");
    const bool is_unwanted = no_color != nullptr && *no_color != '\0';
    const bool is_dumb = kind != nullptr && std::string_view(kind) == "dumb";
    return stdout_is_terminal() && !is_unwanted && !is_dumb;
  }();
  return answer;
}

std::string in(const char* code, std::string_view text) {
  if (!is_coloured()) return std::string(text);
  return "\x1b[" + std::string(code) + "m" + std::string(text) + "\x1b[0m";
}

}  // namespace

std::string ink::bold(std::string_view text) {
  return in("1", text);
}
std::string ink::dim(std::string_view text) {
  return in("2", text);
}
std::string ink::red(std::string_view text) {
  return in("1;31", text);
}
std::string ink::green(std::string_view text) {
  return in("1;32", text);
}
std::string ink::yellow(std::string_view text) {
  return in("1;33", text);
}
std::string ink::cyan(std::string_view text) {
  return in("36", text);
}

void clear_screen() {
  std::cout << "\x1b[H\x1b[2J";
}

}  // namespace lt
