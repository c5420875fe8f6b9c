#include "refine/point_constraint.hpp"

#include <algorithm>

namespace wristwise {

namespace {

using Kind = PointConstraint::Kind;

constexpr double kRangeMargin = 1e-6;  // rad or m

void add_box_rows(PointConstraint& point) {
  for (int k = 0; k < 6; ++k) {
    if (point.tolerance.is_free(k)) continue;
    point.rows.push_back(
        {Kind::deviation, k, {point.tolerance.lower[k], point.tolerance.upper[k], 0}});
  }
}

/// A joint is kept inside its range by a margin, as with joint limits (F16). A range that has no
/// room for that is its middle.
AugmentedRow joint_bounds(double lower, double upper, double nominal) {
  if (upper - lower <= 2 * kRangeMargin) return {nominal, nominal, 0};
  return {lower + kRangeMargin, upper - kRangeMargin, 0};
}

void add_joint_rows(const JointBox& box, PointConstraint& point) {
  const JointVector nominal = box.nominal();
  for (int j = 0; j < nominal.size(); ++j) {
    point.rows.push_back({Kind::joint, j, joint_bounds(box.lower[j], box.upper[j], nominal[j])});
  }
}

}  // namespace

bool PointConstraint::has_pair(int pair) const {
  return std::any_of(rows.begin(), rows.end(), [pair](const Row& row) {
    return row.kind == Kind::clearance && row.index == pair;
  });
}

PointConstraint constraint_at_waypoint(const Waypoint& waypoint, const SplineBasis& basis) {
  PointConstraint point;
  point.time = waypoint.time;
  point.basis = basis.at(waypoint.time);
  point.frame = waypoint.frame;
  point.tolerance = waypoint.tolerance;
  if (waypoint.joints) {
    add_joint_rows(*waypoint.joints, point);
  } else {
    add_box_rows(point);
  }
  return point;
}

PointConstraint constraint_between(const Task& task, std::size_t interval, double time,
                                   double share, const SplineBasis& basis) {
  PointConstraint point;
  point.time = time;
  point.basis = basis.at(time);
  if (const auto box = task.tolerance_between(interval)) {
    point.frame = task.seam.frame_at(time);
    point.tolerance = box->widened(share * task.between_position, share * task.between_angle);
    add_box_rows(point);
  }
  return point;
}

void add_near_pairs(PointConstraint& point, ClearanceChecker& checker, const JointVector& q,
                    double required, double band) {
  checker.set_posture(q);
  for (int pair = 0; pair < static_cast<int>(checker.model().pairs().size()); ++pair) {
    if (checker.lower_bound(pair) >= required + band || point.has_pair(pair)) continue;
    if (checker.distance(pair).distance >= required + band) continue;
    point.rows.push_back({Kind::clearance, pair, {required, ToleranceBox::kFree, 0}});
  }
}

void evaluate(const PointConstraint& point, ClearanceChecker& checker, const JointVector& q,
              double mu, bool with_jacobian, PointValues& values) {
  const Robot& robot = checker.model().robot();
  checker.set_posture(q);
  const bool has_box = !point.rows.empty() && point.rows.front().kind == Kind::deviation;
  Vector6 e = Vector6::Zero();
  Jacobian e_jacobian(6, q.size());
  if (has_box) {
    const ChainPose& chain = checker.chain();
    e = deviation(point.tolerance, point.frame, chain.tcp);
    if (with_jacobian) {
      e_jacobian = deviation_jacobian(point.tolerance, point.frame, chain.tcp,
                                      geometric_jacobian(robot, chain));
    }
  }
  const auto count = static_cast<Eigen::Index>(point.rows.size());
  values.c.resize(count);
  if (with_jacobian) values.jacobian.setZero(count, q.size());
  for (Eigen::Index r = 0; r < count; ++r) {
    const PointConstraint::Row& row = point.rows[static_cast<std::size_t>(r)];
    switch (row.kind) {
      case Kind::deviation:
        values.c[r] = e[row.index];
        if (with_jacobian) values.jacobian.row(r) = e_jacobian.row(row.index);
        break;
      case Kind::joint:
        values.c[r] = q[row.index];
        if (with_jacobian) values.jacobian(r, row.index) = 1;
        break;
      case Kind::clearance: {
        values.c[r] = checker.lower_bound(row.index);
        if (row.bounds.is_slack_above(values.c[r], mu)) break;
        const PairDistance measured = checker.distance(row.index);
        values.c[r] = measured.distance;
        if (with_jacobian) values.jacobian.row(r) = checker.gradient(measured).transpose();
        break;
      }
    }
  }
}

}  // namespace wristwise
