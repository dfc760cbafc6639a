// The mean is kept up to date with each direction, albedo and pi come in at the end, and the sky is
// not asked where its light cannot come from.
#include "api.hpp"

#include <numbers>

namespace exercise {

double lambert(double albedo, glm::dvec3 wo, glm::dvec3 wi) {
  const bool is_above = wo.z > 0.0 && wi.z > 0.0;
  const bool is_below = wo.z < 0.0 && wi.z < 0.0;
  return is_above || is_below ? albedo * std::numbers::inv_pi : 0.0;
}

double reflected(double albedo, glm::dvec3 /*wo*/, const Sampler& sampler, const Sky& sky,
                 std::span<const glm::dvec2> us) {
  double irradiance = 0.0;
  double count = 0.0;
  for (auto u = us.rbegin(); u != us.rend(); ++u) {
    const DirectionSample sample = sampler(*u);
    double estimate = 0.0;
    if (sample.wi.z > 0.0) estimate = sky(sample.wi) * (sample.wi.z / sample.pdf);
    count += 1.0;
    irradiance += (estimate - irradiance) / count;
  }
  return irradiance * albedo * std::numbers::inv_pi;
}

}  // namespace exercise
