/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch06_importance_sampling/cosine_lambert.hpp"

namespace lt::mistakes {

// [old-density]
/// Asks in proportion to the cosine and still divides by chapter 5's density, 1 / (2 pi). The
/// weight is 2 albedo cos, and the cosine's mean is no longer 1/2 but 2/3.
struct LambertWithOldDensity : CosineLambert {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = cosine_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) * wi.z / uniform_hemisphere_pdf, uniform_hemisphere_pdf};
  }
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? uniform_hemisphere_pdf : 0.0f;
  }
};
// [old-density]

// [no-root]
/// Forgets the square root: half of the points lie in the inner quarter of the disk.
[[nodiscard]] inline vec3 cosine_hemisphere_without_root(vec2 u) {
  const float radius = u.x;
  const float phi = 2.0f * pi * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1.0f - radius * radius)};
}

struct LambertWithoutRoot : CosineLambert {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 /*wo*/, vec3 u) const {
    const vec3 wi = cosine_hemisphere_without_root(vec2(u));
    return BsdfSample{wi, albedo, cosine_hemisphere_pdf(wi.z)};
  }
};
// [no-root]

// [both-uniform]
/// Asks in proportion to the cosine, and writes 1 / (2 pi) for the density *and* for BRDF times
/// cosine. The two errors cancel in the weight, which is the albedo, as it should be: every picture
/// is right. But no direction comes with the density that it says, and the surface is not
/// Lambert's.
struct BothUniform {
  Rgb albedo;  ///< 0 to 1

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? albedo * uniform_hemisphere_pdf / std::abs(wi.z) : Rgb(0.0f);
  }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 /*wo*/, vec3 u) const {
    const vec3 wi = cosine_hemisphere(vec2(u));
    return BsdfSample{wi, albedo, uniform_hemisphere_pdf};
  }
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? uniform_hemisphere_pdf : 0.0f;
  }
};
// [both-uniform]

// [both-uniform-asked]
/// The same surface, asked in another way: by directions that do have the density 1 / (2 pi). One
/// surface, two samplers, two pictures: one of them lies.
struct BothUniformAskedEvenly : BothUniform {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = uniform_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) * wi.z / uniform_hemisphere_pdf, uniform_hemisphere_pdf};
  }
};
// [both-uniform-asked]

[[nodiscard]] inline LambertWithOldDensity old_density_at(const Surface& surface) {
  return {{surface.material.tint}};
}
[[nodiscard]] inline LambertWithoutRoot without_root_at(const Surface& surface) {
  return {{surface.material.tint}};
}
[[nodiscard]] inline BothUniform both_uniform_at(const Surface& surface) {
  return {surface.material.tint};
}
[[nodiscard]] inline BothUniformAskedEvenly both_uniform_asked_evenly_at(const Surface& surface) {
  return {{surface.material.tint}};
}

}  // namespace lt::mistakes
