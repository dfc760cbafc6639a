#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <algorithm>
#include <array>
#include <iostream>

#include "runner/process.hpp"
#include "runner/terminal.hpp"

#ifndef ENABLE_VIRTUAL_TERMINAL_PROCESSING
#define ENABLE_VIRTUAL_TERMINAL_PROCESSING 0x0004
#endif

namespace lt {

namespace {

// True if the stream is a console that understands escape sequences; from then on it does, and it
// reads our text as UTF-8. (An old one does not: it gets plain text.)
bool is_console(DWORD stream) {
  const HANDLE console = GetStdHandle(stream);
  DWORD mode = 0;
  if (!GetConsoleMode(console, &mode)) return false;
  SetConsoleOutputCP(CP_UTF8);
  return SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

}  // namespace

bool stdin_is_terminal() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_INPUT_HANDLE), &mode) != 0;
}
bool stdout_is_terminal() {
  static const bool answer = is_console(STD_OUTPUT_HANDLE);
  return answer;
}
bool stderr_is_terminal() {
  static const bool answer = is_console(STD_ERROR_HANDLE);
  return answer;
}

int terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO screen{};
  if (!GetConsoleScreenBufferInfo(GetStdHandle(STD_OUTPUT_HANDLE), &screen)) return 80;
  return std::clamp(screen.srWindow.Right - screen.srWindow.Left + 1, 40, 100);
}

namespace {

DWORD mode_before = 0;

constexpr char hide_cursor[] = "\x1b[?25l";
constexpr char show_cursor[] = "\x1b[?25h";

// The character of a key that goes down; 0 for Shift, arrows, keys that come up, the mouse.
wchar_t character(const INPUT_RECORD& event) {
  const bool is_key = event.EventType == KEY_EVENT && event.Event.KeyEvent.bKeyDown != 0;
  return is_key ? event.Event.KeyEvent.uChar.UnicodeChar : L'\0';
}

}  // namespace

KeyReader::KeyReader() {
  const HANDLE keyboard = GetStdHandle(STD_INPUT_HANDLE);
  GetConsoleMode(keyboard, &mode_before);
  SetConsoleMode(keyboard, ENABLE_PROCESSED_INPUT);  // no echo, no lines; Ctrl-C stays Ctrl-C
  std::cout << hide_cursor << std::flush;
}

KeyReader::~KeyReader() {
  SetConsoleMode(GetStdHandle(STD_INPUT_HANDLE), mode_before);
  std::cout << show_cursor << std::flush;
}

char KeyReader::key(std::chrono::milliseconds wait) {
  const HANDLE keyboard = GetStdHandle(STD_INPUT_HANDLE);
  const DWORD ready = WaitForSingleObject(keyboard, static_cast<DWORD>(wait.count()));
  if (was_interrupted()) throw Interrupted();
  if (ready == WAIT_TIMEOUT) return 0;
  std::array<INPUT_RECORD, 256> events;
  DWORD count = 0;
  if (!ReadConsoleInputW(keyboard, events.data(), static_cast<DWORD>(events.size()), &count)) {
    return closed;
  }
  std::wstring characters;
  for (DWORD i = 0; i < count; ++i) {
    if (character(events[i]) != L'\0') characters += character(events[i]);
  }
  // More than one at once is a paste.
  if (characters.size() != 1 || characters[0] > 127) return 0;
  return characters[0] == L'\r' ? '\n' : static_cast<char>(characters[0]);
}

}  // namespace lt
