#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

// Light to signal, both 0 to 1. A power has an infinite slope at 0; near black a line replaces it.
double encode(double linear) {
  if (linear <= 0.0031308) return 12.92 * linear;
  return 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

}  // namespace

int to_code(double linear) {
  if (!(linear > 0.0)) return 0;  // not "linear <= 0": that would let NaN through
  if (linear > 1.0) return 255;   // before the cast, which is undefined for huge numbers
  const double signal = encode(linear);
  return static_cast<int>(255.0 * signal + 0.5);  // the cast drops the fraction, + 0.5 rounds
}

}  // namespace exercise
