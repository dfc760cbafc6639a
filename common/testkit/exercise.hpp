/// @file
/// What an exercise's test.cpp is written with, close_to() included. The lines it prints are read
/// by `./learn`:
///   [not-written] file:line: what to do
///   [diag:TAG] what was seen
///   [measured] what the right answer showed
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/not_written.hpp"

namespace lt {

/// Names a mistake that people really make: prints "[diag:TAG] seen" and fails the test, unless
/// `is_right`. The sentence that the learner reads is `says` of that tag in exercise.json,
/// followed by `seen`. Call it before the general checks, most specific mistake first.
/// @param tag   as in exercise.json, e.g. "gamma22"
/// @param seen  what the learner's code gave and what it should have given, in numbers
void diagnose(bool is_right, std::string_view tag, const std::string& seen);

/// Prints "[measured] text": something true and interesting that the checked code showed.
void measured(const std::string& text);

/// A number for `seen`.
/// @param digits  how many at most
[[nodiscard]] std::string text_of(double x, int digits = 6);
/// "(0, 0.6, 0.8)"
[[nodiscard]] std::string text_of(glm::dvec3 v);

/// The same in six digits, but the largest double and the largest float below 1 by their names:
/// "1 - 2^-53" and "1 - 2^-24".
[[nodiscard]] std::string text_of_u(double u);

/// Seeds that this run goes through: one normally, many under the fairness check
/// (environment variable LT_FAIR_SEEDS). Every test case that draws random input loops over them.
[[nodiscard]] std::vector<std::uint64_t> seeds();

/// A small generator for the tests' own inputs (SplitMix64; chapter 4 teaches better ones).
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] std::uint64_t next_bits();
  /// Uniform in [low, high).
  [[nodiscard]] double uniform(double low = 0, double high = 1);
  /// Uniform on the unit sphere.
  [[nodiscard]] glm::dvec3 direction();

 private:
  std::uint64_t state_;
};

}  // namespace lt
