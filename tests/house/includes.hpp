/// @file
/// Rule 2 of the house: includes point backwards only.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// Chapters by name, each with others.
using Uses = std::map<std::string, std::set<std::string>>;

/// What `lt_chapter(NAME USES ...)` in each chapter's CMakeLists.txt says, without theirs in turn.
[[nodiscard]] Uses read_direct_uses(const Tree& tree);

/// The same with what those stand on, and the chapter itself.
[[nodiscard]] Uses read_uses(const Tree& tree);

/// - A chapter stands on earlier chapters only, and is declared under its folder's name.
/// - A chapter's files include it, what it stands on, common/ and libraries.
/// - common/ includes common/; exercises include their api.hpp and the test kit.
/// - The test kit stays in tests, but for its statistics: programs measure their own noise.
/// - Every name starts at the root: no "../", no bare "sphere.hpp". Nobody includes Catch2 but the
///   test kit.
[[nodiscard]] Findings check_includes(const Tree& tree);

}  // namespace lt::house
