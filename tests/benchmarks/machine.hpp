/// @file
/// On what a number was measured.
#pragma once

#include <fstream>
#include <string>

namespace lt::bench {

/// The processor's name; "unknown processor" where the system does not tell it.
[[nodiscard]] inline std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

[[nodiscard]] inline std::string compiler_name() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "another compiler";
#endif
}

}  // namespace lt::bench
