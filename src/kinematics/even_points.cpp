#include "kinematics/even_points.hpp"

#include <cmath>

namespace wristwise {

EvenPoints::EvenPoints(int dimensions) {
  double root = 1.5;
  for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1.0 / (dimensions + 1));
  for (int k = 0; k < dimensions; ++k)
    steps_.push_back((steps_.empty() ? 1 : steps_.back()) / root);
}

double EvenPoints::at(int index, int dimension) const {
  const double place = 0.5 + steps_[static_cast<std::size_t>(dimension)] * (index + 1);
  return place - std::floor(place);
}

}  // namespace wristwise
