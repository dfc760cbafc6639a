/// @file
/// What --help prints.
#pragma once

#include <string>
#include <vector>

#include "runner/commands.hpp"

namespace lt {

/// All commands, by group.
[[nodiscard]] std::string help_text(const std::vector<Command>& commands);

/// One command with its details.
[[nodiscard]] std::string help_text(const Command& command);

}  // namespace lt
