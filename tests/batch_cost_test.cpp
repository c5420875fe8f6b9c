#include "refine/batch_cost.hpp"

#include <gtest/gtest.h>

#include <random>

#include "refine/control_point_costs.hpp"

namespace wristwise {
namespace {

constexpr int kJoints = 3;
constexpr int kLocal = SplineBasis::kLocal;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Some of everything that a span may hold: parts of six and of two control points.
struct Example {
  ObjectiveWeights weights;
  ObjectiveRow row{0, Eigen::Matrix<double, 1, kLocal>::LinSpaced(1, 2)};
  LimitConstraint limit;

  Example() {
    weights.joint = JointVector::LinSpaced(kJoints, 1, 3);
    weights.posture = JointVector::Constant(kJoints, 0.1);
    limit.weights = {-2, 5};
    limit.joints = {0, 2};
    limit.scale = {1, 0.5};
    limit.rows = {{-0.1, 0.1, 0.3}, {-10, -5, 0}};
  }
  std::unique_ptr<BatchCost> batch() const {
    auto cost = std::make_unique<BatchCost>(kJoints);
    cost->add(objective_cost(row, weights), 0);
    cost->add(limit_cost(limit, kJoints, 7), 3);
    return cost;
  }
};

Eigen::MatrixXd random_control(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(kJoints, count, [&] { return normal(random); });
}

Eigen::VectorXd residuals(const ceres::CostFunction& cost, const Eigen::MatrixXd& control) {
  std::vector<const double*> blocks;
  for (int k = 0; k < control.cols(); ++k) blocks.push_back(control.col(k).data());
  Eigen::VectorXd result(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(blocks.data(), result.data(), nullptr));
  return result;
}

Eigen::MatrixXd jacobian(const ceres::CostFunction& cost, const Eigen::MatrixXd& control) {
  std::vector<const double*> blocks;
  std::vector<double*> jacobians;
  std::vector<RowMajor> parts(static_cast<std::size_t>(control.cols()));
  for (int k = 0; k < control.cols(); ++k) {
    blocks.push_back(control.col(k).data());
    // Stale contents must not survive.
    parts[static_cast<std::size_t>(k)].setConstant(cost.num_residuals(), kJoints, 1e30);
    jacobians.push_back(parts[static_cast<std::size_t>(k)].data());
  }
  Eigen::VectorXd ignored(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(blocks.data(), ignored.data(), jacobians.data()));
  Eigen::MatrixXd result(cost.num_residuals(), control.size());
  for (int k = 0; k < control.cols(); ++k)
    result.middleCols(k * kJoints, kJoints) = parts[static_cast<std::size_t>(k)];
  return result;
}

Eigen::MatrixXd numeric_jacobian(const ceres::CostFunction& cost, const Eigen::MatrixXd& control) {
  constexpr double h = 1e-6;
  Eigen::MatrixXd result(cost.num_residuals(), control.size());
  for (Eigen::Index i = 0; i < control.size(); ++i) {
    Eigen::MatrixXd above = control, below = control;
    above.data()[i] += h;
    below.data()[i] -= h;
    result.col(i) = (residuals(cost, above) - residuals(cost, below)) / (2 * h);
  }
  return result;
}

TEST(BatchCost, IsItsPartsOneBelowTheOther) {
  const Example example;
  const auto batch = example.batch();
  batch->merge({0, 1, 2, 3, 4, 5});
  ASSERT_EQ(batch->num_residuals(), kJoints + 2);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Eigen::MatrixXd control = random_control(seed, kLocal);
    const std::unique_ptr<ceres::CostFunction> first(objective_cost(example.row, example.weights));
    const std::unique_ptr<ceres::CostFunction> second(limit_cost(example.limit, kJoints, 7));
    Eigen::VectorXd expected(kJoints + 2);
    expected << residuals(*first, control), residuals(*second, control.middleCols(3, 2));
    EXPECT_EQ(residuals(*batch, control), expected);
    EXPECT_LT((jacobian(*batch, control) - numeric_jacobian(*batch, control)).norm(), 1e-6);
  }
}

TEST(BatchCost, SharedControlPointsAddTheirDerivatives) {
  const Example example;
  for (const std::array<int, kLocal>& slots :
       {std::array<int, kLocal>{0, 0, 0, 1, 2, 3}, std::array<int, kLocal>{0, 1, 2, 3, 3, 3},
        std::array<int, kLocal>{0, 0, 0, 1, 1, 1}}) {
    const auto batch = example.batch();
    batch->merge(slots);
    const int count = slots.back() + 1;
    ASSERT_EQ(batch->parameter_block_sizes().size(), static_cast<std::size_t>(count));
    const Eigen::MatrixXd control = random_control(9, count);
    Eigen::MatrixXd spread(kJoints, kLocal);
    for (int k = 0; k < kLocal; ++k)
      spread.col(k) = control.col(slots[static_cast<std::size_t>(k)]);
    const auto plain = example.batch();
    plain->merge({0, 1, 2, 3, 4, 5});
    EXPECT_EQ(residuals(*batch, control), residuals(*plain, spread));
    EXPECT_LT((jacobian(*batch, control) - numeric_jacobian(*batch, control)).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace wristwise
