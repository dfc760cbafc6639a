#include "api.hpp"

namespace exercise {

double one_of_both(const Lobe& coat, const Lobe& base, double p, glm::dvec3 u) {
  const glm::dvec2 rest(u);
  // Who is asked in one of three cases only has to count three times.
  if (u.z < p) return coat(rest) / p;
  return base(rest) / (1.0 - p);
}

double coat_probability(double share, double tint) {
  // If both are asked in proportion to what they bring, each brings the same once it is divided.
  const double coat = share;
  const double base = (1.0 - share) * tint;
  if (coat + base <= 0.0) return 0.5;
  return coat / (coat + base);
}

}  // namespace exercise
