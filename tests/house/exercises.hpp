/// @file
/// Every exercise is complete. That it is *sound* is proved by building it, in exercises/.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// Each folder exercises/CHAPTER/NAME/ holds the seven files; exercise.json is one that the runner
/// takes, with an id that no other has; what a mutant replaces occurs once in the solution, and the
/// test diagnoses its tag; the starter has something to do; the chapter's text links to the page.
[[nodiscard]] Findings check_exercises(const Tree& tree);

}  // namespace lt::house
