#include <gtest/gtest.h>

#include <map>
#include <random>

#include "gantry.hpp"
#include "refine/breakpoints.hpp"
#include "refine/dip_search.hpp"
#include "refine/limit_constraint.hpp"
#include "refine/point_constraint.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using Kind = PointConstraint::Kind;
using gantry::posture;

Robot limited_gantry() {
  Robot::Parts parts = gantry::parts();
  for (std::size_t j = 0; j < 4; ++j) {
    const double factor = 1 + static_cast<double>(j);
    parts.joints[j].lower = -0.5 * factor;
    parts.joints[j].upper = 0.8 * factor;
    parts.joints[j].max_velocity = 0.5 * factor;
    parts.joints[j].max_acceleration = 2 * factor;
    parts.joints[j].max_jerk = 10 * factor;
  }
  return Robot(parts);
}

Spline random_spline(unsigned seed, double size) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Spline spline{SplineBasis({0, 0.4, 1, 1.7, 2, 3}), {}};
  spline.control = Eigen::MatrixXd::NullaryExpr(4, spline.basis.control_count(),
                                                [&] { return size * normal(random); });
  return spline;
}

double limit_of(const Joint& joint, int derivative) {
  if (derivative == 1) return joint.max_velocity;
  return derivative == 2 ? joint.max_acceleration : joint.max_jerk;
}

TEST(LimitConstraints, HoldTheTrueDerivativesInTheHullOfTheirValues) {
  const Robot robot = limited_gantry();
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Spline spline = random_spline(seed, 1);
    Eigen::ArrayXXd least = Eigen::ArrayXXd::Constant(4, 4, INFINITY), largest = -least;
    for (const LimitConstraint& limit : limit_constraints(robot, spline.basis)) {
      ASSERT_EQ(limit.joints.size(), 4U);
      for (std::size_t k = 0; k < 4; ++k) {
        const double value = limit.value(spline.control, k);
        double& low = least(limit.derivative, limit.joints[k]);
        double& high = largest(limit.derivative, limit.joints[k]);
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    for (double t = 0; t <= 3; t += 0.01) {
      for (int k = 0; k <= 3; ++k) {
        JointVector share = spline.evaluate(t, k);
        for (int j = 0; j < 4 && k > 0; ++j) {
          share[j] /= limit_of(robot.joints()[static_cast<std::size_t>(j)], k);
        }
        EXPECT_TRUE((share.array() >= least.row(k).transpose() - 1e-9).all());
        EXPECT_TRUE((share.array() <= largest.row(k).transpose() + 1e-9).all());
      }
    }
  }
}

/// The end control points of every derivative are the derivative at the ends.
TEST(LimitConstraints, TheFirstAndTheLastAreTheEndsOfTheMotion) {
  const Robot robot = limited_gantry();
  const Spline spline = random_spline(3, 1);
  int seen = 0;
  for (const LimitConstraint& limit : limit_constraints(robot, spline.basis)) {
    const int last = spline.basis.control_count() - limit.derivative - 1;
    if (limit.first != 0 && limit.first != last) continue;
    ++seen;
    const JointVector end = spline.evaluate(limit.first == 0 ? 0 : 3, limit.derivative);
    for (int j = 0; j < 4; ++j) {
      const double unit =
          limit.derivative == 0
              ? 1
              : limit_of(robot.joints()[static_cast<std::size_t>(j)], limit.derivative);
      EXPECT_NEAR(limit.value(spline.control, static_cast<std::size_t>(j)), end[j] / unit, 1e-9);
    }
  }
  EXPECT_EQ(seen, 8);
}

TEST(LimitConstraints, KeepASmallMargin) {
  const Robot robot = limited_gantry();
  for (const LimitConstraint& limit : limit_constraints(robot, SplineBasis({0, 1, 2}))) {
    for (std::size_t k = 0; k < limit.rows.size(); ++k) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(limit.joints[k])];
      const double lower = limit.derivative == 0 ? joint.lower : -1;
      const double upper = limit.derivative == 0 ? joint.upper : 1;
      const double margin = limit.derivative == 0 ? 1e-6 : 1e-3;
      EXPECT_NEAR(limit.rows[k].lower, lower + margin, 1e-12);
      EXPECT_NEAR(limit.rows[k].upper, upper - margin, 1e-12);
    }
  }
}

TEST(LimitConstraints, LeaveOutWhatIsUnlimited) {
  Robot::Parts parts = gantry::parts();
  parts.joints[3].type = JointType::continuous;
  parts.joints[3].lower = -gantry::kUnlimited;
  parts.joints[3].upper = gantry::kUnlimited;
  parts.joints[1].max_acceleration = 4;
  const SplineBasis basis({0, 1, 2});
  int accelerations = 0;
  for (const LimitConstraint& limit : limit_constraints(Robot(parts), basis)) {
    EXPECT_TRUE(limit.derivative == 0 || limit.derivative == 2);
    if (limit.derivative == 0) {
      EXPECT_EQ(limit.joints, (std::vector<int>{0, 1, 2}));
      continue;
    }
    ++accelerations;
    EXPECT_EQ(limit.joints, std::vector<int>{1});
    EXPECT_DOUBLE_EQ(limit.scale[0], 0.25);
  }
  EXPECT_EQ(accelerations, basis.control_count() - 2);
}

