#include "refine/objective.hpp"

#include <gtest/gtest.h>

#include <random>

#include "gantry.hpp"
#include "kuka_kr5_arc.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
namespace kr5 = test::kr5;

CostOptions uneven_cost() {
  CostOptions cost;
  cost.joint_motion = 0.7;
  cost.acceleration = 2;
  cost.jerk = 0.3;
  cost.euler_refine = 5;
  cost.euler_eta = 3;
  cost.position_refine = 7;
  cost.joint_weights = {1, 0.5, 2, 0.1};
  return cost;
}

constexpr double kTau = 0.8;

Spline random_spline(const std::vector<double>& breakpoints, int joints, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Spline spline{SplineBasis(breakpoints), {}};
  spline.control = Eigen::MatrixXd::NullaryExpr(joints, spline.basis.control_count(),
                                                [&] { return 0.3 * normal(random); });
  return spline;
}

/// Composite trapezoid rule on every span, so that no step lies across a jump of a derivative.
template <class Density>
double integral(const std::vector<double>& breakpoints, const Density& density) {
  constexpr int kSteps = 4000;
  double sum = 0;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double h = (breakpoints[i + 1] - breakpoints[i]) / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const double t = breakpoints[i] + k * h;
      sum += 0.5 * h * (density(t) + density(t + h));
    }
  }
  return sum;
}

/// alpha and beta of R = Rx(alpha) Ry(beta) Rz(gamma).
Eigen::Vector2d alpha_beta(const Eigen::Matrix3d& r) {
  return {std::atan2(-r(1, 2), r(2, 2)), std::asin(r(0, 2))};
}

TEST(ObjectiveWeights, FollowTheFormula) {
  const ObjectiveWeights weights = objective_weights(uneven_cost(), kTau, 4);
  EXPECT_DOUBLE_EQ(weights.derivative[1], 0.7);
  EXPECT_DOUBLE_EQ(weights.derivative[2], 2 * 0.64);
  EXPECT_DOUBLE_EQ(weights.derivative[3], 0.3 * 0.4096);
  EXPECT_DOUBLE_EQ(weights.alpha, 5 * 9 / 0.64);
  EXPECT_DOUBLE_EQ(weights.beta, 5 / 0.64);
  EXPECT_DOUBLE_EQ(weights.position, 7 / 0.64);
  EXPECT_EQ(weights.joint[3], 0.1);
  EXPECT_EQ(objective_weights({}, kTau, 6).joint, JointVector::Ones(6));
}

TEST(ObjectiveTerms, OfASplineEqualDenseIntegrals) {
  const std::vector<double> breakpoints = {0, 0.3, 1, 2};
  const Robot robot(gantry::parts());
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 2, 4, gantry::box(1, 1));
  const ObjectiveWeights weights = objective_weights(uneven_cost(), kTau, 4);
  const JointVector w = weights.joint;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Spline spline = random_spline(breakpoints, 4, seed);
    const ObjectiveTerms terms = objective_terms(weights, robot, task, spline);
    const auto motion = [&](int k) {
      return integral(breakpoints, [&](double t) {
        return spline.evaluate(t, k).cwiseProduct(w).squaredNorm();
      });
    };
    EXPECT_NEAR(terms.joint_motion, 0.7 * motion(1), 1e-5 * terms.joint_motion);
    EXPECT_NEAR(terms.acceleration, 2 * 0.64 * motion(2), 1e-5 * terms.acceleration);
    // The jerk of a quintic spline is continuous.
    EXPECT_NEAR(terms.jerk, 0.3 * 0.4096 * motion(3), 1e-5 * terms.jerk);
    // On the gantry alpha is the tilt, and beta is zero. Its square is of degree 10: not exact.
    const double tilt = integral(
        breakpoints, [&](double t) { return spline.evaluate(t)[3] * spline.evaluate(t)[3]; });
    EXPECT_NEAR(terms.euler, 5 * 9 / 0.64 * tilt, 1e-3 * terms.euler);
    const double away = integral(breakpoints, [&](double t) {
      return (spline.evaluate(t).head<3>() - Eigen::Vector3d(t / 2, 0, 0)).squaredNorm();
    });
    EXPECT_NEAR(terms.position, 7 / 0.64 * away, 1e-3 * terms.position);
    EXPECT_NEAR(terms.total(),
                terms.joint_motion + terms.acceleration + terms.jerk + terms.euler + terms.position,
                1e-12 * terms.total());
  }
}

