/// @file
/// An exercise as its folder describes it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runner/home.hpp"

namespace lt {

/// A mistake that people really make, as a replacement in the solution.
struct Mutant {
  std::string tag;      ///< "near-root-only"
  std::string find;     ///< occurs exactly once in solution.cpp
  std::string replace;  ///< what makes it wrong
  std::string says;     ///< one sentence that a person would say
};

/// What exercise.json says, and where it is.
struct Exercise {
  std::string id;       ///< "02.2"
  std::string name;     ///< "sphere", also its folder
  std::string title;    ///< "Hit a sphere"
  std::string chapter;  ///< "ch02_ray_casting"
  int minutes = 0;      ///< what it takes a learner, about
  std::vector<std::string> hints;
  std::vector<Mutant> mutants;
  std::filesystem::path folder;

  [[nodiscard]] std::string file_name() const { return id + "-" + name + ".cpp"; }
  [[nodiscard]] const Mutant* mutant(std::string_view tag) const;
};

/// All exercises, by id.
/// @throws InputError  an exercise.json is broken, or an id is used twice
[[nodiscard]] std::vector<Exercise> load_exercises(const Home& home);

/// The exercise that the person means by "02.2", "2.2", "sphere" or "02.2-sphere".
/// @throws InputError  there is none; the line names near ones
[[nodiscard]] const Exercise& find_exercise(const std::vector<Exercise>& exercises,
                                            const std::string& word);

}  // namespace lt