TEST(LimitConstraints, OfAJointThatIsHeldStayInOrder) {
  Robot::Parts parts = gantry::parts();
  parts.joints[0].lower = parts.joints[0].upper = 0.3;
  for (const LimitConstraint& limit : limit_constraints(Robot(parts), SplineBasis({0, 1}))) {
    EXPECT_LE(limit.rows[0].lower, limit.rows[0].upper);
    EXPECT_EQ(limit.rows[0].violation(0.3), 0);
  }
}

TEST(PointConstraint, RowsOfABoxAreItsBoundedCoordinates) {
  Waypoint waypoint;
  waypoint.time = 0.3;
  waypoint.tolerance = gantry::box(0.01, 0.2);
  waypoint.tolerance.lower[5] = -gantry::kUnlimited;
  waypoint.tolerance.upper[5] = gantry::kUnlimited;
  waypoint.tolerance.lower[1] = waypoint.tolerance.upper[1] = 0;
  const SplineBasis basis({0, 1});
  const PointConstraint point = constraint_at_waypoint(waypoint, basis);
  ASSERT_EQ(point.rows.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    const auto& row = point.rows[static_cast<std::size_t>(k)];
    EXPECT_EQ(row.kind, Kind::deviation);
    EXPECT_EQ(row.index, k);
    EXPECT_EQ(row.bounds.lower, waypoint.tolerance.lower[k]);
    EXPECT_EQ(row.bounds.upper, waypoint.tolerance.upper[k]);
  }
  EXPECT_EQ(point.basis.derivatives, basis.at(0.3).derivatives);
}

/// Ranges hold with 1e-6 in hand; one that is too narrow for that is its middle.
TEST(PointConstraint, RowsOfAJointWaypointAreItsRanges) {
  Waypoint waypoint;
  waypoint.joints =
      JointBox(gantry::posture(0.1, 0.2, -1, 0.5), gantry::posture(0.1, 0.3, 1, 0.5 + 1e-6));
  const PointConstraint point = constraint_at_waypoint(waypoint, SplineBasis({0, 1}));
  ASSERT_EQ(point.rows.size(), 4U);
  const std::vector<std::pair<double, double>> expected = {
      {0.1, 0.1}, {0.2 + 1e-6, 0.3 - 1e-6}, {-1 + 1e-6, 1 - 1e-6}, {0.5 + 5e-7, 0.5 + 5e-7}};
  for (std::size_t j = 0; j < 4; ++j) {
    const PointConstraint::Row& row = point.rows[j];
    EXPECT_EQ(row.kind, Kind::joint);
    EXPECT_EQ(row.index, static_cast<int>(j));
    EXPECT_NEAR(row.bounds.lower, expected[j].first, 1e-15);
    EXPECT_NEAR(row.bounds.upper, expected[j].second, 1e-15);
    EXPECT_LE(row.bounds.lower, row.bounds.upper);
  }
}

TEST(PointConstraint, ValuesOfTheGantryAreItsOffsets) {
  const auto robot = gantry::robot();
  ClearanceChecker checker(
      gantry::clearance(robot, {gantry::obstacle(Sphere{0.1}, 1, 0, 0)}, 0.02));
  Waypoint waypoint;
  waypoint.frame.translation() << 0.5, 0.1, 0;
  waypoint.tolerance = gantry::box(0.01, 0.2);
  PointConstraint point = constraint_at_waypoint(waypoint, SplineBasis({0, 1}));
  const JointVector q = posture(0.8, 0.2, 0.3, 0.4);
  add_near_pairs(point, checker, q, 0.02, 1);
  ASSERT_EQ(point.rows.size(), 7U);
  EXPECT_TRUE(point.has_pair(0));
  EXPECT_FALSE(point.has_pair(1));
  point.rows[6].bounds.lower = 1;  // near enough to be measured
  PointValues values;
  evaluate(point, checker, q, 1, true, values);
  const double centres = std::sqrt(0.04 + 0.04 + 0.09);
  Eigen::VectorXd expected(7);
  expected << 0.3, 0.1, 0.3, 0.4, 0, 0, centres - 0.15;
  EXPECT_LT((values.c - expected).norm(), 1e-9);
  EXPECT_NEAR(values.jacobian(6, 0), -0.2 / centres, 1e-9);
  EXPECT_NEAR(values.jacobian(6, 2), 0.3 / centres, 1e-9);
}

