// As the equation reads: light of a surface is its own and, dimmed, that of the surface it sees.
#include "api.hpp"

namespace exercise {

Rgb radiance(const Scene& scene, const Ray& ray, int depth, Random& random) {
  const auto surface = closest_hit(scene, ray);
  if (!surface) return background(scene, ray.direction);
  if (depth == 0) return surface->emission;

  const auto sample = sample_bsdf(scene, *surface, -ray.direction, random.next_vec3());
  if (!sample) return surface->emission;
  // A hair away from the surface, as real scenes need it.
  const Ray next{surface->position + 1e-9 * sample->wi, sample->wi};
  return surface->emission + sample->weight * radiance(scene, next, depth - 1, random);
}

}  // namespace exercise
