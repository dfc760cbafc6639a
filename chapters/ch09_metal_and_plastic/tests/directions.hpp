// What every BSDF with a density is asked.
#pragma once

#include <optional>
#include <string>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/bsdf.hpp"
#include "common/testkit/sampler_test.hpp"

namespace lt::testing {

/// Do its directions follow its density? Chi-square over bins that are finer around the poles.
/// @return what is wrong; empty if nothing is
template <class AnyBsdf>
std::string complaint_about_directions(const AnyBsdf& bsdf, vec3 wo, int samples) {
  Pcg32 random(1);
  const auto draw = [&]() -> std::optional<vec3> {
    const auto sample = bsdf.sample(wo, random.next_vec3());
    return sample ? std::optional(sample->wi) : std::nullopt;
  };
  const auto pdf = [&](vec3 wi) { return double{bsdf.pdf(wo, wi)}; };
  const DirectionBins bins(24, 32, RowSpacing::equal_angle);
  return test_sampler(draw, pdf, {samples, bins}).complaint;
}

/// Share of the samples that lead somewhere.
template <class AnyBsdf>
RunningMean accepted(const AnyBsdf& bsdf, vec3 wo, int count) {
  Pcg32 random(2);
  RunningMean mean;
  for (int i = 0; i < count; ++i)
    mean.add(bsdf.sample(wo, random.next_vec3()).has_value());
  return mean;
}

}  // namespace lt::testing
