// Problems that are built in code, and are not complete or do not fit together.

#include "problem_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "gantry_ik.hpp"
#include "invalid_input.hpp"
#include "wristwise/placement.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::invalid_input;
using test::says;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Problem good_problem() {
  Problem problem;
  problem.robot = gantry::robot();
  problem.inverse_kinematics = std::make_shared<const gantry::ExactIk>();
  problem.scene.find_permanent_contacts = false;
  problem.task = gantry::task({{0, 0, 0}, {0.5, 0, 0}}, 2, 4, gantry::box(0, 0));
  return problem;
}

TEST(ProblemCheck, AcceptsWhatIsUsable) {
  Problem problem = good_problem();
  EXPECT_NO_THROW(require_usable(problem));
  problem.cost.joint_weights = {1, 2, 3, 4};
  problem.cost.preferred_posture = {0, -1, 0, 0};
  problem.graph.max_stray = kInfinity;
  EXPECT_NO_THROW(require_usable(problem));
}

struct Fault {
  const char* where;
  std::function<void(Problem&)> plant;
};

const std::vector<Fault> kFaults = {
    {"robot: is null", [](Problem& p) { p.robot = nullptr; }},
    {"task.seam: is empty", [](Problem& p) { p.task = Task(); }},
    {"task.waypoints: 0 of them", [](Problem& p) { p.task.waypoints.clear(); }},
    {"task.waypoints: 1 of them", [](Problem& p) { p.task.waypoints.resize(1); }},
    {"task.waypoints[2]: its time",
     [](Problem& p) { p.task.waypoints[2].time = p.task.waypoints[1].time; }},
    {"task.waypoints[3]: a time or a frame", [](Problem& p) { p.task.waypoints[3].time = kNan; }},
    {"task.waypoints[1]: a time or a frame",
     [](Problem& p) { p.task.waypoints[1].frame.translation().x() = kInfinity; }},
    {"task.waypoints[4]", [](Problem& p) { p.task.waypoints[4].tolerance.lower[0] = 1; }},
    {"task.between_position: is -1; expected 0 or more",
     [](Problem& p) { p.task.between_position = -1; }},
    {"cost.jerk: is nan", [](Problem& p) { p.cost.jerk = kNan; }},
    {"cost.acceleration: is infinite", [](Problem& p) { p.cost.acceleration = kInfinity; }},
    {"cost.joint_weights: 3 values for 4 joints",
     [](Problem& p) {
       p.cost.joint_weights = {1, 1, 1};
     }},
    {"cost.joint_weights: is 0",
     [](Problem& p) {
       p.cost.joint_weights = {1, 1, 0, 1};
     }},
    {"cost.preferred_posture: 7 values", [](Problem& p) { p.cost.preferred_posture.assign(7, 0); }},
    {"cost.preferred_posture: has the value",
     [](Problem& p) {
       p.cost.preferred_posture = {0, 0, 0, kNan};
     }},
    {"cost.posture_residuals: an empty function",
     [](Problem& p) { p.cost.posture_residuals.emplace_back(); }},
    {"graph.step: is -0.1", [](Problem& p) { p.graph.step[5] = -0.1; }},
    {"graph.joint_step: 2 values",
     [](Problem& p) {
       p.graph.joint_step = {0.1, 0.1};
     }},
    {"graph.max_stray: is nan", [](Problem& p) { p.graph.max_stray = kNan; }},
    {"refine.smoothing_time: is 0", [](Problem& p) { p.refine.smoothing_time = 0; }},
    {"refine.clearance_epsilon: is -1", [](Problem& p) { p.refine.clearance_epsilon = -1; }},
    {"controller_period: is 0", [](Problem& p) { p.controller_period = 0; }},
};

TEST(ProblemCheck, NamesTheMemberAtEveryEntrance) {
  const JointPath path = gantry::path_along(good_problem().task);
  for (const Fault& fault : kFaults) {
    Problem problem = good_problem();
    fault.plant(problem);
    const std::vector<std::function<void()>> entrances = {
        [&] { plan(problem); }, [&] { plan_graph_only(problem); }, [&] { smooth(problem, path); },
        [&] { check(problem, path); },
        [&] {
          check(problem, TrajectoryFile{path, {}, {}});
        }};
    for (const auto& enter : entrances) {
      const std::string message = invalid_input(enter);
      EXPECT_TRUE(says(message, fault.where)) << fault.where << "\n" << message;
    }
  }
}

TEST(ProblemCheck, LeavesAUsableProblemToThePlanner) {
  EXPECT_EQ(plan(good_problem()).status, Status::solved);
}

}  // namespace
}  // namespace wristwise
