/// @file
/// The watch: looks at the learner's file five times a second and says at once how it stands.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "runner/lesson.hpp"

namespace lt {

/// Notices that the learner's file has changed, by its content.
class Watcher {
 public:
  static constexpr std::chrono::milliseconds interval{200};

  /// @return true once after each change, and the first time
  [[nodiscard]] bool has_changed(const Lesson& lesson, const Exercise& exercise);

 private:
  std::string seen_;
};

/// Opens the current exercise and stays until the person quits. stdin and stdout are a terminal.
/// @return the exit code
int watch(const Lesson& lesson);

}  // namespace lt
