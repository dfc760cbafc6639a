/// @file
/// Programs as their users meet them: arguments in, exit code and two streams out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lt::house {

/// How a program ended.
struct Outcome {
  int exit_code;    ///< 128 + signal where it was ended by one
  std::string out;  ///< what it wrote to stdout
  std::string err;  ///< what it wrote to stderr
};

/// Runs a program to its end, without standard input.
/// @param command  the program and its arguments, unquoted
/// @param folder   where it runs; empty: here
[[nodiscard]] Outcome run(const std::vector<std::string>& command,
                          const std::filesystem::path& folder = {});

/// A new empty folder that disappears with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lt::house
