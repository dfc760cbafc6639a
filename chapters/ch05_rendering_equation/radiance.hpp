/// @file
/// The rendering equation, estimated as it reads.
#pragma once

#include <optional>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/bsdf.hpp"
#include "ch05_rendering_equation/traceable.hpp"

namespace lt {

/// What happens at a surface: a function from a Surface to a Bsdf.
template <class T>
concept Scattering = requires(const T& bsdf_at, const Surface& surface) {
  { bsdf_at(surface) } -> Bsdf;
};

// [next-ray]
/// The path's next ray, or nothing where `wi` lies on one side of the shading normal and on the
/// other side of the true surface: bumps of a normal map must not let light through a wall.
/// @param wo  to the previous vertex, unit, world
/// @param wi  to the next one, unit, local frame
[[nodiscard]] inline std::optional<Ray> next_ray(const Surface& surface, vec3 wo, vec3 wi) {
  const vec3 direction = surface.frame.to_world(wi);
  const vec3 normal = surface.point.normal;
  const bool is_reflected = wi.z > 0.0f;
  const bool stays_outside = dot(direction, normal) * dot(wo, normal) > 0.0f;
  if (is_reflected != stays_outside) return std::nullopt;
  return leave(surface.point, direction);
}
// [next-ray]

// [emitted]
/// Radiance that the surface itself sends back along the ray: from its outer side only.
[[nodiscard]] inline Rgb emitted(const Surface& surface) {
  return surface.outside ? surface.material.emission : Rgb(0.0f);
}
// [emitted]

// [radiance]
/// One estimate of the radiance that arrives along `ray`, against its direction:
/// L = L_e + f cos L_i / pdf, and L_i in the same way. Kajiya 1986; thesis eq. 1 and 12.
/// @param bsdf_at  what happens at a surface
/// @param depth    scattering events at most, >= 0; what lies deeper is left out
/// @return W / (m^2 sr)
template <Traceable Scene, Scattering Model>
[[nodiscard]] Rgb radiance_recursive(const Scene& scene, const Model& bsdf_at, const Ray& ray,
                                     int depth, Pcg32& random) {
  const auto hit = closest_hit(scene, ray);
  if (!hit) return background(scene, ray.direction);
  const Surface surface = surface_at(scene, ray, *hit);
  if (depth == 0) return emitted(surface);

  const vec3 u = random.next_vec3();
  const vec3 wo = -ray.direction;
  const auto sample = bsdf_at(surface).sample(surface.frame.to_local(wo), u);
  if (!sample) return emitted(surface);
  const auto next = next_ray(surface, wo, sample->wi);
  if (!next) return emitted(surface);
  return emitted(surface) +
         sample->weight * radiance_recursive(scene, bsdf_at, *next, depth - 1, random);
}
// [radiance]

}  // namespace lt
