/// @file
/// The two ways in which a program of the course ends early, each with one line for the person.
#pragma once

#include <stdexcept>

namespace lt {

/// The person gave something unusable: an option, a file. The message names the thing and the
/// remedy in one line. Programs end with exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The machine could not write what was asked: a full disk, a read-only folder. Exit code 1.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lt
