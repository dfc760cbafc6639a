// The toy exercise of the runner's own tests.
#pragma once

#include "common/testkit/not_written.hpp"

namespace exercise {

double halve(double x);

}  // namespace exercise
