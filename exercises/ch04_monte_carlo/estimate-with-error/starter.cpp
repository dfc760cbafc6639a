#include "api.hpp"

#include <cmath>

namespace exercise {

void RunningMean::add(double /*value*/) {
  TODO("update count_, mean_ and spread_");
}

double RunningMean::mean() const {
  TODO("return the mean");
}

double RunningMean::variance() const {
  TODO("turn spread_ into a variance");
}

double RunningMean::standard_error() const {
  TODO("say how far off the mean may be");
}

RunningMean estimate_uniform(const std::function<double(double)>& /*f*/, double /*a*/, double /*b*/,
                             int /*n*/, const std::function<double()>& /*random*/) {
  TODO("add n random values whose mean is the integral");
}

}  // namespace exercise
