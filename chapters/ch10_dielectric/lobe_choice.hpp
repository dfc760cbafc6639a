/// @file
/// Which of two lobes to sample: a choice that costs noise, and never the mean.
#pragma once

#include <concepts>

namespace lt {

// [lobe-choice]
/// A probability of choosing the coat, from the shares of the light that coat and base give back.
/// It may be 0 only where the coat's share is 0, and 1 only where the base's is.
template <class T>
concept LobeChoice = requires(const T& choice, float coat_share, float base_share) {
  { choice(coat_share, base_share) } -> std::same_as<float>;
};

/// Each lobe as often as its share of the light.
struct ByShare {
  [[nodiscard]] float operator()(float coat_share, float base_share) const {
    const float sum = coat_share + base_share;
    return sum > 0.0f ? coat_share / sum : 0.0f;
  }
};

/// Always the same.
struct FixedChoice {
  float probability;  ///< of the coat, 0 to 1, both ends excluded

  [[nodiscard]] float operator()(float /*coat_share*/, float /*base_share*/) const {
    return probability;
  }
};
// [lobe-choice]

}  // namespace lt
