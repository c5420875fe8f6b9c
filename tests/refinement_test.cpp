#include "refine/refinement.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <cstring>

#include "cancelled.hpp"
#include "gantry.hpp"
#include "wristwise/verification.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using gantry::posture;

constexpr double kDuration = 10;  // s
constexpr double kTau = 2;        // s

/// The least integral of |q'|^2 + tau^2 |q''|^2 + tau^4 |q'''|^2 over [0, m] and [m, T] through
/// three values. Euler-Lagrange: q'' - tau^2 q'''' + tau^4 q^(6) = 0 on both sides, solved by 1, t
/// and exp(r t) with (tau r)^4 - (tau r)^2 + 1 = 0, that is tau r = exp(i (+-30, +-150) deg).
/// q' to q'''' are continuous at m; at the ends q''' = 0 and q'' = tau^2 q''''.
class ThreePointOptimum {
 public:
  using Complex = std::complex<double>;

  ThreePointOptimum(double middle, double duration, double tau)
      : middle_(middle), duration_(duration), tau_(tau) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(12, 12);
    const Eigen::Matrix<double, 1, 6> zero = Eigen::Matrix<double, 1, 6>::Zero();
    int row = 0;
    const auto add = [&](const Eigen::Matrix<double, 1, 6>& left,
                         const Eigen::Matrix<double, 1, 6>& right) {
      matrix.row(row++) << left, right;
    };
    add(basis(0, 0, 0), zero);
    add(basis(0, middle, 0), zero);
    add(zero, basis(1, middle, 0));
    add(zero, basis(1, duration, 0));
    for (int k = 1; k <= 4; ++k) add(basis(0, middle, k), -basis(1, middle, k));
    add(basis(0, 0, 3), zero);
    add(zero, basis(1, duration, 3));
    add(basis(0, 0, 2) - tau * tau * basis(0, 0, 4), zero);
    add(zero, basis(1, duration, 2) - tau * tau * basis(1, duration, 4));
    solver_.compute(matrix);
  }

  /// Sets the three values of one coordinate.
  void pass_through(double start, double middle, double end) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(12);
    right.head<4>() << start, middle, middle, end;
    coefficients_ = solver_.solve(right);
  }

  double value(double t, int derivative = 0) const {
    const int piece = t < middle_ ? 0 : 1;
    return basis(piece, t, derivative) * coefficients_.segment<6>(6 * piece);
  }

  double objective() const {
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double t = duration_ * (i + 0.5) / kSteps;
      sum += std::pow(value(t, 1), 2) + std::pow(tau_ * value(t, 2), 2) +
             std::pow(tau_ * tau_ * value(t, 3), 2);
    }
    return sum * duration_ / kSteps;
  }

 private:
  /// Real and imaginary parts of exp(r (t - t0)), t0 the end at which it is largest.
  Eigen::Matrix<double, 1, 6> basis(int piece, double t, int k) const {
    const double begin = piece == 0 ? 0 : middle_, end = piece == 0 ? middle_ : duration_;
    const Complex growing = std::polar(1 / tau_, std::acos(-1.0) / 6);
    const Complex decaying = -std::conj(growing);
    const Complex up = std::pow(growing, k) * std::exp(growing * (t - end));
    const Complex down = std::pow(decaying, k) * std::exp(decaying * (t - begin));
    Eigen::Matrix<double, 1, 6> row;
    row << (k == 0 ? 1 : 0), (k == 0 ? t : (k == 1 ? 1 : 0)), up.real(), up.imag(), down.real(),
        down.imag();
    return row;
  }

  double middle_, duration_, tau_;
  Eigen::FullPivLU<Eigen::MatrixXd> solver_;
  Eigen::VectorXd coefficients_;
};

/// A refinement with everything it refers to.
struct Example {
  std::shared_ptr<const Robot> robot;
  Task task;
  std::shared_ptr<const ClearanceModel> clearance;
  CostOptions cost;
  RefineOptions options;
  Monitor monitor;

  Example(const Robot::Parts& parts, Task of, const std::vector<SceneObject>& objects = {},
          double required = 0)
      : robot(gantry::robot(parts)),
        task(std::move(of)),
        clearance(gantry::clearance(robot, objects, required)) {
    options.smoothing_time = kTau;
  }
  Refined run(const JointPath& seed) const {
    return refine({*robot, task, clearance, cost, options, monitor}, seed);
  }
  Refined run() const { return run(gantry::path_along(task)); }
};

/// Wide boxes along a line, and given postures at the start, at 40 % and at the end.
Task three_point_task() {
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 100, gantry::box(1.5, 1));
  task.waypoints.front().joints = posture(0, 0, 0);
  task.waypoints[40].joints = posture(0.7, 0.3, -0.2, 0.1);
  task.waypoints.back().joints = posture(1, -0.1, 0, 0);
  return task;
}

JointPath three_point_seed(const Task& task) {
  JointPath seed = gantry::path_along(task);
  for (const std::size_t i : {std::size_t{0}, std::size_t{40}, std::size_t{100}}) {
    seed.positions[i] = task.waypoints[i].joints->nominal();
  }
  return seed;
}

