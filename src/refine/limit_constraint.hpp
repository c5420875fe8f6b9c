#pragma once

#include <vector>

#include "refine/augmented_row.hpp"
#include "refine/spline.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// Bounds on one control point of the spline's k-th derivative, all joints, as shares of the limit.
/// The derivative stays in the hull of its control points: what holds for all of these holds for
/// all t.
struct LimitConstraint {
  int derivative = 0;              ///< 0 position, 1 velocity, 2 acceleration, 3 jerk
  int first = 0;                   ///< index of the first control point
  std::vector<double> weights;     ///< of control points first, first + 1, ...
  std::vector<int> joints;         ///< those that have this limit
  std::vector<double> scale;       ///< for each of them, 1 / limit (1 for positions)
  std::vector<AugmentedRow> rows;  ///< for each of them

  /// The bounded quantity of the k-th of `joints`.
  double value(const Eigen::MatrixXd& control, std::size_t k) const;
};

/// The limits of every control point of the position and its first three derivatives, kept by a
/// small margin: 1e-6 rad or m of positions, 1e-3 of the limit of derivatives.
std::vector<LimitConstraint> limit_constraints(const Robot& robot, const SplineBasis& basis);

}  // namespace wristwise
