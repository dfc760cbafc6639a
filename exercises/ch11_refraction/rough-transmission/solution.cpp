#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

double square(double x) {
  return x * x;
}

/// The facets between two directions.
struct Bend {
  glm::dvec3 h;
  double cos_here;    ///< of wo to h, greater than 0
  double cos_beyond;  ///< of wi to h, as a positive number
  double sum;         ///< how long n_here wo + n_beyond wi is, up to its sign
};

std::optional<Bend> bend_between(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  if (wi.z >= 0.0) return std::nullopt;
  const glm::dvec3 h = transmission_half_vector(wo, wi, glass.n_here, glass.n_beyond);
  const double cos_here = glm::dot(wo, h);
  const double cos_beyond = -glm::dot(wi, h);
  // A facet bends light only from its back to its front.
  if (cos_here <= 0.0 || cos_beyond <= 0.0) return std::nullopt;
  return Bend{h, cos_here, cos_beyond, glass.n_here * cos_here - glass.n_beyond * cos_beyond};
}

}  // namespace

glm::dvec3 transmission_half_vector(glm::dvec3 wo, glm::dvec3 wi, double n_here, double n_beyond) {
  // By Snell's law the parts of n_here wo and n_beyond wi along the facet cancel: what is left of
  // their sum lies along its normal, and points into the medium with the smaller index.
  const glm::dvec3 h = glm::normalize(n_here * wo + n_beyond * wi);
  return h.z < 0.0 ? -h : h;
}

double eval(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  const auto bend = bend_between(glass, wo, wi);
  if (!bend) return 0.0;
  const double through = 1.0 - fresnel_dielectric(bend->cos_here, glass.n_here, glass.n_beyond);
  const double facets = glass.ggx.d(bend->h) * g2_separable(glass.ggx, wo, wi);
  // What light from wi finds of each facet, over what the surface is from both directions.
  const double cosines = bend->cos_here * bend->cos_beyond / (wo.z * -wi.z);
  // n_beyond^2 / sum^2 is the Jacobian's, and (n_here / n_beyond)^2 squeezes radiance.
  return through * facets * cosines * square(glass.n_here / bend->sum);
}

double pdf(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  const auto bend = bend_between(glass, wo, wi);
  if (!bend) return 0.0;
  // When the facet turns a little, wi turns by another angle: solid angles of both differ by this.
  const double jacobian = bend->cos_beyond * square(glass.n_beyond / bend->sum);
  return VisibleNormals::pdf(glass.ggx, wo, bend->h) * jacobian;
}

std::optional<BsdfSample> sample(const RoughGlass& glass, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 h = VisibleNormals::sample(glass.ggx, wo, u);
  const double eta = glass.n_here / glass.n_beyond;
  const auto wi = refracted(wo, h, eta);
  if (!wi) return std::nullopt;           // all is reflected at this facet
  if (wi->z >= 0.0) return std::nullopt;  // a steep facet bends it up again: this light is lost
  const double through = 1.0 - fresnel_dielectric(glm::dot(wo, h), glass.n_here, glass.n_beyond);
  // That wo sees the facet is in its density: only what hides it from wi is left, G2 / G1.
  const double seen = g2_separable(glass.ggx, wo, *wi) * (1.0 + glass.ggx.lambda(wo));
  return BsdfSample{*wi, through * square(eta) * seen, pdf(glass, wo, *wi)};
}

}  // namespace exercise
