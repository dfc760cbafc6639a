/// @file
/// Text and code are one.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// In the chapters' texts every ```cpp fence is cut from a compiled file, which its comment
/// `<!-- snippet: file tag -->` names and which it equals, or says `<!-- not compiled: why -->`;
/// and none has more than 30 lines.
[[nodiscard]] Findings check_snippets(const Tree& tree);

}  // namespace lt::house
