/// @file
/// pictures.json and exercise.json, read by the runner's own readers: what those refuse is a
/// finding.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/exercise.hpp"
#include "runner/json_files.hpp"
#include "tests/house/finding.hpp"
#include "tests/house/tree.hpp"

namespace lt::house {

/// The pictures of a chapter; none where its pictures.json is refused.
[[nodiscard]] std::vector<Picture> read_pictures(const Tree& tree, const std::string& chapter,
                                                 Findings& findings);

/// An exercise.json; nothing where it is refused.
[[nodiscard]] std::optional<Exercise> read_exercise(const Tree& tree, const std::string& file,
                                                    Findings& findings);

}  // namespace lt::house