TEST(PointConstraint, NearPairsAreAddedOnceAndFarOnesNever) {
  const auto robot = gantry::robot();
  SceneObject far_away = gantry::obstacle(Sphere{0.1}, 0, 1.9, 0);
  far_away.name = "far away";
  ClearanceChecker checker(
      gantry::clearance(robot, {gantry::obstacle(Sphere{0.1}, 1, 0, 0), far_away}));
  PointConstraint point;
  add_near_pairs(point, checker, posture(0.8, 0, 0), 0.02, 0.02);  // 0.05 m away
  EXPECT_TRUE(point.rows.empty());
  add_near_pairs(point, checker, posture(0.82, 0, 0), 0.02, 0.02);
  add_near_pairs(point, checker, posture(0.9, 0, 0), 0.02, 0.02);
  ASSERT_EQ(point.rows.size(), 1U);
  EXPECT_EQ(point.rows[0].kind, Kind::clearance);
  EXPECT_EQ(point.rows[0].bounds.lower, 0.02);
}

TEST(PointConstraint, BetweenWaypointsTheBoxIsWidenedByItsShare) {
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 4, 4, gantry::box(0.01, 0.02));
  task.between_position = 0.001;
  task.between_angle = 0.002;
  const PointConstraint point = constraint_between(task, 5, 2.7, 0.5, SplineBasis({0, 4}));
  ASSERT_EQ(point.rows.size(), 6U);
  EXPECT_NEAR(point.rows[0].bounds.upper, 0.0105, 1e-12);
  EXPECT_NEAR(point.rows[3].bounds.lower, -0.021, 1e-12);
  EXPECT_LT((point.frame.translation() - Eigen::Vector3d(1, 0.35, 0)).norm(), 1e-12);
}

/// A spline that leaves the seam by a known amount between two waypoints.
TEST(FindDips, FindsTheWorstTimeOfEachInterval) {
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 10, gantry::box(0.001, 0.1));
  ClearanceChecker checker(gantry::clearance(gantry::robot()));
  JointPath path = gantry::path_along(task);
  Spline spline = fit_spline(path, path.times);
  EXPECT_TRUE(find_dips(task, spline, checker, 0, 1e-5).empty());
  spline.control(1, 7) += 0.01;
  std::map<std::size_t, double> found;
  for (const Dip& dip : find_dips(task, spline, checker, 0, 1e-5)) {
    EXPECT_NEAR(std::abs(spline.evaluate(dip.time)[1]) - 0.0011, dip.depth, 1e-9);
    found[dip.interval] = dip.depth;
  }
  int deep = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    double deepest = 0;
    for (double t = task.waypoints[i].time; t <= task.waypoints[i + 1].time; t += 1e-3) {
      deepest = std::max(deepest, std::abs(spline.evaluate(t)[1]) - 0.001 - task.between_position);
    }
    EXPECT_LE(found[i], deepest + 1e-9);
    EXPECT_GE(found[i], 0.97 * deepest - 1e-6);
    if (deepest > 1e-4) ++deep;
  }
  EXPECT_GT(deep, 2);
}

TEST(FindDips, FindsAnObstacleBetweenWaypoints) {
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 10, gantry::box(0.001, 0.1));
  const auto robot = gantry::robot(gantry::parts(0.002));
  ClearanceChecker checker(
      gantry::clearance(robot, {gantry::obstacle(Box{{0.002, 1, 1}}, 0.347, 0, 0)}, 0.001));
  const JointPath path = gantry::path_along(task);
  const auto dips = find_dips(task, fit_spline(path, path.times), checker, 0.001, 1e-5);
  ASSERT_EQ(dips.size(), 1U);
  EXPECT_EQ(dips[0].interval, 3U);
  EXPECT_NEAR(dips[0].time, 3.47, 0.02);
}

/// Knots between waypoints and waypoints between knots; a dip in the box and one in the distance.
TEST(FindDips, FindsBothKindsWhateverTheKnots) {
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 10, 10, gantry::box(0.001, 0.1));
  const auto robot = gantry::robot(gantry::parts(0.002));
  ClearanceChecker checker(
      gantry::clearance(robot, {gantry::obstacle(Box{{0.002, 1, 1}}, 0.347, 0, 0)}, 0.001));
  JointPath fine;
  for (int i = 0; i <= 40; ++i) {
    fine.times.push_back(10 * i / 40.0);
    const double off = i == 30 ? 0.02 : 0;  // at 7.5 s
    fine.positions.push_back(posture(i / 40.0, off, 0));
  }
  for (const double spacing : {0.25, 1.0}) {
    const Spline spline = fit_spline(fine, choose_breakpoints(fine.times, spacing));
    bool box_at_7 = false, plate_at_3 = false;
    for (const Dip& dip : find_dips(task, spline, checker, 0.001, 1e-5)) {
      EXPECT_GT(dip.depth, 0);
      EXPECT_GE(dip.time, task.waypoints[dip.interval].time);
      EXPECT_LE(dip.time, task.waypoints[dip.interval + 1].time);
      const bool off_the_box = std::abs(spline.evaluate(dip.time)[1]) > 0.0011;
      if (dip.interval == 7 && off_the_box) box_at_7 = true;
      if (dip.interval == 3 && !off_the_box) plate_at_3 = true;
    }
    EXPECT_TRUE(box_at_7);
    EXPECT_TRUE(plate_at_3);
  }
}

}  // namespace
}  // namespace wristwise
