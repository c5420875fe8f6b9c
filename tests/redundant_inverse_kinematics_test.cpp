// Chains with joints to spare. The oracle moves the base and the TCP of a six-axis arm by hand, one
// combination of samples after the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "invalid_input.hpp"
#include "random_arm.hpp"
#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

using test::ArmChoice;
using test::Dice;
using test::invalid_input;
using test::says;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

Joint extra(const std::string& name, JointType type, Dice& dice, double lower, double upper) {
  Joint joint;
  joint.name = name;
  joint.type = type;
  joint.origin.linear() = dice.rotation();
  joint.origin.translation() = dice.vector(0.3);
  joint.axis = dice.rotation().col(0);
  joint.lower = lower;
  joint.upper = upper;
  joint.max_velocity = joint.max_acceleration = joint.max_jerk = 1;
  return joint;
}

/// Written out, not by the library's forward kinematics.
Pose moved(const Joint& joint, double value) {
  Pose motion = Pose::Identity();
  if (joint.type == JointType::prismatic) {
    motion.translation() = value * joint.axis;
  } else {
    motion.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  }
  return joint.origin * motion;
}

struct Chain {
  std::vector<Joint> before, behind;
  Robot arm;

  std::shared_ptr<const Robot> robot() const {
    Robot::Parts parts;
    parts.name = "chain";
    parts.joints = before;
    for (const Joint& joint : arm.joints()) parts.joints.push_back(joint);
    Pose flange = arm.tcp();
    for (const Joint& joint : behind) {
      parts.joints.push_back(joint);
      parts.joints.back().origin = flange * joint.origin;
      flange = Pose::Identity();
    }
    parts.tcp = flange;
    return std::make_shared<const Robot>(parts);
  }
};

bool same(const JointVector& a, const JointVector& b) {
  for (Eigen::Index j = 0; j < a.size(); ++j)
    if (std::abs(std::remainder(a[j] - b[j], 2 * kPi)) > 1e-7) return false;
  return true;
}

/// Each has its match in the other list.
void expect_same_sets(const std::vector<JointVector>& found,
                      const std::vector<JointVector>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (const JointVector& q : expected) {
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const JointVector& other) { return same(q, other); }));
  }
}

/// The samples that the documentation promises.
std::vector<double> grid(double lower, double upper, double step) {
  const int count = static_cast<int>(std::ceil((upper - lower) / step - 1e-9));
  std::vector<double> values;
  for (int k = 0; k <= count; ++k) values.push_back(lower + k * (upper - lower) / count);
  return values;
}

