/// @file
/// Mistakes to look at. Pictures, plots and tables of mistakes are made with them, and the tests
/// show that they fail; nothing else uses them.
#pragma once

#include <cmath>
#include <cstdint>

#include "ch04_monte_carlo/estimator.hpp"

namespace lt::mistakes {

// [naive-unit-float]
/// 32 bits by 2^32. A float holds 24: the largest 128 numbers are rounded up to exactly 1.
[[nodiscard]] inline float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits) / 4294967296.0f;
}
// [naive-unit-float]

// [seeds]
/// Pixels on a diagonal get the same numbers.
[[nodiscard]] constexpr Pcg32 diagonal_stream(std::uint64_t seed, int x, int y, int sample) {
  return Pcg32(seed + static_cast<std::uint64_t>(x + y), static_cast<std::uint64_t>(sample));
}

/// All pixels get the same numbers.
[[nodiscard]] constexpr Pcg32 same_stream(std::uint64_t seed, int, int, int sample) {
  return Pcg32(seed, static_cast<std::uint64_t>(sample));
}

/// Every pixel has its own seed, but neighbours have neighbouring ones.
[[nodiscard]] constexpr Pcg32 neighbour_stream(std::uint64_t seed, int x, int y, int sample) {
  return Pcg32(seed + static_cast<std::uint64_t>(4096 * y + x), static_cast<std::uint64_t>(sample));
}
// [seeds]

// [two-draws]
/// Two draws in one list of arguments: C++ does not say which comes first. g++ takes y first,
/// clang takes x.
[[nodiscard]] inline vec2 next_vec2(Pcg32& random) {
  return vec2(random.next_float(), random.next_float());
}
// [two-draws]

// [thesis-importance]
/// Thesis eq. 12 as printed, with |b - a| before the sum: right only if p is the density divided
/// by that of the uniform distribution, which the text does not say.
template <class Function, Density P>
[[nodiscard]] RunningMean estimate_importance(const Function& f, const P& density, double a,
                                              double b, int n, Pcg32& random) {
  RunningMean samples;
  for (int i = 0; i < n; ++i) {
    const double u = random.next_float();
    const double x = density.sample(u);
    samples.add(std::abs(b - a) * f(x) / density.pdf(x));
  }
  return samples;
}
// [thesis-importance]

// [naive-variance]
/// Variance as the mean of the squares minus the square of the mean: the difference of two numbers
/// that are nearly equal if the values lie far from 0.
class SumOfSquares {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  [[nodiscard]] double variance() const {
    const double mean = sum_ / count_;
    return (squares_ / count_ - mean * mean) * count_ / (count_ - 1);
  }

 private:
  double count_ = 0;
  double sum_ = 0;
  double squares_ = 0;
};
// [naive-variance]

// [square-root]
/// Meant for p(x) = 3 x^2; it has p(x) = 2 x.
[[nodiscard]] inline double sample_parabola(double u) {
  return std::sqrt(1 - u);
}
// [square-root]

// [offset]
/// The variance of a thousand uniform multiples of 2^-10, with `offset` added to each: the sums
/// are exact, so the variance should not change.
struct Variances {
  double exact, welford, naive;
};

[[nodiscard]] inline Variances variances_at_offset(double offset, std::uint64_t seed) {
  Pcg32 random(seed);
  RunningMean plain, welford;
  SumOfSquares naive;
  for (int i = 0; i < 1000; ++i) {
    const double value = (random.next_bits() >> 22) * 0x1p-10;
    plain.add(value);
    welford.add(offset + value);
    naive.add(offset + value);
  }
  return {plain.variance(), welford.variance(), naive.variance()};
}
// [offset]

}  // namespace lt::mistakes
