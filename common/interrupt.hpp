/// @file
/// Ctrl-C asks a program to stop; it does not tear it down.
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace lt {

/// From the first call on, SIGINT (Ctrl-C) and SIGTERM set the flag that is returned. A second
/// signal ends the program at once.
[[nodiscard]] const std::atomic<bool>& interrupted();

/// What a program that was asked to stop returns, as shells expect: 128 + SIGINT.
inline constexpr int interrupted_exit_code = 130;

/// run_program() for a body that ends early, with what it has, once its argument is true: that of
/// interrupted().
/// @return as run_program(), but interrupted_exit_code for a body that was asked to stop and did
[[nodiscard]] int run_interruptible_program(
    const std::string& program, const std::function<void(const std::atomic<bool>& cancel)>& body);

}  // namespace lt
