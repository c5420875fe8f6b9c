// A seam made longer: to and fro in rows, joined by half circles. Rows are long compared with the
// smoothing time, so that each turn costs what it costs by itself.

#include <gtest/gtest.h>

#include <cmath>

#include "refinement_example.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRow = 1, kRadius = 0.04, kSpeed = 0.1, kTolerance = 1e-3;  // m, m/s
constexpr double kSmoothing = 0.5;                                           // s

Pose row_end(int row, bool right) {
  Pose pose = Pose::Identity();
  pose.translation() << (right ? kRow : 0), 2 * kRadius * row - 1, 0;
  if (row % 2 == 1) pose.linear() = Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitZ()).matrix();
  return pose;
}

SeamPiece half_circle(int row) {
  SeamPiece piece;
  piece.kind = SeamPiece::Kind::arc;
  piece.from = row_end(row, row % 2 == 0);
  piece.to = row_end(row + 1, row % 2 == 0);
  piece.center = 0.5 * (piece.from.translation() + piece.to.translation());
  piece.angle = row % 2 == 0 ? kPi : -kPi;
  return piece;
}

Seam rows_to_and_fro(int rows) {
  std::vector<SeamPiece> pieces;
  double time = 0;
  const auto add = [&](SeamPiece piece) {
    piece.start_time = time;
    piece.end_time = time += piece.length() / kSpeed;
    pieces.push_back(piece);
  };
  for (int row = 0; row < rows; ++row) {
    SeamPiece line;
    line.from = row_end(row, row % 2 == 1);
    line.to = row_end(row, row % 2 == 0);
    add(line);
    if (row + 1 < rows) add(half_circle(row));
  }
  return Seam(pieces);
}

Task task_of(int rows) {
  Task task;
  task.seam = rows_to_and_fro(rows);
  const double end = task.seam.end_time();
  const int count = static_cast<int>(end / 0.1);
  for (int i = 0; i <= count; ++i) {
    Waypoint waypoint;
    waypoint.time = i == count ? end : end * i / count;
    waypoint.frame = task.seam.frame_at(waypoint.time);
    waypoint.tolerance = gantry::box(kTolerance, 0.1);
    waypoint.tolerance.upper[5] = ToleranceBox::kFree;
    waypoint.tolerance.lower[5] = -ToleranceBox::kFree;
    task.waypoints.push_back(waypoint);
  }
  return task;
}

Example example_of(int rows) {
  Example example(gantry::parts(), task_of(rows));
  example.options.smoothing_time = kSmoothing;
  return example;
}

Refined refined(int rows) {
  const Refined result = example_of(rows).run();
  EXPECT_TRUE(result.feasible) << rows << " rows: " << result.statistics.termination;
  return result;
}

TEST(LongSeam, IterationsDoNotGrowWithItsLength) {
  const int few = refined(2).statistics.iterations;
  EXPECT_LT(refined(8).statistics.iterations, 2.5 * few);
  EXPECT_LT(refined(24).statistics.iterations, 2.5 * few);
}

/// Each turn has its own optimum, however many others there are.
TEST(LongSeam, EachTurnCostsTheSame) {
  const double j3 = refined(3).statistics.objective, j5 = refined(5).statistics.objective;
  const double two = j5 - j3;
  EXPECT_NEAR(refined(13).statistics.objective, j5 + 4 * two, 1e-3 * (j5 + 4 * two));
  EXPECT_NEAR(refined(25).statistics.objective, j5 + 10 * two, 1e-3 * (j5 + 10 * two));
}

/// Long spans on the rows leave nothing out that short ones everywhere would find.
TEST(LongSeam, IsAsGoodAsWithShortSpansEverywhere) {
  Example fine = example_of(5);
  fine.options.knot_spacing = 0.1;
  const Refined even = fine.run();
  ASSERT_TRUE(even.feasible);
  const Refined own = refined(5);
  EXPECT_LT(own.statistics.control_points, 0.75 * even.statistics.control_points);
  EXPECT_NEAR(own.statistics.objective, even.statistics.objective,
              1e-3 * even.statistics.objective);
}

/// Inside the box at every waypoint, and as smooth at the ends of turns as anywhere.
TEST(LongSeam, HoldsEverywhereWithoutJumps) {
  const Task task = task_of(9);
  const Trajectory motion = refined(9).trajectory;
  for (const Waypoint& waypoint : task.waypoints) {
    const JointVector q = motion.evaluate(waypoint.time);
    const Eigen::Vector3d off = waypoint.frame.inverse() * Eigen::Vector3d(q[0], q[1], q[2]);
    EXPECT_LE(off.cwiseAbs().maxCoeff(), kTolerance + 1e-6) << waypoint.time;
  }
  for (std::size_t i = 1; i + 1 < motion.times().size(); ++i) {
    const double t = motion.times()[i];
    for (int k = 0; k <= 3; ++k) {
      const JointVector jump = motion.evaluate(t + 1e-7, k) - motion.evaluate(t - 1e-7, k);
      EXPECT_LE(jump.norm(), 2e-3) << "derivative " << k << " at " << t;
    }
  }
}

}  // namespace
}  // namespace wristwise
