/// @file
/// What a starter's body says before it is written. The one header of the kit that learners
/// include.
#pragma once

#include <stdexcept>
#include <string>

namespace lt {

/// Thrown by TODO(...): the runner shows file and line and calls the exercise "not started".
struct NotWritten : std::logic_error {
  NotWritten(const char* file_name, int line_number, const std::string& what_to_do)
      : std::logic_error(what_to_do), file(file_name), line(line_number) {}
  const char* file;
  int line;
};

}  // namespace lt

/// Stands for a body that is not written yet. A macro, because it must know its own line.
#define TODO(what_to_do) throw ::lt::NotWritten(__FILE__, __LINE__, what_to_do)
