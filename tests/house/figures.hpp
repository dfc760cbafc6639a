/// @file
/// No picture that the shown code did not make.
#pragma once

#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// - What is in a chapter's figures/ was made by its program (an entry of pictures.json with
///   "stored") or is a drawing of our own (an SVG that is not listed there), has at most 200 KB,
///   and is shown by a page.
/// - Every entry with "stored" is there.
/// - The drawing of the chapters' chain has an arrow for each chapter that stands on another.
/// - Where a chapter's text shows a made picture, the command that makes it stands below it.
[[nodiscard]] Findings check_figures(const Tree& tree);

}  // namespace lt::house
