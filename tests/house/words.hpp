/// @file
/// What no tracked file may say.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// The course holds on every machine and speaks to its reader: no text names a folder of the
/// machine it was written on, a package registry's host, or the tools of whoever wrote it.
[[nodiscard]] Findings check_words(const Tree& tree);

}  // namespace lt::house
