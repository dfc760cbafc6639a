/// @file
/// Ways to choose the facet that mirrors the light.
#pragma once

#include <concepts>

#include "ch08_microfacets/ggx.hpp"

namespace lt {

// [normal-sampler]
/// A way to choose facets of a rough surface seen along `wo` (unit, local frame, z > 0):
///   sample(ggx, wo, u)       normal of a facet made from two numbers in [0, 1): unit, z > 0
///   pdf(ggx, wo, h)          density with which sample() makes h, 1/sr
///   weight(ggx, wo, h, seen) D |wo.h| seen / (wo.z h's density), once all that cancels is gone:
///                            what a chosen facet counts if the share `seen` of its kind is both
///                            seen and lit; for facets that face wo, seen > 0
template <class T>
concept NormalSampler = requires(const Ggx& ggx, vec3 wo, vec3 h, vec2 u, float seen) {
  { T::sample(ggx, wo, u) } -> std::same_as<vec3>;
  { T::pdf(ggx, wo, h) } -> std::same_as<float>;
  { T::weight(ggx, wo, h, seen) } -> std::same_as<float>;
};
// [normal-sampler]

}  // namespace lt
