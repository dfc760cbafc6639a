/// @file
/// What the checker of exercise 11.3 compares with: the formulas, and what people make of them.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "api.hpp"

namespace exercise {

inline double square(double x) {
  return x * x;
}

// Walter and others 2007, eq. 16.
inline glm::dvec3 right_h(glm::dvec3 wo, glm::dvec3 wi, double n_here, double n_beyond) {
  const glm::dvec3 h = normalize(-(n_here * wo + n_beyond * wi));
  return h.z < 0 ? -h : h;
}

// All that formulas are made of. Cosines to h (co, ci) and to the normal (mo, mi) are
// positive here.
struct Parts {
  double nh, nb, co, ci, mo, mi, d, g1, g2, through, through_flat;
  double sum = std::abs(nh * co - nb * ci);
};
inline std::optional<Parts> parts_of(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  const double nh = glass.n_here, nb = glass.n_beyond;
  const glm::dvec3 h = right_h(wo, wi, nh, nb);
  if (wi.z >= 0 || dot(wo, h) <= 0 || dot(wi, h) >= 0) return std::nullopt;
  Parts p{nh, nb, dot(wo, h), -dot(wi, h), wo.z, -wi.z, glass.ggx.d(h), 0, 0, 0, 0};
  p.g1 = 1 / (1 + glass.ggx.lambda(wo));
  p.g2 = p.g1 / (1 + glass.ggx.lambda(wi));
  p.through = 1 - fresnel_dielectric(p.co, nh, nb);
  p.through_flat = 1 - fresnel_dielectric(p.mo, nh, nb);
  return p;
}
using P = const Parts&;

// Walter and others: eq. 21, for radiance; eq. 17; their quotient.
inline double right_eval(P p) {
  return p.co * p.ci / (p.mo * p.mi) * square(p.nh / p.sum) * p.through * p.d * p.g2;
}
inline double facet_pdf(P p) {
  return p.g1 * p.co * p.d / p.mo;
}
inline double right_pdf(P p) {
  return facet_pdf(p) * p.ci * square(p.nb / p.sum);
}
inline double right_weight(P p) {
  return p.through * square(p.nh / p.nb) * p.g2 / p.g1;
}
// Of the cosines' sizes, as if both were positive.
inline double wrong_sum(P p) {
  return square(p.sum / (p.nh * p.co + p.nb * p.ci));
}

using Formula = double (*)(P p);
using Mistakes = std::vector<std::pair<const char*, Formula>>;
inline const Mistakes eval_mistakes{
    {"reflection-denominator", [](P p) { return p.through * p.d * p.g2 / (4 * p.mo * p.mi); }},
    {"fresnel-not-subtracted", [](P p) { return right_eval(p) / p.through * (1 - p.through); }},
    {"fresnel-twice", [](P p) { return right_eval(p) * (1 - p.through); }},
    {"fresnel-at-normal", [](P p) { return right_eval(p) / p.through * p.through_flat; }},
    {"importance-for-radiance", [](P p) { return right_eval(p) * square(p.nb / p.nh); }},
    {"sum-not-squared", [](P p) { return right_eval(p) * p.sum; }},
    {"sum-of-sizes", [](P p) { return right_eval(p) * wrong_sum(p); }},
    {"cosines-forgotten", [](P p) { return right_eval(p) * p.mo * p.mi; }},
    {"cosine-included", [](P p) { return right_eval(p) * p.mi; }},
    {"facet-cosines-forgotten", [](P p) { return right_eval(p) / (p.co * p.ci); }},
};
inline const Mistakes pdf_mistakes{
    {"reflection-jacobian", [](P p) { return facet_pdf(p) / (4 * p.co); }},
    {"jacobian-forgotten", facet_pdf},
    {"jacobian-index", [](P p) { return right_pdf(p) * square(p.nh / p.nb); }},
    {"jacobian-cosine", [](P p) { return right_pdf(p) * p.co / p.ci; }},
    {"jacobian-not-squared", [](P p) { return right_pdf(p) * p.sum; }},
    {"jacobian-of-sizes", [](P p) { return right_pdf(p) * wrong_sum(p); }},
    {"pdf-with-fresnel", [](P p) { return right_pdf(p) * p.through; }},
};
inline const Mistakes weight_mistakes{
    {"weight-unscaled", [](P p) { return right_weight(p) * square(p.nb / p.nh); }},
    {"weight-without-fresnel", [](P p) { return right_weight(p) / p.through; }},
    {"weight-without-cosine", [](P p) { return right_weight(p) / p.mi; }},
    {"weight-masked-twice", [](P p) { return right_weight(p) * p.g1; }},
};

}  // namespace exercise
