/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch05_rendering_equation/radiance.hpp"
#include "ch05_rendering_equation/uniform_lambert.hpp"

namespace lt::mistakes {

// [no-cosine]
/// Forgets that slanting light is spread over more ground: the weight is f / pdf.
struct LambertWithoutCosine : UniformLambert {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = uniform_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) / uniform_hemisphere_pdf, uniform_hemisphere_pdf};
  }
};
// [no-cosine]

// [no-pi]
/// Takes the albedo itself for the BRDF.
struct LambertWithoutPi : UniformLambert {
  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return same_side(wo, wi) ? albedo : Rgb(0.0f); }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = uniform_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) * wi.z / uniform_hemisphere_pdf, uniform_hemisphere_pdf};
  }
};
// [no-pi]

/// Every surface as matt as chalk, but for the cosine.
[[nodiscard]] inline LambertWithoutCosine without_cosine_at(const Surface& surface) {
  return {{surface.material.tint}};
}

/// Every surface as matt as chalk, but for pi.
[[nodiscard]] inline LambertWithoutPi without_pi_at(const Surface& surface) {
  return {{surface.material.tint}};
}

// [no-offset]
/// A scene whose surfaces are taken for exact: the next ray starts where the last one ended.
template <Traceable Scene>
struct WithoutOffset {
  const Scene& scene;
};

template <Traceable Scene>
[[nodiscard]] std::optional<Hit> closest_hit(const WithoutOffset<Scene>& wrong, const Ray& ray) {
  return closest_hit(wrong.scene, ray);
}

template <Traceable Scene>
[[nodiscard]] Surface surface_at(const WithoutOffset<Scene>& wrong, const Ray& ray, Hit hit) {
  Surface surface = surface_at(wrong.scene, ray, hit);
  surface.point.position = ray.at(hit.t);
  surface.point.position_error = 0.0f;  // so that leave() moves by nothing
  return surface;
}

template <Traceable Scene>
[[nodiscard]] Rgb background(const WithoutOffset<Scene>& wrong, vec3 direction) {
  return background(wrong.scene, direction);
}
// [no-offset]

// [black-end]
/// Ends in black, one surface too early: the last surface's own light never counts.
template <Traceable Scene, Scattering Model>
[[nodiscard]] Rgb radiance_black_end(const Scene& scene, const Model& bsdf_at, const Ray& ray,
                                     int depth, Pcg32& random) {
  return depth == 0 ? Rgb(0.0f) : radiance_recursive(scene, bsdf_at, ray, depth - 1, random);
}
// [black-end]

}  // namespace lt::mistakes
