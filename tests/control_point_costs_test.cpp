#include "refine/control_point_costs.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "collision_samples.hpp"
#include "gantry.hpp"
#include "kuka_kr5_arc.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
namespace kr5 = test::kr5;
using test::uniform;
using Kind = PointConstraint::Kind;

const std::vector<double> kBreakpoints = {0, 0.5, 1.2, 2};
constexpr double kTime = 0.8;
constexpr double kMu = 37;

/// What a cost function returns, Jacobians of all blocks side by side.
struct Evaluation {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
};

Evaluation evaluate_at(const ceres::CostFunction& cost, const Eigen::MatrixXd& control) {
  const auto blocks = static_cast<int>(cost.parameter_block_sizes().size());
  const auto joints = control.rows();
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<RowMajor> block(static_cast<std::size_t>(blocks));
  std::vector<double*> jacobians;
  std::vector<const double*> parameters;
  for (int k = 0; k < blocks; ++k) {
    // Stale contents must not survive.
    block[static_cast<std::size_t>(k)].setConstant(cost.num_residuals(), joints, 1e30);
    jacobians.push_back(block[static_cast<std::size_t>(k)].data());
    parameters.push_back(control.col(k).data());
  }
  Evaluation result;
  result.residuals.setConstant(cost.num_residuals(), 1e30);
  EXPECT_TRUE(cost.Evaluate(parameters.data(), result.residuals.data(), jacobians.data()));
  result.jacobian.resize(cost.num_residuals(), blocks * joints);
  for (int k = 0; k < blocks; ++k) {
    result.jacobian.middleCols(k * joints, joints) = block[static_cast<std::size_t>(k)];
  }
  return result;
}

Eigen::VectorXd residuals_at(const ceres::CostFunction& cost, const Eigen::MatrixXd& control) {
  std::vector<const double*> parameters;
  for (Eigen::Index k = 0; k < control.cols(); ++k) parameters.push_back(control.col(k).data());
  Eigen::VectorXd residuals(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(parameters.data(), residuals.data(), nullptr));
  return residuals;
}

/// Against central differences; a missing block must change nothing. Returns the largest entry.
double expect_jacobian(const ceres::CostFunction& cost, const Eigen::MatrixXd& control,
                       double tolerance = 1e-7, double h = 1e-5) {
  const Evaluation exact = evaluate_at(cost, control);
  EXPECT_EQ(residuals_at(cost, control), exact.residuals);
  Eigen::MatrixXd numeric(exact.jacobian.rows(), exact.jacobian.cols());
  for (Eigen::Index i = 0; i < control.size(); ++i) {
    Eigen::MatrixXd above = control, below = control;
    above.data()[i] += h;
    below.data()[i] -= h;
    numeric.col(i) = (residuals_at(cost, above) - residuals_at(cost, below)) / (2 * h);
  }
  const double scale = 1 + numeric.cwiseAbs().maxCoeff();
  EXPECT_LT((exact.jacobian - numeric).cwiseAbs().maxCoeff(), tolerance * scale);

  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<const double*> parameters;
  for (Eigen::Index k = 0; k < control.cols(); ++k) parameters.push_back(control.col(k).data());
  std::vector<double*> jacobians(parameters.size(), nullptr);
  RowMajor last(cost.num_residuals(), control.rows());
  jacobians.back() = last.data();
  Eigen::VectorXd residuals(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(parameters.data(), residuals.data(), jacobians.data()));
  EXPECT_EQ(last, exact.jacobian.rightCols(control.rows()));
  return exact.jacobian.cwiseAbs().maxCoeff();
}

/// Six control points about a posture; it is the spline's value where `spread` is zero.
Eigen::MatrixXd control_about(const JointVector& q, double spread, std::mt19937& random) {
  return q.replicate(1, SplineBasis::kLocal) +
         Eigen::MatrixXd::NullaryExpr(q.size(), SplineBasis::kLocal,
                                      [&] { return uniform(random, -spread, spread); });
}

