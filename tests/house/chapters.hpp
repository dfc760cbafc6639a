/// @file
/// Every chapter is complete: text in its ten parts, pictures, code, tests.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// Names of the chapters' folders, in order.
[[nodiscard]] std::vector<std::string> chapters_of(const Tree& tree);

/// Each chapter has README.md (title, opening picture, the three lines, the parts in their order,
/// 1,500 to 3,000 words), pictures.json with a picture that the text shows, main.cpp of at most 80
/// lines, tests, and at least one exercise. Chapters are listed in the two tables of contents.
[[nodiscard]] Findings check_chapters(const Tree& tree);

}  // namespace lt::house
