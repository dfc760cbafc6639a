/// @file
/// Other programs: run them, read what they print, stop them when they take too long.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lt {

/// How a program ended.
struct ProcessResult {
  int exit_code = 0;       ///< 127 if the program was not found
  int signal = 0;          ///< the signal that killed it, or 0
  bool timed_out = false;  ///< it was stopped because its time was over
  std::string output;      ///< stdout and stderr in the order printed, the first 4 MB (on Windows
                           ///< without carriage returns)
  [[nodiscard]] bool succeeded() const { return exit_code == 0 && signal == 0 && !timed_out; }
};

struct ProcessOptions {
  std::filesystem::path folder;  ///< where it runs; empty: here
  double seconds = 0;            ///< time allowed; 0: no limit
  bool is_limited = false;       ///< at most 4 GB of memory, no core file: for learners' programs
  std::vector<std::pair<std::string, std::string>> environment;  ///< added to ours
  std::function<void(std::string_view)> on_output;               ///< called with each piece
};

/// Thrown when the person pressed Ctrl-C (or the terminal was closed) while we waited.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Runs `command` (program, then arguments; found through PATH) and waits. stdin is empty. May be
/// called from several threads: a Ctrl-C ends the programs of all of them.
/// @throws Interrupted  after the program has been stopped
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command,
                                        const ProcessOptions& options = {});

/// The same with our own stdin, stdout and stderr: for programs that talk to the person.
[[nodiscard]] ProcessResult run_visibly(const std::vector<std::string>& command,
                                        const ProcessOptions& options = {});

/// True if PATH has such a program.
[[nodiscard]] bool program_exists(const std::string& name);

/// From now on Ctrl-C makes the calls above throw Interrupted instead of ending us on the spot.
void catch_interrupts();
/// True once after each Ctrl-C; the calls above leave that for the next who asks.
[[nodiscard]] bool was_interrupted();

/// While it lives, another FileLock on the same path waits.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::intptr_t handle_;
};

}  // namespace lt
