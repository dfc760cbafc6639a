/// @file
/// A bar with the time left on a terminal, plain lines elsewhere.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace lt {

/// Shows on stderr how far a job is. advance() may be called from any thread.
class Progress {
 public:
  /// @param label  what is being done, e.g. "room normals"
  /// @param total  units of work, >= 1
  Progress(std::string label, std::int64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports `units` more as done.
  void advance(std::int64_t units = 1);

 private:
  void show(std::int64_t done, bool last);

  std::string label_;
  std::int64_t total_;
  std::atomic<std::int64_t> done_{0};
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point shown_;
  bool is_terminal_;
};

}  // namespace lt
