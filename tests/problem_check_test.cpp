// What no reader of a file has seen: every option out of its range is named, every shipped problem
// is fine.
#include "problem_check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "invalid_input.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {
namespace {

using test::invalid_input;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const std::filesystem::path kProblems = WRISTWISE_SOURCE_DIR "/problems";

struct Fault {
  std::string name;
  std::function<void(Problem&, double)> set;
  std::vector<double> bad;
};

const std::vector<double> kNegativeOrNone = {-1, kNan, kInfinity};
const std::vector<double> kNotPositive = {0, -1, kNan, kInfinity};

const std::vector<Fault> kOfTheSearch = {
    {"cost.joint_motion", [](Problem& p, double x) { p.cost.joint_motion = x; }, kNegativeOrNone},
    {"cost.acceleration", [](Problem& p, double x) { p.cost.acceleration = x; }, kNegativeOrNone},
    {"cost.jerk", [](Problem& p, double x) { p.cost.jerk = x; }, kNegativeOrNone},
    {"cost.euler_eta", [](Problem& p, double x) { p.cost.euler_eta = x; }, kNegativeOrNone},
    {"cost.posture", [](Problem& p, double x) { p.cost.posture = x; }, kNegativeOrNone},
    {"cost.joint_weights[5]",
     [](Problem& p, double x) { p.cost.joint_weights = {1, 1, 1, 1, 1, x}; }, kNotPositive},
    {"cost.joint_weights: 2 values",
     [](Problem& p, double x) {
       p.cost.joint_weights = {1, x};
     },
     {1}},
    {"cost.preferred_posture: 7 values",
     [](Problem& p, double x) { p.cost.preferred_posture.assign(7, x); },
     {0}},
    {"graph.joint_step: 1 values", [](Problem& p, double x) { p.graph.joint_step = {x}; }, {0}},
    {"graph.step[4]", [](Problem& p, double x) { p.graph.step[4] = x; }, kNegativeOrNone},
    {"graph.max_stray", [](Problem& p, double x) { p.graph.max_stray = x; }, {0, -1, kNan}},
    {"graph.max_tcp_step", [](Problem& p, double x) { p.graph.max_tcp_step = x; }, {0, -1, kNan}},
    {"graph.seed_separation", [](Problem& p, double x) { p.graph.seed_separation = x; },
     kNotPositive},
    {"graph.seeds", [](Problem& p, double x) { p.graph.seeds = static_cast<int>(x); }, {0, -1}},
    {"refine.smoothing_time", [](Problem& p, double x) { p.refine.smoothing_time = x; },
     kNotPositive},
    {"refine.knot_spacing", [](Problem& p, double x) { p.refine.knot_spacing = x; },
     kNegativeOrNone},
    {"refine.max_iterations",
     [](Problem& p, double x) { p.refine.max_iterations = static_cast<int>(x); },
     {0, -1}},
    {"cost.posture_residuals: an empty function",
     [](Problem& p, double) { p.cost.posture_residuals.emplace_back(); },
     {0}},
    {"problem.controller_period", [](Problem& p, double x) { p.controller_period = x; },
     kNotPositive},
    {"refine.time_limit", [](Problem& p, double x) { p.refine.time_limit = x; }, {-1, kNan}},
};

const std::vector<Fault> kOfTheTask = {
    {"problem.robot", [](Problem& p, double) { p.robot = nullptr; }, {0}},
    {"task.seam", [](Problem& p, double) { p.task.seam = Seam(); }, {0}},
    {"task.waypoints: 1 given", [](Problem& p, double) { p.task.waypoints.resize(1); }, {0}},
    {"task.waypoints[2].time",
     [](Problem& p, double x) { p.task.waypoints[2].time = x; },
     {-1, 0, 1e3, kNan, kInfinity}},
    {"task.waypoints[2].frame",
     [](Problem& p, double x) { p.task.waypoints[2].frame.translation().x() = x; },
     {kNan, kInfinity}},
    {"task.waypoints[2].tolerance",
     [](Problem& p, double x) { p.task.waypoints[2].tolerance.lower[0] = x; },
     {1, kNan}},
    {"task.between_angle", [](Problem& p, double x) { p.task.between_angle = x; }, kNegativeOrNone},
    {"refine.clearance_epsilon", [](Problem& p, double x) { p.refine.clearance_epsilon = x; },
     kNotPositive},
};

Problem problem_with(const Fault& fault, double value) {
  static const Problem sound = load_problem(kProblems / "known_graph.yaml");
  Problem problem = sound;
  fault.set(problem, value);
  return problem;
}

const JointPath kPath{{0, 1}, {JointVector::Zero(6), JointVector::Zero(6)}};

TEST(ProblemCheck, EveryOptionOutOfRangeIsNamedBeforeItIsUsed) {
  for (const auto& faults : {kOfTheSearch, kOfTheTask}) {
    for (const Fault& fault : faults) {
      for (const double value : fault.bad) {
        const Problem problem = problem_with(fault, value);
        const std::string message = invalid_input([&] { plan(problem); });
        EXPECT_NE(message.find(fault.name), std::string::npos) << fault.name << ": " << message;
        EXPECT_EQ(invalid_input([&] { plan_graph_only(problem); }), message);
        EXPECT_EQ(invalid_input([&] { smooth(problem, kPath); }), message);
      }
    }
  }
}

TEST(ProblemCheck, ACheckNeedsTheTaskOnly) {
  for (const Fault& fault : kOfTheTask) {
    const Problem problem = problem_with(fault, fault.bad.front());
    const std::string message = invalid_input([&] { check(problem, kPath); });
    EXPECT_NE(message.find(fault.name), std::string::npos) << fault.name << ": " << message;
    EXPECT_EQ(invalid_input([&] { check(problem, TrajectoryFile{kPath, {}, {}}); }), message);
  }
  for (const Fault& fault : kOfTheSearch)
    EXPECT_NO_THROW(check_task(problem_with(fault, fault.bad.front())));
}

TEST(ProblemCheck, EveryShippedProblemIsSound) {
  for (const auto& file : std::filesystem::directory_iterator(kProblems)) {
    if (file.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(check_problem(load_problem(file.path()))) << file.path();
  }
}

}  // namespace
}  // namespace wristwise
