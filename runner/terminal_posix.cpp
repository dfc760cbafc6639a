#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "runner/process.hpp"
#include "runner/terminal.hpp"

namespace lt {

bool stdin_is_terminal() {
  return isatty(STDIN_FILENO) != 0;
}
bool stdout_is_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}
bool stderr_is_terminal() {
  return isatty(STDERR_FILENO) != 0;
}

int terminal_columns() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return std::clamp(static_cast<int>(size.ws_col), 40, 100);
}

namespace {

// Signal handlers reach these.
termios before{};
termios with_keys{};
volatile std::sig_atomic_t has_resumed = 0;

constexpr char hide_cursor[] = "\x1b[?25l";
constexpr char show_cursor[] = "\x1b[?25h";

void put(std::string_view bytes) {
  [[maybe_unused]] const ssize_t written = write(STDOUT_FILENO, bytes.data(), bytes.size());
}

void restore() {
  tcsetattr(STDIN_FILENO, TCSANOW, &before);
  put(show_cursor);
}

void take() {
  tcsetattr(STDIN_FILENO, TCSANOW, &with_keys);
  put(hide_cursor);
}

// Ctrl-Z: give the terminal back, stop, and take it again when the person brings us back.
void step_aside(int) {
  restore();
  raise(SIGSTOP);
  take();
  has_resumed = 1;
}

}  // namespace

KeyReader::KeyReader() {
  tcgetattr(STDIN_FILENO, &before);
  with_keys = before;
  with_keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  with_keys.c_cc[VMIN] = 0;
  with_keys.c_cc[VTIME] = 0;
  take();
  std::signal(SIGTSTP, step_aside);
}

KeyReader::~KeyReader() {
  std::signal(SIGTSTP, SIG_DFL);
  restore();
}

char KeyReader::key(std::chrono::milliseconds wait) {
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  const int ready = poll(&waiting, 1, static_cast<int>(wait.count()));
  if (was_interrupted()) throw Interrupted();
  if (has_resumed != 0) {
    has_resumed = 0;
    return resumed;
  }
  if (ready <= 0) return 0;
  char bytes[256];
  const ssize_t size = read(STDIN_FILENO, bytes, sizeof bytes);
  if (size <= 0) return closed;
  // One key is one byte; more at once is an arrow key, the mouse, or a paste.
  return size == 1 ? bytes[0] : '\0';
}

}  // namespace lt
