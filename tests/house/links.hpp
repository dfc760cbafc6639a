/// @file
/// Links between texts lead somewhere.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// Every relative link and picture in every .md names a file or folder of the project; every
/// anchor names a heading of its page (or a line of a source file, "#L12"); every picture says in
/// words what it shows. Links to other sites are left alone.
[[nodiscard]] Findings check_links(const Tree& tree);

}  // namespace lt::house
