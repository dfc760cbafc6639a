/// @file
/// A program that believes that a person sits in front of it (POSIX).
#pragma once

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace lt::test {

/// Runs in a terminal of its own until it ends, or with this object.
class TerminalProgram {
 public:
  TerminalProgram(std::vector<std::string> command,
                  const std::vector<std::pair<std::string, std::string>>& environment) {
    terminal_ = posix_openpt(O_RDWR | O_NOCTTY);
    grantpt(terminal_);
    unlockpt(terminal_);
    const std::string other_end = ptsname(terminal_);
    child_ = fork();
    if (child_ > 0) return;
    setsid();
    const int end = open(other_end.c_str(), O_RDWR);
    for (const int stream : {0, 1, 2})
      dup2(end, stream);
    for (const auto& [name, value] : environment)
      setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> words;
    for (std::string& word : command)
      words.push_back(word.data());
    words.push_back(nullptr);
    execv(words[0], words.data());
    _exit(127);
  }
  ~TerminalProgram() {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close(terminal_);
  }
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;

  void press(char key) const { [[maybe_unused]] const auto written = write(terminal_, &key, 1); }

  /// Waits until `text` has come onto the screen since the last call; false after `seconds`.
  [[nodiscard]] bool shows(const std::string& text, int seconds = 120) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (std::chrono::steady_clock::now() < end) {
      const std::size_t place = screen_.find(text, told_);
      if (place != std::string::npos) {
        told_ = place + text.size();
        return true;
      }
      pollfd waiting{terminal_, POLLIN, 0};
      if (poll(&waiting, 1, 100) <= 0) continue;
      char bytes[4096];
      const ssize_t size = read(terminal_, bytes, sizeof bytes);
      if (size <= 0) return false;
      screen_.append(bytes, static_cast<std::size_t>(size));
    }
    return false;
  }

  /// Everything that it has printed up to now.
  [[nodiscard]] const std::string& screen() const { return screen_; }

  /// Waits for its end.
  [[nodiscard]] int exit_code() {
    (void)shows("\1 never", 10);  // reads on until the other end is closed
    int status = 0;
    waitpid(std::exchange(child_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  int terminal_ = -1;
  pid_t child_ = -1;
  std::string screen_;
  std::size_t told_ = 0;
};

}  // namespace lt::test
#endif
