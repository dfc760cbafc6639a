/// @file
/// The table of `./learn verify --all`.
#pragma once

#include <vector>

#include "runner/exercise.hpp"
#include "runner/home.hpp"
#include "runner/judge.hpp"

namespace lt {

/// Which answers are judged.
struct ProofChoice {
  bool solutions = false;
  bool starters = false;
  bool mutants = false;
  bool fair = false;  ///< right answers again, with many seeds
  int seeds = 200;

  [[nodiscard]] bool any() const { return solutions || starters || mutants || fair; }
  [[nodiscard]] std::vector<Answer> answers(const Exercise& exercise) const;
};

/// Builds the answers, judges them, prints a table and "N passed, N failed".
/// @return 0 if all are as they must be, else 1
[[nodiscard]] int prove(const Home& home, const ProofChoice& choice);

}  // namespace lt
