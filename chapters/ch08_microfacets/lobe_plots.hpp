/// @file
/// Microfacet BRDFs as curves: the lobe around the mirror direction.
#pragma once

#include <algorithm>
#include <cstdio>

#include "ch08_microfacets/any_brdf.hpp"
#include "ch08_microfacets/polar_plot.hpp"

namespace lt {

inline constexpr float lobe_alphas[] = {0.1f, 0.2f, 0.4f, 0.7f, 1.0f};

/// The direction in the plane of x and z, degrees from straight up; negative is to the left.
[[nodiscard]] inline vec3 at_angle(double degrees) {
  const double angle = degrees * double{pi} / 180;
  return {std::sin(angle), 0.0, std::max(0.0, std::cos(angle))};
}

// [lobe]
/// f(wo, wi) cos(theta_i), how much light from wi counts, for all wi in the plane of wo and the
/// normal. Drawn so that its largest value touches the outer circle; the label has that value.
/// @param wo_degrees  wo, to the left of straight up
[[nodiscard]] inline PolarCurve lobe(const AnyBrdf& brdf, float alpha, double wo_degrees) {
  PolarCurve curve;
  double largest = 0;
  const vec3 wo = at_angle(-wo_degrees);
  for (int i = -180; i <= 180; ++i) {
    const double degrees = i / 2.0;
    const vec3 wi = at_angle(degrees);
    curve.angles.push_back(degrees);
    curve.radii.push_back(brdf(wo, wi).g * wi.z);
    largest = std::max(largest, curve.radii.back());
  }
  for (double& radius : curve.radii)
    radius /= largest;
  char label[60];
  const int decimals = largest < 1 ? 2 : largest < 10 ? 1 : 0;
  std::snprintf(label, sizeof label, "\u03b1 %.1f max\u00a0%.*f", alpha, decimals, largest);
  curve.label = label;
  return curve;
}
// [lobe]

/// Lobes of perfect mirrors of five widths.
/// @param wo_degrees  0 to 89
[[nodiscard]] inline PolarPlot lobe_plot(const BrdfOptions& options, double wo_degrees) {
  char words[60];
  std::snprintf(words, sizeof words, "Lobes of rough mirrors, seen from %.0f\u00b0", wo_degrees);
  PolarPlot plot;
  plot.title = words;
  plot.wo_degrees = wo_degrees;
  plot.note = "BRDF times cos \u03b8, each to its own scale; max in 1/sr";
  plot.description =
      wo_degrees == 0
          ? "Five lobes around the normal, from a needle for alpha 0.1 to a circle for alpha 1, "
            "which is nearly a matt surface's."
          : "Five lobes, seen from the left. The needle of alpha 0.1 points to the right, almost "
            "at the mirror angle. The wider a lobe is, the more it stands upright; for alpha 1 it "
            "is a broad oval, straight up, and hardly knows where one looks from.";
  for (const float alpha : lobe_alphas)
    plot.curves.push_back(
        lobe(brdf_named(options, Ggx{alpha}, PerfectMirror{}), alpha, wo_degrees));
  return plot;
}

}  // namespace lt