TEST(Refine, FindsTheOptimumThroughThreePoints) {
  Example example(gantry::parts(), three_point_task());
  example.cost.joint_weights = {1, 2, 0.5, 1};
  const Refined refined = example.run(three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible);
  ThreePointOptimum optimum(4, kDuration, kTau);
  const double middle[] = {0.7, 0.3, -0.2, 0.1}, end[] = {1, -0.1, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    optimum.pass_through(0, middle[j], end[j]);
    objective +=
        std::pow(example.cost.joint_weights[static_cast<std::size_t>(j)], 2) * optimum.objective();
    for (double t = 0; t <= kDuration; t += 0.37) {
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], optimum.value(t), 1e-4);
    }
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  EXPECT_LE(refined.statistics.max_violation, example.options.constraint_tolerance);
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
}

/// The ranges at 4 s let x go straight from 0 to 1, hold y at its lower and z at its upper bound,
/// and leave the tilt one value.
TEST(Refine, FindsTheOptimumThroughTheRangesOfAJointWaypoint) {
  Example example(gantry::parts(), three_point_task());
  example.task.waypoints[40].joints =
      JointBox(posture(0.3, 0.2, -0.5, 0.1), posture(0.5, 0.4, -0.1, 0.1));
  example.task.waypoints.back().joints = posture(1, 0, 0, 0);
  const Refined refined = example.run(three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible);
  ThreePointOptimum optimum(4, kDuration, kTau);
  const double middle[] = {0.4, 0.2, -0.1, 0.1}, end[] = {1, 0, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    optimum.pass_through(0, middle[j], end[j]);
    objective += optimum.objective();
    for (double t = 0; t <= kDuration; t += 0.37) {
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], optimum.value(t), 1e-4);
    }
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  const JointVector q = refined.trajectory.evaluate(example.task.waypoints[40].time);
  EXPECT_GE(q[1], 0.2);
  EXPECT_LE(q[2], -0.1);
  EXPECT_TRUE(verify(example.task, example.clearance, refined.trajectory).passed);
}

TEST(Refine, TermsAddUpToTheObjective) {
  const Example example(gantry::parts(), three_point_task());
  const RefineStatistics statistics = example.run(three_point_seed(example.task)).statistics;
  EXPECT_TRUE(statistics.run);
  ASSERT_EQ(statistics.terms.size(), 6U);
  double sum = 0, initial = 0;
  for (const CostTerm& term : statistics.terms) {
    sum += term.final;
    initial += term.initial;
  }
  EXPECT_NEAR(sum, statistics.objective, 1e-9 * sum);
  EXPECT_LT(sum, 1e-2 * initial);
}

/// A corner of the seam at y = 0.3, cut as far as the box allows: y = 0.25 at 4 s, the rest free.
TEST(Refine, PressesTheTcpToTheEdgeOfItsBox) {
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, 100, gantry::box(1.5, 1));
  task.waypoints.front().joints = posture(0, 0, 0);
  task.waypoints.back().joints = posture(1, 0, 0);
  Waypoint& corner = task.waypoints[40];
  corner.tolerance.lower[1] = 0.25;
  corner.tolerance.upper[1] = 0.35;
  // The stretch that ends there keeps the wide box of a joint waypoint instead: a move.
  std::vector<SeamPiece> pieces(3, task.seam.pieces().front());
  pieces[0].end_time = pieces[1].start_time = task.waypoints[39].time;
  pieces[1].end_time = pieces[2].start_time = corner.time;
  pieces[0].to = pieces[1].from = task.waypoints[39].frame;
  pieces[1].to = pieces[2].from = corner.frame;
  pieces[1].kind = SeamPiece::Kind::move;
  task.seam = Seam(pieces);
  JointPath seed = gantry::path_along(task);
  seed.positions[40][1] = 0.3;
  const Example example(gantry::parts(), task);
  const Refined refined = example.run(seed);
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  EXPECT_NEAR(refined.trajectory.positions()[40][1], 0.25, 1e-5);
  ThreePointOptimum optimum(4, kDuration, kTau);
  optimum.pass_through(0, 0.25, 0);
  // Along x the straight line at constant speed costs 1 / T.
  const double objective = optimum.objective() + 1 / kDuration;
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
  for (double t = 0; t <= kDuration; t += 0.37) {
    EXPECT_NEAR(refined.trajectory.evaluate(t)[1], optimum.value(t), 1e-4);
  }
}

