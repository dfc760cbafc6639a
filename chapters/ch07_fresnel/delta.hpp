/// @file
/// Deltas: surfaces that answer from one direction only.
#pragma once

#include "ch05_rendering_equation/bsdf.hpp"

namespace lt {

// [delta]
/// A sample of a delta: all light comes from `wi` alone. Its density there would be infinite, and
/// so would the BSDF; only their quotient, the weight, is a number. By agreement the density is 0,
/// as are eval() and pdf() for every pair of directions: nobody who chooses a direction by other
/// means meets that one.
/// @param weight  what radiance from wi is multiplied by
[[nodiscard]] inline BsdfSample delta_sample(vec3 wi, Rgb weight) {
  return {wi, weight, 0.0f};
}

/// True if the sample's direction is the only one, so that no other way of choosing can find it.
[[nodiscard]] inline bool is_delta(const BsdfSample& sample) {
  return sample.pdf == 0.0f;
}
// [delta]

}  // namespace lt
