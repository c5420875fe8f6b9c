#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ikfast/ikfast_interface.hpp"
#include "invalid_input.hpp"
#include "kuka_kr5_arc.hpp"
#include "ortho_parallel.hpp"
#include "random_arm.hpp"
#include "temporary_folder.hpp"
#include "wristwise/ikfast_inverse_kinematics.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {
namespace {

namespace kr5 = test::kr5;
constexpr double kPi = 3.14159265358979323846;

std::filesystem::path library(const std::string& name) {
  return std::filesystem::path(WRISTWISE_IKFAST_FOLDER) / (name + ".so");
}

double distance(const JointVector& a, const JointVector& b) {
  double largest = 0;
  for (Eigen::Index j = 0; j < a.size(); ++j)
    largest = std::max(largest, std::abs(std::remainder(a[j] - b[j], 2 * kPi)));
  return largest;
}

/// Our own closed form, which knows the torch, against the solver, which knows the flange.
void expect_same_as_closed_form(const InverseKinematics& solver,
                                const std::shared_ptr<const Robot>& robot) {
  const auto own = find_inverse_kinematics(robot).solver;
  test::Dice dice(3);
  std::vector<JointVector> found, expected;
  for (int i = 0; i < 200; ++i) {
    const Pose tcp = tcp_pose(*robot, dice.posture());
    solver.solve(tcp, found);
    own->solve(tcp, expected);
    ASSERT_EQ(found.size(), expected.size());
    for (const JointVector& q : expected) {
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                              [&](const JointVector& other) { return distance(q, other) < 1e-6; }));
    }
    for (const JointVector& q : found) {
      EXPECT_LT((tcp_pose(*robot, q).matrix() - tcp.matrix()).norm(), 1e-9);
      EXPECT_LE(q.maxCoeff(), kPi);
      EXPECT_GT(q.minCoeff(), -kPi);
    }
  }
}

TEST(IkFast, ASharedObjectSolvesAsTheClosedFormDoes) {
  const auto robot = kr5::load();
  for (const char* name : {"ikfast_kr5", "ikfast_kr5_c"}) {
    const auto solver = IkFastInverseKinematics::load(robot, library(name));
    EXPECT_EQ(solver->description(), "IKFast");
    EXPECT_TRUE(solver->meets_every_pose());
    expect_same_as_closed_form(*solver, robot);
  }
}

TEST(IkFast, OutOfReachAndNotFiniteHaveNoSolution) {
  const auto solver = IkFastInverseKinematics::load(kr5::load(), library("ikfast_kr5"));
  std::vector<JointVector> branches(2);
  Pose pose = Pose::Identity();
  pose.translation().x() = 9;
  solver->solve(pose, branches);
  EXPECT_TRUE(branches.empty());
  pose.translation().x() = std::nan("");
  solver->solve(pose, branches);
  EXPECT_TRUE(branches.empty());
}

TEST(IkFast, SaysWhatIsWrongWithASharedObject) {
  const auto robot = kr5::load();
  const auto refusal = [&](const std::filesystem::path& file) {
    return test::invalid_input([&] { IkFastInverseKinematics::load(robot, file); });
  };
  EXPECT_TRUE(test::says(refusal("no_such_file.so"), "there is no such file"));
  const std::string no_library = refusal(std::filesystem::path(WRISTWISE_SOURCE_DIR) / "README.md");
  EXPECT_TRUE(test::says(no_library, "can't be loaded")) << no_library;
  EXPECT_EQ(no_library.find('\n'), std::string::npos);
  EXPECT_TRUE(test::says(refusal(library("ikfast_none")), "no function ComputeIk"));
  EXPECT_TRUE(test::says(refusal(library("ikfast_five_joints")), "it has 5 joints"));
  EXPECT_TRUE(test::says(refusal(library("ikfast_other_robot")), "of 50 poses"));
  // Without ComputeFk the tip is taken to be the TCP; this one's is the flange.
  EXPECT_TRUE(test::says(refusal(library("ikfast_without_fk")), "to the TCP"));
  test::invalid_input([&] {
    IkFastInverseKinematics::load(robot, library("ikfast_kr5"), {{"joint_a1", 0.1}});
  });
  test::invalid_input([&] { IkFastInverseKinematics ik(robot, IkFastFunctions{}); });
  test::invalid_input([&] { IkFastInverseKinematics ik(nullptr, IkFastFunctions{}); });
}

