#pragma once

#include <vector>

#include "refine/augmented_row.hpp"
#include "refine/spline.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// What must hold at one time of the motion: the tolerance box, the ranges of a joint waypoint,
/// clearances.
struct PointConstraint {
  enum class Kind { deviation, joint, clearance };
  struct Row {
    Kind kind = Kind::deviation;
    int index = 0;  ///< coordinate, joint or pair of the clearance model
    AugmentedRow bounds;
  };

  double time = 0;    ///< s
  double weight = 1;  ///< of mu: the share of the motion that the point stands for (F16)
  SplineBasis::Values basis;
  Pose frame = Pose::Identity();
  ToleranceBox tolerance;
  std::vector<Row> rows;

  bool has_pair(int pair) const;
};

/// Values c of the rows at a posture, and d c / d q.
struct PointValues {
  Eigen::VectorXd c;
  Eigen::MatrixXd jacobian;  ///< rows x joints
};

/// At a waypoint: the ranges of its joints where they are given, else its tolerance box.
PointConstraint constraint_at_waypoint(const Waypoint& waypoint, const SplineBasis& basis);

/// Between waypoints, on the stretch that ends at waypoint `interval` + 1: the box widened by
/// `share` of the task's between-tolerance, where a path is prescribed.
PointConstraint constraint_between(const Task& task, std::size_t interval, double time,
                                   double share, const SplineBasis& basis);

/// Adds rows distance >= required (m) for every pair that is nearer than required + band at q.
void add_near_pairs(PointConstraint& point, ClearanceChecker& checker, const JointVector& q,
                    double required, double band);

/// Evaluates the rows at q. A pair whose lower bound shows that its row gives no residual at `mu`
/// is not measured: its value is that bound and its gradient zero.
void evaluate(const PointConstraint& point, ClearanceChecker& checker, const JointVector& q,
              double mu, bool with_jacobian, PointValues& values);

}  // namespace wristwise
