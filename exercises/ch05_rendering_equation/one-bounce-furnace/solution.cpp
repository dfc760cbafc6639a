#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

const double pi = std::acos(-1.0);

}  // namespace

double lambert(double albedo, glm::dvec3 wo, glm::dvec3 wi) {
  if (wo.z * wi.z <= 0.0) return 0.0;  // no light comes through
  // The cosine sums to pi over the hemisphere: divided by it, the surface gives back its albedo.
  return albedo / pi;
}

double reflected(double albedo, glm::dvec3 wo, const Sampler& sampler, const Sky& sky,
                 std::span<const glm::dvec2> us) {
  double sum = 0.0;
  for (const glm::dvec2 u : us) {
    const auto [wi, pdf] = sampler(u);
    // Light that comes in flat is spread over more of the surface.
    const double cosine = std::abs(wi.z);
    // A direction that is chosen often must count less each time.
    sum += lambert(albedo, wo, wi) * sky(wi) * cosine / pdf;
  }
  // A direction below the horizon adds 0 and is counted: it was chosen.
  return sum / static_cast<double>(us.size());
}

}  // namespace exercise
