/// @file
/// Exercise 11.3: what you write and what you may call. Directions are unit, point away from the
/// surface and are given in its own frame, z along the normal on wo's side: wo.z is greater than 0.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// How the facets of a rough surface lean (chapter 8).
struct Ggx {
  double alpha;  ///< width, greater than 0

  /// Area of the facets that face `h`, 1/sr; 0 for facets that face down.
  [[nodiscard]] double d(glm::dvec3 h) const {
    if (!(h.z > 0.0)) return 0.0;
    const double a = alpha / (h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z);
    return a * a / std::numbers::pi;
  }
  /// Facet area that is hidden along `w`, from either side, for each unit that is seen.
  [[nodiscard]] double lambda(glm::dvec3 w) const {
    const double squared_tan = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * squared_tan) - 1.0);
  }
};

/// The share of facets between `wo` and `wi` that both of them see, on whichever side they are.
[[nodiscard]] inline double g2_separable(const Ggx& ggx, glm::dvec3 wo, glm::dvec3 wi) {
  return 1.0 / ((1.0 + ggx.lambda(wo)) * (1.0 + ggx.lambda(wi)));
}

/// Facets as often as `wo` sees them (chapter 9).
struct VisibleNormals {
  /// @return unit, z greater than 0, with dot(wo, h) greater than 0
  [[nodiscard]] static glm::dvec3 sample(const Ggx& ggx, glm::dvec3 wo, glm::dvec2 u) {
    const auto view = glm::normalize(glm::dvec3(ggx.alpha * wo.x, ggx.alpha * wo.y, wo.z));
    const double height = (1.0 - u.y) * (1.0 + view.z);
    const double radius = std::sqrt(std::fmax(0.0, 1.0 - (height - view.z) * (height - view.z)));
    const double phi = 2.0 * std::numbers::pi * u.x;
    const double x = radius * std::cos(phi) + view.x;
    const double y = radius * std::sin(phi) + view.y;
    return glm::normalize(glm::dvec3(ggx.alpha * x, ggx.alpha * y, height));
  }
  /// The density of sample() around `h`, 1/sr; 0 for facets that show wo their back.
  [[nodiscard]] static double pdf(const Ggx& ggx, glm::dvec3 wo, glm::dvec3 h) {
    const double cosine = glm::dot(wo, h);
    return cosine > 0.0 ? ggx.d(h) * cosine / (wo.z * (1.0 + ggx.lambda(wo))) : 0.0;
  }
};

/// Share of the light that a smooth surface reflects (chapter 7), 0 to 1.
/// @param cos_here  cosine of the angle to the normal on the side of n_here, 0 to 1
[[nodiscard]] inline double fresnel_dielectric(double cos_here, double n_here, double n_beyond) {
  const double sine = n_here / n_beyond * std::sqrt(std::fmax(0.0, 1.0 - cos_here * cos_here));
  if (sine >= 1.0) return 1.0;
  const double cos_beyond = std::sqrt(1.0 - sine * sine);
  const double s =
      (n_here * cos_here - n_beyond * cos_beyond) / (n_here * cos_here + n_beyond * cos_beyond);
  const double p =
      (n_beyond * cos_here - n_here * cos_beyond) / (n_beyond * cos_here + n_here * cos_beyond);
  return (s * s + p * p) / 2.0;
}

/// Where a ray goes on beyond (chapter 7); nothing where all light is reflected.
/// @param h    normal on the side of wo, dot(wo, h) greater than 0
/// @param eta  index on the side of wo / on the other side
[[nodiscard]] inline std::optional<glm::dvec3> refracted(glm::dvec3 wo, glm::dvec3 h, double eta) {
  const double cos_here = glm::dot(wo, h);
  const double squared_cos = 1.0 - eta * eta * (1.0 - cos_here * cos_here);
  if (squared_cos <= 0.0) return std::nullopt;
  return (eta * cos_here - std::sqrt(squared_cos)) * h - eta * wo;
}

/// A rough surface between two clear media, of which only what comes through counts here.
struct RoughGlass {
  Ggx ggx;
  double n_here;    ///< index of refraction on wo's side
  double n_beyond;  ///< on the other side; differs from n_here
};

struct BsdfSample {
  glm::dvec3 wi;
  double weight;  ///< BSDF times |cosine of wi| over pdf
  double pdf;     ///< 1/sr
};

/// The normal of the facets that bend light between `wo` and `wi`, on different sides.
/// @return unit, z greater than 0
[[nodiscard]] glm::dvec3 transmission_half_vector(glm::dvec3 wo, glm::dvec3 wi, double n_here,
                                                  double n_beyond);

/// The BSDF for radiance that comes from `wi` and goes to `wo`, without the cosine, 1/sr.
/// @return 0 unless wi is below and some facet bends light from it to wo
[[nodiscard]] double eval(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi);

/// The density with which sample() gives `wi`, 1/sr.
[[nodiscard]] double pdf(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi);

/// A direction below, by way of one of the facets that wo sees; nothing where none is found.
[[nodiscard]] std::optional<BsdfSample> sample(const RoughGlass& glass, glm::dvec3 wo,
                                               glm::dvec2 u);

}  // namespace exercise
