#include "api.hpp"

#include <cmath>

namespace exercise {

Reflectance reflectance_dielectric(double /*cos_here*/, double /*n_here*/, double /*n_beyond*/) {
  TODO("find the cosine on the other side, where there is one, then both reflected shares");
}

double fresnel_dielectric(double /*cos_here*/, double /*n_here*/, double /*n_beyond*/) {
  TODO("make one share of the two");
}

}  // namespace exercise
