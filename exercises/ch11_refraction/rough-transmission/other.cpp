// The facet is found as the bisector that Snell's law asks for, in the plane of both directions;
// eval() is the weight of the sample that would lead there, times its density. Facets are drawn
// from a disk (Heitz 2018).
#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

namespace {

glm::dvec3 facet_seen(double alpha, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 view = glm::normalize(glm::dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  const double flat = std::hypot(view.x, view.y);
  const glm::dvec3 t1 = flat > 0.0 ? glm::dvec3(-view.y, view.x, 0.0) / flat : glm::dvec3(1, 0, 0);
  const glm::dvec3 t2 = glm::cross(view, t1);
  const double radius = std::sqrt(u.y);
  const double phi = 2.0 * std::numbers::pi * u.x;
  const double a = radius * std::cos(phi);
  const double half = 0.5 * (1.0 + view.z);
  const double b = (1.0 - half) * std::sqrt(1.0 - a * a) + half * radius * std::sin(phi);
  const glm::dvec3 n = a * t1 + b * t2 + std::sqrt(std::fmax(0.0, 1.0 - a * a - b * b)) * view;
  return glm::normalize(glm::dvec3(alpha * n.x, alpha * n.y, std::fmax(1e-12, n.z)));
}

double weight(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi, glm::dvec3 h) {
  const double eta = glass.n_here / glass.n_beyond;
  const double reflected = fresnel_dielectric(glm::dot(wo, h), glass.n_here, glass.n_beyond);
  return (1.0 - reflected) * eta * eta / (1.0 + glass.ggx.lambda(wi));
}

}  // namespace

glm::dvec3 transmission_half_vector(glm::dvec3 wo, glm::dvec3 wi, double n_here, double n_beyond) {
  const glm::dvec3 bent =
      n_beyond > n_here ? -wi - wo * (n_here / n_beyond) : wo + wi * (n_beyond / n_here);
  return glm::normalize(bent) * std::copysign(1.0, bent.z);
}

double eval(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  const double density = pdf(glass, wo, wi);
  if (density == 0.0) return 0.0;
  const glm::dvec3 h = transmission_half_vector(wo, wi, glass.n_here, glass.n_beyond);
  return weight(glass, wo, wi, h) * density / std::abs(wi.z);
}

double pdf(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  const glm::dvec3 sum = glass.n_here * wo + glass.n_beyond * wi;
  const glm::dvec3 h = transmission_half_vector(wo, wi, glass.n_here, glass.n_beyond);
  if (wi.z >= 0.0 || glm::dot(wo, h) <= 0.0 || glm::dot(wi, h) >= 0.0) return 0.0;
  const double squared = glm::dot(sum, sum);
  return VisibleNormals::pdf(glass.ggx, wo, h) * glass.n_beyond * glass.n_beyond *
         std::abs(glm::dot(wi, h)) / squared;
}

std::optional<BsdfSample> sample(const RoughGlass& glass, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 h = facet_seen(glass.ggx.alpha, wo, u);
  const auto wi = refracted(wo, h, glass.n_here / glass.n_beyond);
  if (!wi || wi->z >= 0.0) return {};
  return BsdfSample{*wi, weight(glass, wo, *wi, h), pdf(glass, wo, *wi)};
}

}  // namespace exercise
