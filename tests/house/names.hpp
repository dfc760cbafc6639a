/// @file
/// Names and shapes of files.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// - Chapters are ch01_lower_case, C++ files snake_case.hpp or .cpp, tests end in _test.cpp,
///   figures and exercises are lower-case-with-hyphens.
/// - A C++ file has at most 200 lines in a chapter, 250 elsewhere, 300 if it holds tests; tables
///   laid out by hand do not count.
/// - A test's name has no semicolon, which CTest takes for the end of the name.
/// - Headers start with `#pragma once` below their comment.
/// - Text files end with a newline, have no tabs (Makefiles aside), no blanks at the ends of lines
///   and no carriage returns.
[[nodiscard]] Findings check_names(const Tree& tree);

}  // namespace lt::house