TEST(ObjectiveTerms, EulerTermOfTheKr5EqualsADenseSum) {
  const auto robot = kr5::load();
  const std::vector<double> breakpoints = {0, 1, 2};
  Spline spline = random_spline(breakpoints, 6, 4);
  spline.control *= 0.2;
  JointVector centre(6);
  centre << 0.2, -1.2, 1.4, 0.3, 0.5, -0.2;
  spline.control.colwise() += Eigen::VectorXd(centre);
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 2, 4, gantry::box(1, 1));
  SeamPiece piece = task.seam.pieces().front();
  piece.from = piece.to = Pose(kr5::torch_tip(centre, 0.3));
  task.seam = Seam({piece});
  const ObjectiveWeights weights = objective_weights(uneven_cost(), kTau, 4);
  ObjectiveWeights six = weights;
  six.joint = JointVector::Ones(6);
  const double dense = integral({0, 0.5, 1, 1.5, 2}, [&](double t) {
    const Eigen::Matrix3d tcp = kr5::torch_tip(spline.evaluate(t), 0.3).topLeftCorner<3, 3>();
    const Eigen::Vector2d e = alpha_beta(piece.from.linear().transpose() * tcp);
    return 5 / 0.64 * (9 * e[0] * e[0] + e[1] * e[1]);
  });
  EXPECT_GT(dense, 0.01);
  EXPECT_NEAR(objective_terms(six, *robot, task, spline).euler, dense, 1e-4 * dense);
}

/// Sum of squared k-th differences over h^(2k-1).
TEST(ObjectiveTerms, OfAnEvenPathAreSumsOfSquaredDifferences) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const Robot robot(gantry::parts());
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 3, 20, gantry::box(1, 1));
  JointPath path = gantry::path_along(task);
  for (JointVector& q : path.positions) {
    for (double& value : q) value = normal(random);
  }
  const double h = 3.0 / 20;
  const JointVector w = objective_weights(uneven_cost(), kTau, 4).joint;
  std::vector<JointVector> difference = path.positions;
  std::array<double, 4> sum{};
  for (int k = 1; k <= 3; ++k) {
    for (std::size_t i = 0; i + 1 < difference.size(); ++i) {
      difference[i] = (difference[i + 1] - difference[i]).eval();
    }
    difference.pop_back();
    for (const JointVector& d : difference) {
      sum[static_cast<std::size_t>(k)] += d.cwiseProduct(w).squaredNorm() / std::pow(h, 2 * k - 1);
    }
  }
  const ObjectiveTerms terms =
      objective_terms(objective_weights(uneven_cost(), kTau, 4), robot, task, path);
  EXPECT_NEAR(terms.joint_motion, 0.7 * sum[1], 1e-10 * terms.joint_motion);
  EXPECT_NEAR(terms.acceleration, 2 * 0.64 * sum[2], 1e-10 * terms.acceleration);
  EXPECT_NEAR(terms.jerk, 0.3 * 0.4096 * sum[3], 1e-10 * terms.jerk);
  double tilt = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool end = i == 0 || i + 1 == path.size();
    tilt += (end ? 0.5 : 1) * h * std::pow(path.positions[i][3], 2);
  }
  EXPECT_NEAR(terms.euler, 5 * 9 / 0.64 * tilt, 1e-10 * terms.euler);
}

TEST(ObjectiveTerms, OfAFinePathAndOfItsCurveAgree) {
  const Robot robot(gantry::parts());
  const Spline spline = random_spline({0, 1, 2}, 4, 8);
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 2, 4000, gantry::box(1, 1));
  JointPath path = gantry::path_along(task);
  // Uneven times.
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    path.times[i] += 1e-4 * std::sin(3.0 * static_cast<double>(i));
  }
  for (std::size_t i = 0; i < path.size(); ++i) path.positions[i] = spline.evaluate(path.times[i]);
  const ObjectiveWeights weights = objective_weights(uneven_cost(), kTau, 4);
  const ObjectiveTerms curve = objective_terms(weights, robot, task, spline);
  const ObjectiveTerms points = objective_terms(weights, robot, task, path);
  EXPECT_NEAR(points.joint_motion, curve.joint_motion, 0.01 * curve.joint_motion);
  EXPECT_NEAR(points.acceleration, curve.acceleration, 0.01 * curve.acceleration);
  EXPECT_NEAR(points.jerk, curve.jerk, 0.01 * curve.jerk);
  EXPECT_NEAR(points.euler, curve.euler, 0.01 * curve.euler);
}

TEST(ObjectiveRows, SquaredNormsAreTheIntegral) {
  const std::vector<double> breakpoints = {0, 0.3, 1, 2, 2.1};
  CostOptions cost = uneven_cost();
  for (const bool has_posture : {false, true}) {
    if (has_posture) cost.preferred_posture = {0.3, -1, 0.1, 0.7};
    const ObjectiveWeights weights = objective_weights(cost, kTau, 4);
    for (unsigned seed = 0; seed < 3; ++seed) {
      const Spline spline = random_spline(breakpoints, 4, seed);
      const auto rows = objective_rows(weights, spline.basis);
      ASSERT_EQ(rows.size(), static_cast<std::size_t>(spline.basis.control_count()));
      double found = 0;
      for (const ObjectiveRow& row : rows) {
        const Eigen::MatrixXd off =
            spline.control.middleCols<SplineBasis::kLocal>(row.first).colwise() - weights.posture;
        found += (weights.joint.asDiagonal() * off * row.coefficients.transpose()).squaredNorm();
      }
      const double dense = integral(breakpoints, [&](double t) {
        double density = 0;
        for (int k = 0; k <= 3; ++k) {
          JointVector value = spline.evaluate(t, k);
          if (k == 0) value -= weights.posture;
          density += weights.derivative[static_cast<std::size_t>(k)] *
                     value.cwiseProduct(weights.joint).squaredNorm();
        }
        return density;
      });
      EXPECT_NEAR(found, dense, 1e-4 * dense);
    }
  }
}

