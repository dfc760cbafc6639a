#include "api.hpp"

namespace exercise {

double halve(double x) {
  return 0.5 * x;
}

}  // namespace exercise