/// The KR 5 arc on a rail along x: seven joints, the rail a free parameter.
namespace on_rail {

std::shared_ptr<const Robot> robot() {
  Robot::Parts parts;
  parts.name = "on rail";
  parts.joints = kr5::load()->joints();
  Joint rail;
  rail.name = "rail";
  rail.type = JointType::prismatic;
  rail.axis = Eigen::Vector3d::UnitX();
  rail.lower = -0.5;
  rail.upper = 1;
  rail.max_velocity = 1;
  rail.max_acceleration = rail.max_jerk = 10;
  parts.joints.insert(parts.joints.begin(), rail);
  parts.tcp = kr5::load()->tcp();
  return std::make_shared<const Robot>(parts);
}

int free_joint = 0;

Pose flange_of(const Pose& tcp) {
  const auto arm = kr5::load();
  const JointVector zero = JointVector::Zero(6);
  Pose flange = Pose::Identity();
  flange.matrix() = kr5::tool0(zero);
  return tcp * (flange.inverse() * tcp_pose(*arm, zero)).inverse();
}

bool compute(const double* position, const double* rotation, const double* free,
             ikfast::IkSolutionListBase<double>& solutions) {
  Pose tcp = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    tcp.translation()[row] = position[row];
    for (int column = 0; column < 3; ++column)
      tcp.linear()(row, column) = rotation[3 * row + column];
  }
  tcp.translation().x() -= free[0];
  for (const JointVector& q : test::ortho_parallel(flange_of(tcp))) {
    std::vector<ikfast::IkSingleDOFSolutionBase<double>> joints(7);
    joints[0].foffset = free[0];
    for (std::size_t j = 0; j < 6; ++j) joints[j + 1].foffset = q[static_cast<Eigen::Index>(j)];
    solutions.AddSolution(joints, {});
  }
  return solutions.GetNumSolutions() > 0;
}

IkFastFunctions functions() {
  return {compute, nullptr, [] { return 1; }, [] { return &free_joint; }, [] { return 7; }};
}

}  // namespace on_rail

TEST(IkFast, FreeParametersAreSampledInsideTheirLimits) {
  const auto robot = on_rail::robot();
  const IkFastInverseKinematics solver(robot, on_rail::functions(), {{"rail", 0.25}});
  EXPECT_EQ(solver.description(), "IKFast, rail free, 7 samples");
  test::Dice dice(4);
  std::vector<JointVector> branches;
  for (int i = 0; i < 50; ++i) {
    JointVector q = dice.posture(7);
    q[0] = -0.5 + 0.25 * (i % 7);
    const Pose tcp = tcp_pose(*robot, q);
    solver.solve(tcp, branches);
    EXPECT_TRUE(std::any_of(branches.begin(), branches.end(),
                            [&](const JointVector& other) { return distance(q, other) < 1e-6; }));
    for (const JointVector& branch : branches) {
      EXPECT_LT((tcp_pose(*robot, branch).matrix() - tcp.matrix()).norm(), 1e-9);
      EXPECT_NEAR(std::remainder(branch[0], 0.25), 0, 1e-12);
    }
  }
  test::invalid_input([&] {
    IkFastInverseKinematics ik(robot, on_rail::functions(), {{"rail", 0}});
  });
  test::invalid_input([&] {
    IkFastInverseKinematics ik(robot, on_rail::functions(), {{"joint_a1", 0.1}});
  });
}

std::string problem_text(const std::filesystem::path& solver) {
  const std::string folder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  return "robot:\n  urdf: " + folder +
         "kuka_kr5_arc.urdf\n  tip_link: torch_tip\n  limits: " + folder +
         "joint_limits.yaml\n  ik: {ikfast: " + solver.string() + "}\n" +
         "scene: {collision: off}\n"
         "path:\n  speed: 0.02\n  waypoints: 20\n  segments:\n"
         "    - line: {from: {xyz: [0.9, -0.2, 0.3], rpy: [0, 180 deg, 0]},"
         " to: {xyz: [0.9, 0.2, 0.3], rpy: [0, 180 deg, 0]}}\n"
         "  tolerance: {rz: free}\n"
         "graph: {samples: {rz: 10 deg}}\n";
}

TEST(IkFast, AProblemFileNamesItAndIsPlannedAsWithTheClosedForm) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "problem.yaml";
  std::ofstream(file) << problem_text(library("ikfast_kr5_c"));
  const Problem problem = load_problem(file);
  ASSERT_NE(problem.inverse_kinematics, nullptr);
  Problem plain = problem;
  plain.inverse_kinematics = nullptr;
  const PlanResult result = plan(problem), expected = plan(plain);
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_EQ(result.inverse_kinematics, "IKFast");
  EXPECT_NEAR(result.graph.cost, expected.graph.cost, 1e-9);
  // The copies by whole turns of joints 4 and 6 are ours.
  EXPECT_EQ(result.graph.vertices, expected.graph.vertices);
  EXPECT_EQ(result.graph.postures, expected.graph.postures);
}

TEST(IkFast, AProblemFileWithAnotherRobotsSolverIsInvalid) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "problem.yaml";
  const auto refusal = [&](const std::filesystem::path& solver) {
    std::ofstream(file) << problem_text(solver);
    return test::invalid_input([&] { load_problem(file); });
  };
  for (const char* name : {"ikfast_other_robot", "ikfast_five_joints", "ikfast_none"}) {
    const std::string line = refusal(library(name));
    EXPECT_TRUE(test::says(line, "robot.ik.ikfast")) << line;
    EXPECT_TRUE(test::says(line, "problem.yaml")) << line;
  }
  EXPECT_TRUE(test::says(refusal("missing.so"), "missing.so"));
}

}  // namespace
}  // namespace wristwise
