// What stage 2 prefers beside a smooth motion: a posture, and to stay away from singular ones.

#include <gtest/gtest.h>

#include <cmath>

#include "kuka_kr5_arc.hpp"
#include "refinement_example.hpp"
#include "three_point_optimum.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::Example;
using test::kDuration;
using test::kTau;
using test::ThreePointOptimum;

TEST(PreferredPosture, PullsAsMuchAsTheClosedFormSays) {
  Example example(gantry::parts(), test::three_point_task());
  example.cost.preferred_posture = {0.4, 0.5, -0.5, 0.2};
  const Refined refined = example.run(test::three_point_seed(example.task));
  EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
  ThreePointOptimum optimum(4, kDuration, kTau, {false, false, true});
  const double middle[] = {0.7, 0.3, -0.2, 0.1}, end[] = {1, -0.1, 0, 0};
  double objective = 0;
  for (int j = 0; j < 4; ++j) {
    const double at = example.cost.preferred_posture[static_cast<std::size_t>(j)];
    optimum.pass_through(0 - at, middle[j] - at, end[j] - at);
    objective += optimum.objective();
    for (double t = 0; t <= kDuration; t += 0.37)
      EXPECT_NEAR(refined.trajectory.evaluate(t)[j], at + optimum.value(t), 1e-4) << t;
  }
  EXPECT_NEAR(refined.statistics.objective, objective, 1e-4 * objective);
}

TEST(PreferredPosture, PullsTheMoreTheLargerItsWeight) {
  Example example(gantry::parts(), test::three_point_task());
  example.cost.preferred_posture = {0.4, 0.5, -0.5, 0.2};
  const JointVector preferred = gantry::posture(0.4, 0.5, -0.5, 0.2);
  double last = INFINITY;
  for (const double weight : {0.0, 1.0, 10.0, 100.0}) {
    example.cost.posture = weight;
    const Refined refined = example.run(test::three_point_seed(example.task));
    EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
    double distance = 0;
    for (double t = 0; t <= kDuration; t += 0.01)
      distance += (refined.trajectory.evaluate(t) - preferred).squaredNorm();
    EXPECT_LT(distance, 0.95 * last);
    last = distance;
  }
}

/// The seam of task C, along which the wrist is all but stretched, with the spin free.
class SpinOfTheKr5 : public testing::Test {
 protected:
  SpinOfTheKr5()
      : problem_(load_problem(std::string(WRISTWISE_SOURCE_DIR) +
                              "/problems/task_c_wrist_singularity.yaml")) {
    for (Waypoint& waypoint : problem_.task.waypoints) {
      waypoint.tolerance.lower[5] = -ToleranceBox::kFree;
      waypoint.tolerance.upper[5] = ToleranceBox::kFree;
    }
    clearance_ = std::make_shared<const ClearanceModel>(problem_.robot, problem_.scene);
    problem_.graph.step[5] = 0.5;
    PlanResult graph = plan_graph_only(problem_);
    EXPECT_EQ(graph.status, Status::solved);
    seed_ = graph.path;
  }

  Trajectory refined() const {
    const Monitor monitor;
    const Refined refined = refine(
        {*problem_.robot, problem_.task, clearance_, problem_.cost, problem_.refine, monitor},
        seed_);
    EXPECT_TRUE(refined.feasible) << refined.statistics.termination;
    EXPECT_TRUE(verify(problem_.task, clearance_, refined.trajectory).passed);
    return refined.trajectory;
  }

  /// Of |sin q5|, the angle between the axes of joints 4 and 6.
  static double least_wrist_angle(const Trajectory& trajectory) {
    double least = 1;
    for (double t = trajectory.times().front(); t < trajectory.times().back(); t += 0.05)
      least = std::min(least, std::abs(std::sin(trajectory.evaluate(t)[4])));
    return least;
  }

  Problem problem_;
  std::shared_ptr<const ClearanceModel> clearance_;
  JointPath seed_;
};

TEST_F(SpinOfTheKr5, TurnsTheWristAwayFromItsSingularPosture) {
  const double without = least_wrist_angle(refined());
  problem_.cost.singularity_refine = 10;
  const double with = least_wrist_angle(refined());
  EXPECT_GT(with, without + 0.02);
}

TEST_F(SpinOfTheKr5, ComesNearerToThePreferredPosture) {
  const auto distance = [this](const Trajectory& trajectory, const JointVector& from) {
    double sum = 0;
    for (const double t : seed_.times) sum += (trajectory.evaluate(t) - from).squaredNorm();
    return sum;
  };
  const Trajectory free = refined();
  JointVector preferred = free.evaluate(0.5 * free.times().back());
  preferred[5] += 0.5;  // a turn of the torch about itself, more or less
  problem_.cost.preferred_posture = {preferred.data(), preferred.data() + 6};
  EXPECT_LT(distance(refined(), preferred), 0.9 * distance(free, preferred));
}

}  // namespace
}  // namespace wristwise
