#include "timing/highest_speed.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

constexpr double kPrecision = 1.02;
constexpr double kStep = 1.25;
constexpr int kMostSteps = 8;  // up, from the guess

}  // namespace

std::optional<double> least_working_factor(const std::function<bool(double)>& works, double guess) {
  double fails = 1, succeeds = guess;
  for (int step = 0; !works(succeeds); ++step) {
    if (step == kMostSteps) return std::nullopt;
    fails = succeeds;
    succeeds *= kStep;
  }
  while (succeeds > kPrecision * fails) {
    const double between = std::max(succeeds / kStep, std::sqrt(fails * succeeds));
    (works(between) ? succeeds : fails) = between;
  }
  return succeeds;
}

}  // namespace wristwise
