/// @file
/// The programs, as this build made them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lt::house {

struct Program {
  std::string chapter;         ///< "ch02_ray_casting"
  std::filesystem::path file;  ///< the program
};

/// Every chapter's program, in order.
[[nodiscard]] std::vector<Program> programs();

/// The runner behind `./learn`.
[[nodiscard]] std::filesystem::path learn_program();

}  // namespace lt::house