JointVector random_posture(const Robot& robot, std::mt19937& random) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < q.size(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    q[j] = uniform(random, joint.lower, joint.upper);
  }
  return q;
}

/// Random ones, then two at and next to the wrist singularity.
std::vector<JointVector> kr5_postures(const Robot& robot, std::mt19937& random) {
  std::vector<JointVector> postures;
  for (int i = 0; i < 12; ++i) postures.push_back(random_posture(robot, random));
  postures[10][4] = 0;
  postures[11][4] = 1e-8;
  return postures;
}

/// A frame from which the pose deviates by e.
Pose frame_seen_at(const Pose& tcp, const Vector6& e) {
  Pose offset = Pose::Identity();
  offset.translation() = e.head<3>();
  offset.linear() = (Eigen::AngleAxisd(e[3], Eigen::Vector3d::UnitX()) *
                     Eigen::AngleAxisd(e[4], Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(e[5], Eigen::Vector3d::UnitZ()))
                        .toRotationMatrix();
  return tcp * offset.inverse();
}

std::shared_ptr<const ClearanceModel> no_obstacles(std::shared_ptr<const Robot> robot) {
  Scene scene;
  scene.scope = CollisionScope::off;
  return std::make_shared<const ClearanceModel>(std::move(robot), scene);
}

ToleranceBox box_with_free_spin(ToleranceFrame frame) {
  ToleranceBox box;
  box.frame = frame;
  box.lower << 0, 0, -0.002, -0.1, -0.2, -ToleranceBox::kFree;
  box.upper << 0, 0, 0.004, 0.1, 0.1, ToleranceBox::kFree;
  return box;
}

TEST(ObjectiveCost, Jacobian) {
  std::mt19937 random(1);
  const SplineBasis basis(kBreakpoints);
  CostOptions options;
  options.acceleration = 2;
  options.jerk = 0.5;
  options.joint_weights = {1, 0.3, 2};
  options.preferred_posture = {0.2, -0.4, 1};
  const auto weights = objective_weights(options, 0.7, 3);
  for (const ObjectiveRow& row : objective_rows(weights, basis)) {
    const std::unique_ptr<ceres::CostFunction> cost(objective_cost(row, weights));
    expect_jacobian(*cost, control_about(JointVector::Zero(3), 1, random));
    expect_jacobian(*cost, control_about(JointVector::Ones(3), 0, random), 1e-7, 1e-4);
    // At the preferred posture nothing is left.
    EXPECT_LT(residuals_at(*cost, control_about(weights.posture, 0, random)).norm(), 1e-9);
  }
}

TEST(SingularityCost, Jacobian) {
  std::mt19937 random(10);
  const auto robot = kr5::load();
  for (const JointVector& q : kr5_postures(*robot, random)) {
    const PosturePoint point{kTime, SplineBasis(kBreakpoints).at(kTime), 1.7};
    const std::unique_ptr<ceres::CostFunction> cost(singularity_cost(*robot, point));
    // The KR 5's axes 4 and 6 line up where joint 5 is zero.
    EXPECT_NEAR(residuals_at(*cost, control_about(q, 0, random))[0],
                1.7 * std::pow(std::cos(q[4]), 4), 1e-12);
    expect_jacobian(*cost, control_about(q, 0, random));
    expect_jacobian(*cost, control_about(q, 0.1, random));
  }
}

/// The caller's: one that sees the time, one that sees the TCP; each with its gradient by hand.
std::vector<PostureResidual> two_residuals(const std::shared_ptr<const Robot>& robot) {
  return {[](double t, const JointVector& q, JointVector* gradient) {
            if (gradient != nullptr) *gradient = (2 * q).array() * std::cos(t);
            return q.squaredNorm() * std::cos(t) - 1;
          },
          [robot](double, const JointVector& q, JointVector* gradient) {
            ChainPose chain;
            forward_kinematics(*robot, q, chain);
            if (gradient != nullptr) *gradient = geometric_jacobian(*robot, chain).row(2);
            return chain.tcp.translation().z();
          }};
}

TEST(OwnCost, Jacobian) {
  std::mt19937 random(11);
  const auto robot = kr5::load();
  ObjectiveWeights weights = objective_weights({}, 0.7, 6);
  weights.own = two_residuals(robot);
  for (const JointVector& q : kr5_postures(*robot, random)) {
    const PosturePoint point{kTime, SplineBasis(kBreakpoints).at(kTime), 1.7};
    const std::unique_ptr<ceres::CostFunction> cost(own_cost(weights, point));
    const Eigen::VectorXd residuals = residuals_at(*cost, control_about(q, 0, random));
    EXPECT_NEAR(residuals[0], 1.7 * (q.squaredNorm() * std::cos(kTime) - 1), 1e-11);
    EXPECT_NEAR(residuals[1], 1.7 * kr5::torch_tip(q, 0.3)(2, 3), 1e-12);
    expect_jacobian(*cost, control_about(q, 0, random));
    expect_jacobian(*cost, control_about(q, 0.1, random));
  }
  // Where a value is zero, and next to it.
  for (const double near : {0.0, 1e-8}) {
    weights.own = {[](double, const JointVector& q, JointVector* gradient) {
      if (gradient != nullptr) *gradient = JointVector::Unit(6, 3);
      return q[3];
    }};
    const PosturePoint point{kTime, SplineBasis(kBreakpoints).at(kTime), 1.7};
    const std::unique_ptr<ceres::CostFunction> cost(own_cost(weights, point));
    expect_jacobian(*cost, control_about(JointVector::Constant(6, near), 0, random));
  }
}

TEST(DeviationCost, Jacobian) {
  std::mt19937 random(2);
  const auto robot = kr5::load();
  for (const JointVector& q : kr5_postures(*robot, random)) {
    for (const double deviation : {0.0, 1e-8, 0.3}) {
      DeviationPoint point;
      point.basis = SplineBasis(kBreakpoints).at(kTime);
      point.frame = frame_seen_at(tcp_pose(*robot, q), deviation * Vector6::Ones());
      point.tolerance = box_with_free_spin(ToleranceFrame::path);
      point.sqrt_weights << 0.4, 0.5, 0.6, 0.7, 1.3, 0;
      const std::unique_ptr<ceres::CostFunction> cost(deviation_cost(*robot, point));
      const Eigen::MatrixXd control = control_about(q, 0, random);
      const Eigen::VectorXd residuals = residuals_at(*cost, control);
      EXPECT_LT((residuals - point.sqrt_weights * deviation).norm(), 1e-11);
      EXPECT_GT(expect_jacobian(*cost, control), 0.01);
    }
  }
}

TEST(PointCost, JacobianOfDeviationRows) {
  std::mt19937 random(3);
  const auto robot = kr5::load();
  ClearanceChecker checker(no_obstacles(robot));
  for (const ToleranceFrame frame : {ToleranceFrame::path, ToleranceFrame::base}) {
    for (const JointVector& q : kr5_postures(*robot, random)) {
      for (const double deviation : {0.0, 1e-8, 0.4}) {
        const Pose tcp = tcp_pose(*robot, q);
        Waypoint waypoint;
        waypoint.frame = frame_seen_at(tcp, deviation * Vector6::Ones());
        waypoint.tolerance = box_with_free_spin(frame);
        // Euler angles in the base frame have a singularity of their own.
        if (frame == ToleranceFrame::base && std::abs(tcp.linear()(0, 2)) > 0.95) continue;
        PointConstraint point = constraint_at_waypoint(waypoint, SplineBasis(kBreakpoints));
        point.basis = SplineBasis(kBreakpoints).at(kTime);
        ASSERT_EQ(point.rows.size(), 5U);
        for (auto& row : point.rows) row.bounds.multiplier = kMu * uniform(random, -0.05, 0.05);
        const std::unique_ptr<ceres::CostFunction> cost(point_cost(*robot, checker, point, kMu));
        EXPECT_GT(expect_jacobian(*cost, control_about(q, 0, random), 1e-6), 0.01);
        EXPECT_GT(expect_jacobian(*cost, control_about(q, 0.02, random), 1e-6), 0.01);
      }
    }
  }
}

TEST(PointCost, ARowInsideItsBoundsIsSilent) {
  std::mt19937 random(4);
  const auto robot = kr5::load();
  ClearanceChecker checker(no_obstacles(robot));
  const JointVector q = random_posture(*robot, random);
  Waypoint waypoint;
  waypoint.frame = tcp_pose(*robot, q);
  waypoint.tolerance = gantry::box(0.01, 0.01);
  PointConstraint point = constraint_at_waypoint(waypoint, SplineBasis(kBreakpoints));
  const std::unique_ptr<ceres::CostFunction> cost(point_cost(*robot, checker, point, kMu));
  EXPECT_EQ(expect_jacobian(*cost, control_about(q, 0, random)), 0);
  // A multiplier that presses from below makes the same row active.
  point.rows[1].bounds.multiplier = 0.5 * kMu;
  const Evaluation pressed = evaluate_at(*cost, control_about(q, 0, random));
  EXPECT_NEAR(pressed.residuals[1], std::sqrt(kMu) * 0.49, 1e-9);
  EXPECT_GT(expect_jacobian(*cost, control_about(q, 0, random), 1e-6), 0.01);
}

TEST(PointCost, JacobianOfJointRows) {
  std::mt19937 random(5);
  const auto robot = kr5::load();
  ClearanceChecker checker(no_obstacles(robot));
  Waypoint waypoint;
  const JointVector posture = random_posture(*robot, random);
  waypoint.joints = posture;
  PointConstraint point = constraint_at_waypoint(waypoint, SplineBasis(kBreakpoints));
  point.basis = SplineBasis(kBreakpoints).at(kTime);
  point.rows[2].bounds.multiplier = 3;
  ASSERT_EQ(point.rows.size(), 6U);
  const std::unique_ptr<ceres::CostFunction> cost(point_cost(*robot, checker, point, kMu));
  const Eigen::MatrixXd control = control_about(posture, 0, random);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(6);
  expected[2] = 3 / std::sqrt(kMu);
  EXPECT_LT((residuals_at(*cost, control) - expected).norm(), 1e-12);
  expect_jacobian(*cost, control);
  expect_jacobian(*cost, control_about(posture, 0.5, random));
}

/// A ball beside the torch of the KR 5, nearer and nearer and then inside it.
TEST(PointCost, JacobianOfClearanceRows) {
  std::mt19937 random(6);
  const auto robot = kr5::load();
  int penetrating = 0;
  for (const JointVector& q : kr5_postures(*robot, random)) {
    for (const double distance : {0.1, 0.015, -0.005, -0.03}) {
      constexpr double kTorch = 0.02, kBall = 0.05;  // m, radii
      Pose beside = tcp_pose(*robot, q);
      beside.translation() +=
          beside.linear() * Eigen::Vector3d((kTorch + kBall + distance) * 0.6,
                                            (kTorch + kBall + distance) * 0.8, -0.1);
      Scene scene;
      scene.scope = CollisionScope::pairs;
      scene.pairs = {{"torch", "obstacle"}};
      scene.objects = {gantry::obstacle(Sphere{kBall}, beside.translation().x(),
                                        beside.translation().y(), beside.translation().z())};
      ClearanceChecker checker(std::make_shared<const ClearanceModel>(robot, scene));
      PointConstraint point;
      point.basis = SplineBasis(kBreakpoints).at(kTime);
      add_near_pairs(point, checker, q, 0.2, 0.02);
      ASSERT_FALSE(point.rows.empty());
      const std::unique_ptr<ceres::CostFunction> cost(point_cost(*robot, checker, point, kMu));
      const Eigen::MatrixXd control = control_about(q, 0, random);
      EXPECT_NEAR(residuals_at(*cost, control).cwiseAbs().maxCoeff(),
                  std::sqrt(kMu) * (0.2 - distance), 1e-5);
      EXPECT_GT(expect_jacobian(*cost, control, 1e-4, 1e-4), 0.01);
      if (distance < 0) ++penetrating;
    }
  }
  EXPECT_GT(penetrating, 0);
}

/// Ball against box on the gantry: the gradient is the normal of the face.
TEST(PointCost, ClearanceRowsOfABallAboveABox) {
  std::mt19937 random(7);
  const auto robot = gantry::robot();
  ClearanceChecker checker(
      gantry::clearance(robot, {gantry::obstacle(Box{{1, 1, 0.2}}, 0, 0, -0.1)}));
  const SplineBasis::Values values = SplineBasis(kBreakpoints).at(kTime);
  for (const double height : {0.06, 0.05001, 0.04, 0.0, -0.02}) {
    PointConstraint point;
    point.basis = values;
    point.rows = {{Kind::clearance, 0, {0.03, ToleranceBox::kFree, -0.1 * kMu}},
                  {Kind::joint, 3, {0, 0, 0}}};
    const std::unique_ptr<ceres::CostFunction> cost(point_cost(*robot, checker, point, kMu));
    const Eigen::MatrixXd control = control_about(gantry::posture(0.1, 0.2, height), 0, random);
    const Evaluation found = evaluate_at(*cost, control);
    EXPECT_NEAR(found.residuals[0], std::sqrt(kMu) * (height - 0.05 - 0.1 - 0.03), 1e-5);
    for (int k = 0; k < SplineBasis::kLocal; ++k) {
      EXPECT_NEAR(found.jacobian(0, 4 * k + 2), std::sqrt(kMu) * values.derivatives(k, 0), 1e-6);
      EXPECT_NEAR(found.jacobian(0, 4 * k), 0, 1e-6);
    }
    expect_jacobian(*cost, control, 1e-3, 1e-4);
  }
}

TEST(PointCost, AFarPairIsNotMeasuredAndGivesNothing) {
  std::mt19937 random(8);
  const auto robot = gantry::robot();
  ClearanceChecker checker(gantry::clearance(robot, {gantry::obstacle(Sphere{0.1}, 0, 0, 0)}));
  PointConstraint point;
  point.basis = SplineBasis(kBreakpoints).at(kTime);
  point.rows = {{Kind::clearance, 0, {0.03, ToleranceBox::kFree, 0}}};
  const std::unique_ptr<ceres::CostFunction> cost(point_cost(*robot, checker, point, kMu));
  const auto before = checker.queries();
  EXPECT_EQ(expect_jacobian(*cost, control_about(gantry::posture(1, 0, 0), 0.01, random)), 0);
  EXPECT_EQ(checker.queries(), before);
}

TEST(LimitCost, Jacobian) {
  std::mt19937 random(9);
  Robot::Parts parts = gantry::parts();
  for (Joint& joint : parts.joints) {
    joint.lower = -0.1;
    joint.upper = 0.2;
    joint.max_velocity = 0.5;
    joint.max_acceleration = 2;
    joint.max_jerk = 5;
  }
  parts.joints[1].max_acceleration = gantry::kUnlimited;
  const Robot robot(parts);
  int active = 0, silent = 0;
  for (LimitConstraint& limit : limit_constraints(robot, SplineBasis(kBreakpoints))) {
    for (AugmentedRow& row : limit.rows) row.multiplier = kMu * uniform(random, -1, 1);
    const std::unique_ptr<ceres::CostFunction> cost(limit_cost(limit, 4, kMu));
    const auto blocks = static_cast<Eigen::Index>(cost->parameter_block_sizes().size());
    ASSERT_EQ(blocks, limit.derivative + 1);
    const Eigen::MatrixXd control =
        control_about(JointVector::Zero(4), 0.4, random).leftCols(blocks);
    expect_jacobian(*cost, control, 1e-6, 1e-7);
    const Eigen::VectorXd residuals = residuals_at(*cost, control);
    active += static_cast<int>((residuals.array() != 0).count());
    silent += static_cast<int>((residuals.array() == 0).count());
  }
  EXPECT_GT(active, 20);
  EXPECT_GT(silent, 5);
}

}  // namespace
}  // namespace wristwise
