#pragma once

#include <Eigen/Core>
#include <vector>

#include "wristwise/joints.hpp"

namespace wristwise {

/// The configurations of one waypoint, one a row, with the cost of standing there.
/// The graph knows no robot.
struct Rung {
  Eigen::ArrayXXd positions;  ///< configurations x joints
  Eigen::ArrayXd cost;        ///< infinite: not to be used
  JointVector lower, upper;   ///< where its copies must lie; empty: between the joint limits

  Eigen::Index size() const { return positions.rows(); }
  JointVector vertex(Eigen::Index index) const { return positions.row(index).transpose(); }
};

/// Some configurations of each rung, by index, increasing.
using Corridor = std::vector<std::vector<Eigen::Index>>;

}  // namespace wristwise
