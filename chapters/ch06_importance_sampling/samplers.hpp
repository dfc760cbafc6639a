/// @file
/// Samplers by name, each with the density that it claims, and their chi-square.
#pragma once

#include <string>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch06_importance_sampling/mistakes.hpp"
#include "common/testkit/sampler_test.hpp"

namespace lt {

/// A sampler of the upper hemisphere, and what it says of itself.
struct NamedSampler {
  std::string name;
  vec3 (*sample)(vec2 u);
  float (*pdf)(vec3 direction);
};

[[nodiscard]] inline float pdf_of_uniform(vec3 direction) {
  return direction.z > 0.0f ? uniform_hemisphere_pdf : 0.0f;
}
[[nodiscard]] inline float pdf_of_cosine(vec3 direction) {
  return cosine_hemisphere_pdf(direction.z);
}

/// @param name   uniform or cosine
/// @param wrong  none; density or both: the cosine's directions with the uniform density; root: the
///               square root left out
[[nodiscard]] inline NamedSampler sampler_named(const std::string& name, const std::string& wrong) {
  if (wrong == "root") return {"no root", mistakes::cosine_hemisphere_without_root, pdf_of_cosine};
  if (wrong == "density" || wrong == "both")
    return {"cosine, says uniform", cosine_hemisphere, pdf_of_uniform};
  if (name == "uniform") return {"uniform", uniform_hemisphere, pdf_of_uniform};
  return {"cosine", cosine_hemisphere, pdf_of_cosine};
}

// [sampler-chi-square]
/// Chi-square of a sampler's directions against its density.
/// @param samples  how many directions to draw
[[nodiscard]] inline SamplerReport report_on(const NamedSampler& sampler, int samples,
                                             const DirectionBins& bins, Pcg32& random) {
  const auto draw = [&] { return std::optional(sampler.sample(random.next_vec2())); };
  return test_sampler(draw, sampler.pdf, {samples, bins});
}
// [sampler-chi-square]

}  // namespace lt
