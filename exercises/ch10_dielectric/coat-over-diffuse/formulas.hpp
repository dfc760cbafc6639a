/// @file
/// What the checker of exercise 10.1 compares with: the formulas, and what people make of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "api.hpp"

namespace exercise {

inline const double pi = std::acos(-1.0);

inline const CoatedBase red{0.75, 0.4, 1.5};

// All that formulas are made of: coat and base as BSDFs and as densities, p for the coat.
struct Parts {
  double coat, base, coat_pdf, base_pdf, p, in, out, at_facet, mo, mi;
};
inline Parts parts_of(glm::dvec3 wo, glm::dvec3 wi) {
  const double facet = fresnel(red, std::min(1.0, dot(wo, normalize(wo + wi))));
  return {coat_eval(red, wo, wi),
          red.tint / pi,
          coat_pdf(red, wo, wi),
          wi.z / pi,
          coat_probability(red, wo),
          1 - fresnel(red, wi.z),
          1 - fresnel(red, wo.z),
          1 - facet,
          wo.z,
          wi.z};
}
using P = const Parts&;
inline double right_eval(P p) {
  return p.coat + p.base * p.in * p.out;
}
inline double right_pdf(P p) {
  return p.p * p.coat_pdf + (1 - p.p) * p.base_pdf;
}
inline double right_weight(P p) {
  return right_eval(p) * p.mi / right_pdf(p);
}

using Formula = double (*)(P p);
using Mistakes = std::vector<std::pair<const char*, Formula>>;
inline const Mistakes eval_mistakes{
    {"base-not-attenuated", [](P p) { return p.coat + p.base; }},
    {"attenuated-once", [](P p) { return p.coat + p.base * p.in; }},
    {"attenuated-once", [](P p) { return p.coat + p.base * p.out; }},
    {"fresnel-at-facet", [](P p) { return p.coat + p.base * p.at_facet * p.at_facet; }},
    {"reflected-for-rest", [](P p) { return p.coat + p.base * (1 - p.in) * (1 - p.out); }},
    {"pi-forgotten", [](P p) { return p.coat + pi * p.base * p.in * p.out; }},
    {"coat-forgotten", [](P p) { return p.base * p.in * p.out; }},
    {"coat-fresnel-twice", [](P p) { return p.coat * (1 - p.out) + p.base * p.in * p.out; }},
    {"coat-tinted", [](P p) { return p.coat * red.tint + p.base * p.in * p.out; }},
    {"cosine-included", [](P p) { return right_eval(p) * p.mi; }},
};
inline const Mistakes pdf_mistakes{
    {"probabilities-swapped", [](P p) { return (1 - p.p) * p.coat_pdf + p.p * p.base_pdf; }},
    {"equal-probabilities", [](P p) { return (p.coat_pdf + p.base_pdf) / 2; }},
    {"densities-added", [](P p) { return p.coat_pdf + p.base_pdf; }},
};
inline const Mistakes weight_mistakes{
    {"weight-without-cosine", [](P p) { return right_weight(p) / p.mi; }},
    {"weight-with-cosine-of-wo", [](P p) { return right_weight(p) * p.mo / p.mi; }},
    {"weight-not-divided", [](P p) { return right_weight(p) * right_pdf(p); }},
};

}  // namespace exercise