TEST(Refine, KeepsTheSpeedLimitForAllTimes) {
  Task task = three_point_task();
  ThreePointOptimum optimum(4, kDuration, kTau);
  optimum.pass_through(0, 0.7, 1);
  double fastest = 0;
  for (double t = 0; t < kDuration; t += 0.01) {
    fastest = std::max(fastest, std::abs(optimum.value(t, 1)));
  }
  Robot::Parts parts = gantry::parts();
  const double limit = 0.7 / 4 + 0.5 * (fastest - 0.7 / 4);  // the middle must be reached
  ASSERT_LT(limit, 0.99 * fastest);
  parts.joints[0].max_velocity = limit;
  const Example example(parts, task);
  const Refined refined = example.run(three_point_seed(task));
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  const Verification verification = verify(task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << ::testing::PrintToString(verification.failures);
  EXPECT_LE(verification.velocity_ratio, 1);
  EXPECT_GT(verification.velocity_ratio, 0.99);
  const Refined unlimited = Example(gantry::parts(), task).run(three_point_seed(task));
  EXPECT_GT(refined.statistics.objective, unlimited.statistics.objective);
}

TEST(Refine, KeepsAccelerationAndJerkLimits) {
  const Task task = three_point_task();
  const Refined unlimited = Example(gantry::parts(), task).run(three_point_seed(task));
  const auto peak = [](const Trajectory& trajectory, int derivative) {
    double largest = 0;
    for (double t = 0; t < kDuration; t += 1e-3) {
      largest = std::max(largest, trajectory.evaluate(t, derivative).cwiseAbs().maxCoeff());
    }
    return largest;
  };
  for (const int derivative : {2, 3}) {
    Robot::Parts parts = gantry::parts();
    const double limit = 0.85 * peak(unlimited.trajectory, derivative);
    for (Joint& joint : parts.joints) {
      (derivative == 2 ? joint.max_acceleration : joint.max_jerk) = limit;
    }
    const Example example(parts, task);
    const Refined refined = example.run(three_point_seed(task));
    EXPECT_TRUE(refined.feasible) << derivative << " " << refined.statistics.termination;
    EXPECT_LE(peak(refined.trajectory, derivative), limit);
    EXPECT_GT(peak(refined.trajectory, derivative), 0.95 * limit);
    EXPECT_GT(refined.statistics.objective, unlimited.statistics.objective);
  }
}

constexpr double kBall = 0.05, kObstacle = 0.1, kRequired = 0.02;  // m

/// Straight past an obstacle that is in the way.
Example obstacle_example(const ToleranceBox& box, int intervals) {
  return {gantry::parts(kBall),
          gantry::task({{0, 0, 0}, {1, 0, 0}}, kDuration, intervals, box),
          {gantry::obstacle(Sphere{kObstacle}, 0.5, -0.01, 0)},
          kRequired};
}

TEST(Refine, GoesRoundAnObstacleAtTheRequiredClearance) {
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  Example example = obstacle_example(box, 40);
  for (Waypoint* end : {&example.task.waypoints.front(), &example.task.waypoints.back()}) {
    end->tolerance = gantry::box(0, 0.1);
  }
  const Refined refined = example.run();
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  const Verification verification = verify(example.task, example.clearance, refined.trajectory);
  EXPECT_TRUE(verification.passed) << ::testing::PrintToString(verification.failures);
  double least = INFINITY;
  for (double t = 0; t <= kDuration; t += 1e-3) {
    const Eigen::Vector3d centre = refined.trajectory.evaluate(t).head<3>();
    least = std::min(least, (centre - Eigen::Vector3d(0.5, -0.01, 0)).norm() - kBall - kObstacle);
  }
  EXPECT_GE(least, kRequired);
  EXPECT_LT(least, kRequired + 2 * example.options.clearance_epsilon);
}

TEST(Refine, SaysThatABoxInsideAnObstacleIsInfeasible) {
  Example example = obstacle_example(gantry::box(0.001, 0.1), 10);
  const Refined refined = example.run();
  EXPECT_FALSE(refined.feasible);
  EXPECT_FALSE(refined.trajectory.empty());
  EXPECT_GT(refined.statistics.max_violation, 0.01);
  EXPECT_FALSE(verify(example.task, example.clearance, refined.trajectory).passed);
}

TEST(Refine, GivesTheSameBytesEveryTime) {
  ToleranceBox box = gantry::box(0, 0.1);
  box.lower[1] = -0.5;
  box.upper[1] = 0.5;
  const Example example = obstacle_example(box, 20);
  const Refined one = example.run(), other = example.run();
  ASSERT_EQ(one.trajectory.times().size(), other.trajectory.times().size());
  for (std::size_t i = 0; i < one.trajectory.times().size(); ++i) {
    for (const auto member :
         {&Trajectory::positions, &Trajectory::velocities, &Trajectory::accelerations}) {
      EXPECT_EQ(std::memcmp((one.trajectory.*member)()[i].data(),
                            (other.trajectory.*member)()[i].data(), 4 * sizeof(double)),
                0);
    }
  }
}

TEST(Refine, StopsWhenCancelled) {
  std::atomic<bool> cancel{true};
  Example example(gantry::parts(), three_point_task());
  example.monitor.cancel = &cancel;
  EXPECT_THROW(example.run(three_point_seed(example.task)), Cancelled);
  cancel = false;
  int reports = 0;
  example.monitor.progress = [&](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "refine");
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (++reports == 2) cancel = true;
  };
  EXPECT_THROW(example.run(three_point_seed(example.task)), Cancelled);
  EXPECT_EQ(reports, 2);
}

}  // namespace
}  // namespace wristwise