TEST(RedundantInverseKinematics, IsTheClosedFormOfTheArmAtEverySampleOfItsEnds) {
  Dice dice(4);
  int solutions = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Chain chain{{extra("rail", JointType::prismatic, dice, -0.4, 0.5),
                       extra("torso", JointType::revolute, dice, -1, 0.7)},
                      {extra("roll", JointType::revolute, dice, -0.8, 0.9)},
                      test::random_arm(dice, ArmChoice{})};
    const auto robot = chain.robot();
    const auto found =
        find_redundant_inverse_kinematics(robot, {{"rail", 0.3}, {"torso", 0.6}, {"roll", 0.5}});
    ASSERT_NE(found.solver, nullptr) << found.description;
    EXPECT_TRUE(says(found.description, "rail at 4 values, torso at 4 values, roll at 5 values"))
        << found.description;
    const auto arm = find_inverse_kinematics(std::make_shared<const Robot>(chain.arm));
    const Pose tcp = tcp_pose(*robot, dice.posture(9) / 4);

    std::vector<JointVector> expected, of_arm, branches;
    for (const double rail : grid(-0.4, 0.5, 0.3)) {
      for (const double torso : grid(-1, 0.7, 0.6)) {
        for (const double roll : grid(-0.8, 0.9, 0.5)) {
          const Pose base = moved(chain.before[0], rail) * moved(chain.before[1], torso);
          const Pose flange = base.inverse() * tcp * moved(chain.behind[0], roll).inverse();
          arm.solver->solve(flange, of_arm);
          for (const JointVector& q : of_arm) {
            JointVector whole(9);
            whole << rail, torso, q, roll;
            expected.push_back(whole);
          }
        }
      }
    }
    found.solver->solve(tcp, branches);
    expect_same_sets(branches, expected);
    for (const JointVector& q : branches) {
      EXPECT_LT((tcp_pose(*robot, q).matrix() - tcp.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    }
    solutions += static_cast<int>(branches.size());
  }
  EXPECT_GT(solutions, 1000);
}

TEST(RedundantInverseKinematics, AJointInTheMiddleHasASolverForEachSample) {
  Dice dice(9);
  for (int trial = 0; trial < 10; ++trial) {
    // A forearm that telescopes, perpendicular to the elbow's axis.
    const Robot arm = test::random_arm(dice, ArmChoice{});
    Robot::Parts parts = arm.parts();
    Joint slide = extra("slide", JointType::prismatic, dice, 0, 0.2);
    slide.origin = Pose::Identity();
    slide.axis = parts.joints[2].axis.unitOrthogonal();
    parts.joints.insert(parts.joints.begin() + 3, slide);
    const auto robot = std::make_shared<const Robot>(parts);
    const auto found = find_redundant_inverse_kinematics(robot);
    ASSERT_NE(found.solver, nullptr) << found.description;
    EXPECT_TRUE(says(found.description, "slide at 3 values")) << found.description;

    JointVector q = dice.posture(7);
    q[3] = 0.1;  // the middle sample
    const Pose tcp = tcp_pose(*robot, q);
    std::vector<JointVector> branches;
    found.solver->solve(tcp, branches);
    EXPECT_TRUE(std::any_of(branches.begin(), branches.end(),
                            [&](const JointVector& other) { return same(q, other); }));
    for (const JointVector& branch : branches) {
      EXPECT_LT((tcp_pose(*robot, branch).matrix() - tcp.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    }
    q[3] = 0.123;  // no sample
    const Pose between = tcp_pose(*robot, q);
    found.solver->solve_beside(between, q, branches);
    EXPECT_TRUE(std::any_of(branches.begin(), branches.end(),
                            [&](const JointVector& other) { return same(q, other); }));
    for (const JointVector& branch : branches) EXPECT_EQ(branch[3], 0.123);
  }
}

TEST(RedundantInverseKinematics, BesideAPostureTheEndsKeepItsValues) {
  Dice dice(2);
  const Chain chain{{extra("rail", JointType::prismatic, dice, -1, 1)},
                    {extra("roll", JointType::revolute, dice, -3, 3)},
                    test::random_arm(dice, ArmChoice{})};
  const auto robot = chain.robot();
  const auto found = find_redundant_inverse_kinematics(robot);
  ASSERT_NE(found.solver, nullptr);
  for (int trial = 0; trial < 50; ++trial) {
    JointVector q = dice.posture(8);
    q[0] = dice.uniform(-1, 1);
    q[7] = dice.uniform(-3, 3);
    std::vector<JointVector> branches;
    found.solver->solve_beside(tcp_pose(*robot, q), q, branches);
    EXPECT_TRUE(std::any_of(branches.begin(), branches.end(),
                            [&](const JointVector& other) { return same(q, other); }));
    for (const JointVector& branch : branches) {
      EXPECT_NEAR(branch[0], q[0], 1e-12);
      EXPECT_NEAR(branch[7], q[7], 1e-12);
    }
  }
}

TEST(RedundantInverseKinematics, ASeventhAxisIsSampledWhereTheRestHasAClosedForm) {
  // Every joint revolute: of the seven sets of six only the last six are an arm with a closed form.
  Dice dice(6);
  const Chain chain{{extra("turntable", JointType::continuous, dice, -HUGE_VAL, HUGE_VAL)},
                    {},
                    test::random_arm(dice, ArmChoice{})};
  const auto found = find_redundant_inverse_kinematics(chain.robot());
  ASSERT_NE(found.solver, nullptr) << found.description;
  EXPECT_TRUE(says(found.description, "turntable at 36 values")) << found.description;
  const Chain reversed{
      {}, {extra("roll", JointType::revolute, dice, -1, 1)}, test::random_arm(dice, ArmChoice{})};
  const auto behind = find_redundant_inverse_kinematics(reversed.robot());
  ASSERT_NE(behind.solver, nullptr) << behind.description;
  EXPECT_TRUE(says(behind.description, "roll at 13 values")) << behind.description;
}

TEST(RedundantInverseKinematics, RevoluteSamplesAreInThePrincipalTurn) {
  Dice dice(6);
  Chain chain{
      {extra("turn", JointType::revolute, dice, -10, 10)}, {}, test::random_arm(dice, ArmChoice{})};
  std::vector<JointVector> branches;
  const auto solve = [&](double step) {
    const auto found = find_redundant_inverse_kinematics(chain.robot(), {{"turn", step}});
    found.solver->solve(tcp_pose(*chain.robot(), JointVector::Constant(7, 0.3)), branches);
    std::vector<double> values;
    for (const JointVector& q : branches)
      if (values.empty() || values.back() != q[0]) values.push_back(q[0]);
    return values;
  };
  // More than a whole turn: each direction once. Not all need to be in reach.
  for (const double value : solve(20 * kDegree)) {
    EXPECT_GT(value, -kPi);
    EXPECT_LE(value, kPi);
    EXPECT_NEAR(value / (20 * kDegree), std::round(value / (20 * kDegree)), 1e-9);
  }
  chain.before[0].lower = 0;
  chain.before[0].upper = 5;  // less than a whole turn, but beyond pi
  ASSERT_FALSE(solve(1).empty());
  for (const double value : solve(1)) {
    EXPECT_GT(value, -kPi);
    EXPECT_LE(value, kPi);
  }
}

/// Solves nothing, and counts.
struct Counter : InverseKinematics {
  void solve(const Pose&, std::vector<JointVector>& branches) const override { branches.clear(); }
  std::string description() const override { return "counter"; }
};

TEST(RedundantInverseKinematics, AsksEarlierFindersForEveryChoiceFirst) {
  Dice dice(6);
  const Chain chain{{extra("turntable", JointType::revolute, dice, -1, 1)},
                    {},
                    test::random_arm(dice, ArmChoice{})};
  Robot::Parts parts = chain.robot()->parts();
  std::swap(parts.joints[0].name, parts.joints[6].name);
  const auto robot = std::make_shared<const Robot>(parts);
  int asked = 0;
  const InverseKinematicsFinder never = [&](const std::shared_ptr<const Robot>& rest) {
    EXPECT_EQ(rest->joint_count(), 6);
    ++asked;
    return InverseKinematicsFound{nullptr, "never"};
  };
  const InverseKinematicsFinder always = [](const std::shared_ptr<const Robot>&) {
    return InverseKinematicsFound{std::make_shared<Counter>(), "always"};
  };
  const auto nothing = find_redundant_inverse_kinematics(robot, {}, {never});
  EXPECT_EQ(nothing.solver, nullptr);
  EXPECT_EQ(nothing.description, "never");
  EXPECT_EQ(asked, 7);  // one for each joint that could be left out
  const auto later = find_redundant_inverse_kinematics(robot, {}, {never, always});
  EXPECT_TRUE(says(later.description, "for each: always")) << later.description;
}

TEST(RedundantInverseKinematics, WithoutJointsToSpareItIsTheSolverItself) {
  Dice dice(3);
  const auto arm = std::make_shared<const Robot>(test::random_arm(dice, ArmChoice{}));
  const auto found = find_redundant_inverse_kinematics(arm);
  ASSERT_NE(found.solver, nullptr);
  EXPECT_EQ(found.description, find_inverse_kinematics(arm).description);
}

TEST(ReversedInverseKinematics, SolvesAnArmThatHoldsThePart) {
  Dice dice(12);
  for (int trial = 0; trial < 50; ++trial) {
    const Robot arm = test::random_arm(dice, ArmChoice{});
    // The torch stands in the base of the arm, the part is in its hand.
    Robot::Parts parts;
    parts.name = "holder";
    Pose before = arm.tcp().inverse();
    for (int j = 5; j >= 0; --j) {
      Joint joint = arm.joints()[static_cast<std::size_t>(j)];
      const Pose origin = joint.origin;
      joint.origin = before;
      joint.axis = -joint.axis;
      parts.joints.push_back(joint);
      before = origin.inverse();
    }
    parts.tcp = before;
    const auto holder = std::make_shared<const Robot>(parts);
    const auto found = find_inverse_kinematics(holder);
    ASSERT_NE(found.solver, nullptr) << found.description;
    EXPECT_TRUE(says(found.description, "passed backwards: spherical wrist"));
    const auto forward = find_inverse_kinematics(std::make_shared<const Robot>(arm));
    const JointVector q = dice.posture();
    const Pose torch = tcp_pose(arm, q).inverse();  // seen from the hand
    EXPECT_LT((tcp_pose(*holder, q.reverse()).matrix() - torch.matrix()).norm(), 1e-12);
    std::vector<JointVector> branches, of_arm;
    found.solver->solve(torch, branches);
    forward.solver->solve(torch.inverse(), of_arm);
    for (JointVector& branch : of_arm) branch = branch.reverse().eval();
    expect_same_sets(branches, of_arm);
    for (const JointVector& branch : branches)
      EXPECT_LT((tcp_pose(*holder, branch).matrix() - torch.matrix()).norm(), 1e-9);
  }
}

TEST(RedundantInverseKinematics, DefaultStepsMakeAboutAHundredCombinations) {
  Dice dice(3);
  const Chain chain{{extra("rail", JointType::prismatic, dice, 0, 3),
                     extra("tilt", JointType::revolute, dice, -kPi / 2, kPi / 2),
                     extra("turn", JointType::continuous, dice, -HUGE_VAL, HUGE_VAL)},
                    {},
                    test::random_arm(dice, ArmChoice{})};
  int samples = 0;
  const InverseKinematicsFinder counting = [&](const std::shared_ptr<const Robot>&) {
    return InverseKinematicsFound{std::make_shared<Counter>(), "counter"};
  };
  const std::string description =
      find_redundant_inverse_kinematics(chain.robot(), {}, {counting}).description;
  int combinations = 1;
  for (std::size_t at = 0; (at = description.find(" at ", at)) != std::string::npos; ++at) {
    samples = std::stoi(description.substr(at + 4));
    EXPECT_GE(samples, 3);
    combinations *= samples;
  }
  EXPECT_LE(combinations, 100);
  EXPECT_GT(combinations, 40);
  // A step that is given is kept; the others give way.
  const std::string given =
      find_redundant_inverse_kinematics(chain.robot(), {{"rail", 0.05}}, {counting}).description;
  EXPECT_TRUE(says(given, "rail at 61 values, tilt at 3 values, turn at 3 values")) << given;
}

TEST(RedundantInverseKinematics, RefusesWhatCannotBeSampled) {
  Dice dice(3);
  const Chain chain{
      {extra("rail", JointType::prismatic, dice, 0, 3)}, {}, test::random_arm(dice, ArmChoice{})};
  const auto refusal = [&](const JointSteps& steps) {
    return invalid_input([&] { find_redundant_inverse_kinematics(chain.robot(), steps); });
  };
  EXPECT_TRUE(says(refusal({{"rial", 0.1}}), "no joint 'rial'"));
  EXPECT_TRUE(says(refusal({{"rial", 0.1}}), "'rail'"));
  EXPECT_TRUE(says(refusal({{"rail", -0.1}}), "graph.samples.rail"));
  EXPECT_TRUE(says(refusal({{"rail", std::nan("")}}), "graph.samples.rail"));
  EXPECT_TRUE(says(refusal({{"rail", HUGE_VAL}}), "graph.samples.rail"));
  EXPECT_TRUE(says(refusal({{"rail", 1e-6}}), "combinations"));

  const auto none = find_redundant_inverse_kinematics(
      chain.robot(), {{"rail", 1}, {"j1", 1}, {"j2", 1}, {"j3", 1}});
  EXPECT_EQ(none.solver, nullptr);
  EXPECT_TRUE(says(none.description, "at most 3")) << none.description;
  const JointSteps steps = {{"rail", 1}, {"j1", 1}};
  const auto five = find_redundant_inverse_kinematics(
      chain.robot(), steps, {[](const auto& rest) { return find_closed_form(rest); }});
  EXPECT_EQ(five.solver, nullptr);  // no closed form for five joints
  EXPECT_TRUE(says(find_redundant_inverse_kinematics(chain.robot(), steps).description, "numeric"));
  EXPECT_THROW(find_redundant_inverse_kinematics(nullptr), InvalidInput);
}

TEST(RedundantInverseKinematics, AJointThatIsHeldHasOneSample) {
  Dice dice(3);
  const Chain chain{{extra("rail", JointType::prismatic, dice, 0.7, 0.7)},
                    {},
                    test::random_arm(dice, ArmChoice{})};
  const auto found = find_redundant_inverse_kinematics(chain.robot());
  EXPECT_TRUE(says(found.description, "rail at 1 value;")) << found.description;
}

}  // namespace
}  // namespace wristwise
