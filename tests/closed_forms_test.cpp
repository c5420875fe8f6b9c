// The closed forms that are polished: arms whose axes 1 and 2 meet, arms whose axes 2, 3 and 4 are
// parallel, and the shipped arms that they serve.

#include <gtest/gtest.h>

#include "inverse_kinematics_oracle.hpp"
#include "kinematics/crossed_shoulder.hpp"
#include "kinematics/three_parallel_axes.hpp"
#include "published_arms.hpp"
#include "ur_closed_form.hpp"

namespace wristwise {
namespace {

using test::Dice;

/// At an angle to an axis: a right one, or any that is not small.
Eigen::Vector3d at_angle(Dice& dice, const Eigen::Vector3d& axis, bool right_angled) {
  const Eigen::Vector3d side = axis.cross(dice.rotation().col(0)).normalized();
  return Eigen::AngleAxisd(right_angled ? Dice::kPi / 2 : dice.uniform(0.6, 2.4), side) * axis;
}

/// From an axis to a point that is not near it.
Eigen::Vector3d beside(Dice& dice, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d side = axis.cross(dice.rotation().col(0)).normalized();
  return dice.uniform(0.2, 0.6) * side + dice.uniform(-0.3, 0.3) * axis;
}

std::shared_ptr<const Robot> arm_of(Dice& dice, const std::array<Eigen::Vector3d, 6>& points,
                                    const std::array<Eigen::Vector3d, 6>& directions) {
  Pose tcp = Pose::Identity();
  tcp.linear() = dice.rotation();
  tcp.translation() = points[5] + dice.vector(0.4);
  return std::make_shared<const Robot>(test::arm_from_axes(points, directions, tcp, dice));
}

/// Axes 1 and 2 meet, and so do axes 4, 5 and 6.
std::shared_ptr<const Robot> crossed_arm(Dice& dice, bool right_angled) {
  std::array<Eigen::Vector3d, 6> h, p;
  h[0] = dice.rotation().col(2);
  for (std::size_t j = 1; j < 6; ++j) h[j] = at_angle(dice, h[j - 1], right_angled);
  p[0] = p[1] = dice.vector(1);
  p[2] = p[0] - beside(dice, h[2]);
  p[3] = p[4] = p[5] = p[2] + beside(dice, h[2]);
  return arm_of(dice, p, h);
}

/// Axes 2, 3 and 4 are parallel, axes 5 and 6 meet.
std::shared_ptr<const Robot> parallel_arm(Dice& dice, bool right_angled) {
  std::array<Eigen::Vector3d, 6> h, p;
  h[0] = dice.rotation().col(2);
  h[1] = at_angle(dice, h[0], right_angled);
  h[2] = dice.sign() * h[1];
  h[3] = dice.sign() * h[1];
  h[4] = at_angle(dice, h[3], right_angled);
  h[5] = at_angle(dice, h[4], right_angled);
  p[0] = dice.vector(1);
  p[1] = p[0] + dice.vector(0.2);
  p[2] = p[1] + beside(dice, h[1]);
  p[3] = p[2] + beside(dice, h[1]);
  p[4] = p[5] = p[3] + dice.vector(0.2);
  return arm_of(dice, p, h);
}

struct Form {
  std::string name;
  std::shared_ptr<const Robot> (*arm)(Dice&, bool right_angled);
  std::shared_ptr<const InverseKinematics> (*find)(const std::shared_ptr<const Robot>&);
  std::size_t displaced;  ///< a joint whose displacement breaks the form
};

void PrintTo(const Form& form, std::ostream* out) { *out << form.name; }

class ClosedForm : public testing::TestWithParam<Form> {
 protected:
  Dice dice_{1};
  std::vector<JointVector> branches_;
};

TEST_P(ClosedForm, SolvesRandomArmsInAnyConvention) {
  std::size_t most = 0;
  for (int arm = 0; arm < 200; ++arm) {
    const auto robot = GetParam().arm(dice_, arm % 2 == 0);
    const auto solver = GetParam().find(robot);
    ASSERT_NE(solver, nullptr);
    for (int trial = 0; trial < 20; ++trial) {
      const JointVector q = dice_.posture();
      const Pose tcp = tcp_pose(*robot, q);
      solver->solve(tcp, branches_);
      test::expect_valid(*robot, tcp, branches_);
      EXPECT_TRUE(test::contains(branches_, q, 1e-6)) << "arm " << arm << ": " << q.transpose();
      EXPECT_LE(branches_.size(), 8U);
      most = std::max(most, branches_.size());
    }
  }
  EXPECT_EQ(most, 8U);
}

TEST_P(ClosedForm, MissesNoSolutionThatAMultiStartSearchFinds) {
  for (int arm = 0; arm < 6; ++arm) {
    const auto robot = GetParam().arm(dice_, arm % 2 == 0);
    const Pose tcp = tcp_pose(*robot, dice_.posture());
    GetParam().find(robot)->solve(tcp, branches_);
    const std::vector<JointVector> found = test::numeric_solutions(*robot, tcp, dice_, 150);
    EXPECT_GE(found.size(), 2U);
    EXPECT_LE(found.size(), branches_.size());
    for (const JointVector& q : found)
      EXPECT_TRUE(test::contains(branches_, q, 1e-4)) << "arm " << arm << ": " << q.transpose();
  }
}

/// Joints on multiples of a right angle or next to one: stretched elbow, straight wrist, wrist
/// centre on axis 1.
TEST_P(ClosedForm, ReproducesPosesNextToAndAtSingularPostures) {
  int unsolved = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto robot = GetParam().arm(dice_, true);
    JointVector q = dice_.posture();
    for (double& angle : q) {
      const double kind = dice_.uniform(0, 1);
      if (kind > 0.6) continue;
      angle = std::floor(dice_.uniform(-1, 3)) * Dice::kPi / 2;
      if (kind < 0.2) angle += dice_.sign() * std::pow(10, dice_.uniform(-17, -3));
    }
    const Pose tcp = tcp_pose(*robot, q);
    const auto solver = GetParam().find(robot);
    ASSERT_NE(solver, nullptr);
    solver->solve(tcp, branches_);
    unsolved += branches_.empty();
    for (const JointVector& branch : branches_)
      EXPECT_LT(test::pose_error(tcp_pose(*robot, branch), tcp), test::kPoseTolerance);
  }
  EXPECT_EQ(unsolved, 0);
}

TEST_P(ClosedForm, AnswersNothingOutOfReachOrForNan) {
  const auto robot = GetParam().arm(dice_, false);
  const auto solver = GetParam().find(robot);
  for (const double x : {100.0, std::nan("")}) {
    branches_.resize(3);
    Pose far = tcp_pose(*robot, dice_.posture());
    far.translation().x() = x;
    solver->solve(far, branches_);
    EXPECT_TRUE(branches_.empty());
  }
}

TEST_P(ClosedForm, TakesRoundedNumbersAndRefusesOtherArms) {
  const auto ideal = GetParam().arm(dice_, true);
  const auto moved = [&](double by) {
    Robot::Parts parts = ideal->parts();
    for (Joint& joint : parts.joints) joint.origin.translation() += 1e-6 * dice_.vector(1);
    Joint& displaced = parts.joints[GetParam().displaced];
    displaced.origin.translation() +=
        by * displaced.origin.linear().col(0).cross(displaced.origin.linear() * displaced.axis);
    return std::make_shared<const Robot>(parts);
  };
  const auto rounded = moved(0);
  const auto solver = GetParam().find(rounded);
  ASSERT_NE(solver, nullptr);
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const JointVector q = dice_.posture();
    const Pose tcp = tcp_pose(*rounded, q);
    solver->solve(tcp, branches_);
    test::expect_valid(*rounded, tcp, branches_);
    found += test::contains(branches_, q, 1e-6);
  }
  EXPECT_GE(found, 99);  // next to a double root a solution may be lost
  EXPECT_EQ(GetParam().find(moved(0.05)), nullptr);
  EXPECT_EQ(GetParam().find(test::kr5::load()), nullptr);
  EXPECT_EQ(GetParam().find(test::seven_axis_arm().load()), nullptr);
}

