/// @file
/// CMake, called quietly: one line of progress, everything else only when it fails.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "runner/home.hpp"
#include "runner/process.hpp"

namespace lt {

/// A build that failed; the message is what CMake and the compiler printed.
struct BuildFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Configures build/PRESET unless that has been done.
/// @throws BuildFailed
void configure(const Home& home, const std::string& preset);

/// Configures `source` into `binary` unless that has been done with the same settings.
/// @param settings  "-DNAME=VALUE"
/// @throws BuildFailed
void configure_folder(const std::filesystem::path& source, const std::filesystem::path& binary,
                      const std::vector<std::string>& settings);

/// Builds targets of a configured folder; shows `label` and how far it is.
/// @param targets  empty: all
/// @throws BuildFailed
void build(const std::filesystem::path& binary, const std::vector<std::string>& targets,
           const std::string& label);

/// The same without complaint: for a learner's file, which may well not compile. Shows `label` on a
/// terminal only.
[[nodiscard]] ProcessResult try_build(const std::filesystem::path& binary,
                                      const std::string& target, const std::string& label);

/// A program that a build made: in `folder`, or in a folder per configuration (Visual Studio).
[[nodiscard]] std::filesystem::path built_program(const std::filesystem::path& folder,
                                                  const std::string& name);

}  // namespace lt
