/// @file
/// Ctrl-C asks a program to stop; it does not tear it down.
#pragma once

#include <atomic>

namespace lt {

/// From the first call on, SIGINT (Ctrl-C) and SIGTERM set the flag that is returned. A second
/// signal ends the program at once.
[[nodiscard]] const std::atomic<bool>& interrupted();

/// What a program that was asked to stop returns, as shells expect: 128 + SIGINT.
inline constexpr int interrupted_exit_code = 130;

}  // namespace lt
