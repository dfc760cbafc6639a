// The base's probability comes first; the lobe and its probability are chosen together.
#include "api.hpp"

namespace exercise {

double one_of_both(const Lobe& coat, const Lobe& base, double p, glm::dvec3 u) {
  const bool is_base = u.z >= p;
  const Lobe& chosen = is_base ? base : coat;
  const double weight = 1.0 / (is_base ? 1.0 - p : p);
  return weight * chosen({u.x, u.y});
}

double coat_probability(double share, double tint) {
  const double all = share + tint - share * tint;
  return all > 0.0 ? 1.0 - tint * (1.0 - share) / all : 0.0;
}

}  // namespace exercise
