/// @file
/// Exercise 10.2: what you write and what the checker calls.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// One of a surface's ways to send light on: makes a direction of two random numbers, follows it,
/// and says how much light it brings.
using Lobe = std::function<double(glm::dvec2 u)>;

/// An estimate of what coat and base bring together, of which only one is asked.
/// @param p  how often to ask the coat, 0 to 1
/// @param u  three independent random numbers in [0, 1): small u.z ask the coat, and u.x and u.y
///           belong to the lobe
[[nodiscard]] double one_of_both(const Lobe& coat, const Lobe& base, double p, glm::dvec3 u);

/// The p with which one_of_both() has the least noise under an even sky.
/// @param share  of the light that the coat reflects (Fresnel), 0 to 1; the rest reaches the base
/// @param tint   the share of it that the base sends back, 0 to 1
/// @return 0 to 1; where neither sends anything back, any such number
[[nodiscard]] double coat_probability(double share, double tint);

}  // namespace exercise
