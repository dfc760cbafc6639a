#include "api.hpp"

namespace exercise {

double halve(double x) {
  return x / 2;
}

}  // namespace exercise
