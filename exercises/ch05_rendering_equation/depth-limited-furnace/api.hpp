/// @file
/// Exercise 05.3: what you write and what you may call. Everything is in world coordinates here;
/// directions are unit and point away from the surface.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Red, green and blue of radiance, W / (m^2 sr), or of a factor.
using Rgb = glm::dvec3;

struct Ray {
  glm::dvec3 origin;     ///< metres
  glm::dvec3 direction;  ///< unit
};

/// A point that a ray has met.
struct Surface {
  glm::dvec3 position;  ///< metres
  Rgb emission;         ///< radiance that the surface itself sends out
  int object;           ///< whose surface it is
};

/// A direction that a surface proposes for the path's next step.
struct BsdfSample {
  glm::dvec3 wi;  ///< to where the light comes from
  Rgb weight;     ///< BSDF times cosine over density: what radiance from wi is multiplied by
};

/// Random numbers. next_vec3() gives three new ones in [0, 1) at each call.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] glm::dvec3 next_vec3();

 private:
  std::uint64_t state_;
};

// The checker has written these; call them.
class Scene;
/// What the ray meets first; nothing if it leaves the scene.
[[nodiscard]] std::optional<Surface> closest_hit(const Scene& scene, const Ray& ray);
/// Radiance from where nothing is.
[[nodiscard]] Rgb background(const Scene& scene, glm::dvec3 direction);
/// @param wo  to where the path has come from
/// @return nothing if all light is absorbed
[[nodiscard]] std::optional<BsdfSample> sample_bsdf(const Scene& scene, const Surface& surface,
                                                    glm::dvec3 wo, glm::dvec3 u);

/// One estimate of the radiance that arrives along `ray`, against its direction.
/// @param depth  scattering events at most, 0 or more; what lies deeper is left out
[[nodiscard]] Rgb radiance(const Scene& scene, const Ray& ray, int depth, Random& random);

}  // namespace exercise