TEST(ObjectiveTerms, PostureAndSingularityEqualADenseSum) {
  const auto robot = kr5::load();
  CostOptions cost;
  cost.preferred_posture = {0.1, -1, 1, 0.2, -0.3, 0.4};
  cost.posture = 2;
  cost.singularity_refine = 3;
  const ObjectiveWeights weights = objective_weights(cost, kTau, 6);
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 2, 20, gantry::box(1, 1));
  const Spline spline = random_spline({0, 0.3, 1, 2}, 6, 4);
  const ObjectiveTerms terms = objective_terms(weights, *robot, task, spline);
  double posture = 0, singularity = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const JointVector q = spline.evaluate(2 * (i + 0.5) / kSteps);
    posture += (q - weights.posture).squaredNorm() * 2 / kSteps;
    singularity += std::pow(std::cos(q[4]), 8) * 2 / kSteps;  // axes 4 and 6 meet at joint 5
  }
  EXPECT_NEAR(terms.posture, 2 / (kTau * kTau) * posture, 1e-5 * terms.posture);
  EXPECT_NEAR(terms.singularity, 3 / (kTau * kTau) * singularity, 1e-2 * terms.singularity);
  EXPECT_GT(terms.singularity, 0.01);
}

TEST(DeviationPoints, AreQuadratureOfTheStretchesWithAPrescribedPath) {
  Task task = gantry::task({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 4, 2, gantry::box(0.1, 0.1));
  std::vector<SeamPiece> pieces = task.seam.pieces();
  pieces[1].kind = SeamPiece::Kind::move;
  task.seam = Seam(pieces);
  const ObjectiveWeights weights = objective_weights(uneven_cost(), kTau, 4);
  double alpha = 0, beta = 0;
  for (const DeviationPoint& point : deviation_points(weights, task, SplineBasis({0, 1, 2, 4}))) {
    EXPECT_LT(point.time, 2);
    EXPECT_NEAR(point.frame.translation().x(), point.time / 2, 1e-12);
    alpha += point.sqrt_weights[3] * point.sqrt_weights[3];
    beta += point.sqrt_weights[4] * point.sqrt_weights[4];
  }
  EXPECT_NEAR(alpha, 2 * 5 * 9 / 0.64, 1e-9);
  EXPECT_NEAR(beta, 2 * 5 / 0.64, 1e-9);
  EXPECT_TRUE(deviation_points(objective_weights({}, kTau, 4), task, SplineBasis({0, 4})).empty());
}

/// Of the caller's residuals: a dense integral over a curve, the trapezoidal rule over points.
TEST(ObjectiveTerms, OfTheCallersResiduals) {
  const std::vector<double> breakpoints = {0, 0.3, 1, 2};
  const Robot robot(gantry::parts());
  const Task task = gantry::task({{0, 0, 0}, {1, 0, 0}}, 2, 4, gantry::box(1, 1));
  CostOptions cost;
  cost.posture_residuals = {
      [](double t, const JointVector& q, JointVector*) { return 3 * t * q[1]; },
      [](double, const JointVector& q, JointVector*) { return q[0] - q[3]; }};
  const auto density = [](double t, const JointVector& q) {
    return 9 * t * t * q[1] * q[1] + (q[0] - q[3]) * (q[0] - q[3]);
  };
  const ObjectiveWeights weights = objective_weights(cost, kTau, 4);
  const Spline spline = random_spline(breakpoints, 4, 7);
  const ObjectiveTerms curve = objective_terms(weights, robot, task, spline);
  const double dense =
      integral(breakpoints, [&](double t) { return density(t, spline.evaluate(t)); });
  EXPECT_GT(dense, 0);
  EXPECT_NEAR(curve.own, dense, 1e-3 * dense);
  EXPECT_NEAR(curve.total(), curve.joint_motion + curve.acceleration + curve.jerk + curve.own,
              1e-12 * curve.total());

  const JointPath path{
      {0, 0.5, 1, 1.5, 2},
      {gantry::posture(0, 1, 2, 3), gantry::posture(1, -1, 0, 0), gantry::posture(0, 0.5, 0, 0),
       gantry::posture(2, 0, 0, 1), gantry::posture(0, 1, 0, 0)}};
  double sum = 0;
  for (std::size_t i = 0; i < 5; ++i)
    sum += (i == 0 || i == 4 ? 0.25 : 0.5) * density(path.times[i], path.positions[i]);
  EXPECT_NEAR(objective_terms(weights, robot, task, path).own, sum, 1e-12);
}

}  // namespace
}  // namespace wristwise