INSTANTIATE_TEST_SUITE_P(
    All, ClosedForm,
    testing::Values(Form{"CrossedShoulder", crossed_arm,
                         [](const auto& robot) -> std::shared_ptr<const InverseKinematics> {
                           return CrossedShoulder::find(robot);
                         },
                         4},
                    Form{"ThreeParallelAxes", parallel_arm,
                         [](const auto& robot) -> std::shared_ptr<const InverseKinematics> {
                           return ThreeParallelAxes::find(robot);
                         },
                         5}),
    [](const auto& form) { return form.param.name; });

/// Whichever joint of its shoulder is held, the rest of the seven-axis arm has a closed form.
TEST(CrossedShoulder, ServesTheSevenAxisArm) {
  const auto robot = test::seven_axis_arm().load();
  Dice dice(6);
  std::vector<JointVector> branches;
  for (const std::string joint : {"joint_a1", "joint_a2", "joint_a3"}) {
    const InverseKinematicsFound found = find_redundant_inverse_kinematics(
        robot, {{joint, 0.5}}, {[](const auto& rest) { return find_inverse_kinematics(rest); }});
    ASSERT_NE(found.solver, nullptr) << found.description;
    EXPECT_NE(found.description.find("axes 1 and 2 meet, spherical wrist, closed form"),
              std::string::npos)
        << found.description;
    for (int trial = 0; trial < 100; ++trial) {
      JointVector q = dice.posture(7);
      q[3] = dice.uniform(0.3, 2);
      const Pose tcp = tcp_pose(*robot, q);
      found.solver->solve_beside(tcp, q, branches);
      EXPECT_TRUE(test::contains(branches, q, 1e-6)) << joint << ": " << q.transpose();
      found.solver->solve(tcp, branches);
      for (const JointVector& branch : branches)
        EXPECT_LT(test::pose_error(tcp_pose(*robot, branch), tcp), test::kPoseTolerance);
    }
  }
}

TEST(ThreeParallelAxes, FindsTheSolutionsOfThePublishedClosedForm) {
  const auto robot = test::offset_wrist_arm().load();
  const InverseKinematicsFound found = find_inverse_kinematics(robot);
  EXPECT_NE(found.description.find("axes 2, 3 and 4 parallel, closed form"), std::string::npos)
      << found.description;
  const test::UrClosedForm published = test::ur10e_closed_form();
  Dice dice(7);
  std::vector<JointVector> branches;
  for (int trial = 0; trial < 2000; ++trial) {
    const JointVector q = dice.posture();
    const Pose flange(test::offset_wrist_arm().flange(q));
    found.solver->solve(tcp_pose(*robot, q), branches);
    const auto solutions = published.solve(flange);
    ASSERT_EQ(branches.size(), solutions.size());
    for (const test::UrClosedForm::Angles& angles : solutions)
      EXPECT_TRUE(
          test::contains(branches, Eigen::Map<const Eigen::VectorXd>(angles.data(), 6), 1e-6));
  }
}

}  // namespace
}  // namespace wristwise
