/// @file
/// Light on its way through coloured glass.
#pragma once

#include <cmath>

#include "ch05_rendering_equation/radiance.hpp"

namespace lt {

// [transmittance]
/// Share of the light that is left after a straight way through a medium, for each colour (Bouguer
/// 1729, Lambert 1760, Beer 1852).
/// @param attenuation  1/m, >= 0
/// @param distance     metres, >= 0
/// @return 0 to 1
[[nodiscard]] inline Rgb transmittance(Rgb attenuation, float distance) {
  return exp(-attenuation * distance);
}
// [transmittance]

// [on-the-way]
/// The same for a ray's way to `surface`. Who meets a surface from inside has come through the
/// object; all else is air. So objects must be closed and must not overlap, and nothing may lie
/// inside coloured glass. An opaque object that is met from behind is a thin wall: nothing could
/// have come through it.
/// @param distance  of the way, metres
[[nodiscard]] inline Rgb transmittance_to(const Surface& surface, float distance) {
  if (surface.outside || is_opaque(surface.material)) return Rgb(1.0f);
  return transmittance(surface.material.attenuation, distance);
}
// [on-the-way]

// [radiance-through-media]
/// Chapter 5's recursion for air and clear objects: what arrives along `ray` has lost what the
/// medium takes on the way. Arguments as there.
/// @param depth  scattering events at most, >= 0
/// @return W / (m^2 sr)
template <Traceable Scene, Scattering Model>
[[nodiscard]] Rgb radiance_through_media(const Scene& scene, const Model& bsdf_at, const Ray& ray,
                                         int depth, Pcg32& random) {
  const auto hit = closest_hit(scene, ray);
  if (!hit) return background(scene, ray.direction);
  const Surface surface = surface_at(scene, ray, *hit);
  const Rgb left = transmittance_to(surface, hit->t);
  if (depth == 0) return left * emitted(surface);

  const vec3 u = random.next_vec3();
  const vec3 wo = -ray.direction;
  const auto sample = bsdf_at(surface).sample(surface.frame.to_local(wo), u);
  if (!sample) return left * emitted(surface);
  const auto next = next_ray(surface, wo, sample->wi);
  if (!next) return left * emitted(surface);
  const Rgb arriving = radiance_through_media(scene, bsdf_at, *next, depth - 1, random);
  return left * (emitted(surface) + sample->weight * arriving);
}
// [radiance-through-media]

}  // namespace lt
