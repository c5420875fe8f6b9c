#include "graph/sample_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graph/sampling_grid.hpp"

namespace wristwise {
namespace {

ToleranceBox some_box() {
  ToleranceBox box;
  box.lower << 0, -0.01, 0.002, -0.1, 0, -ToleranceBox::kFree;
  box.upper << 0, 0.02, 0.002, 0.1, 0, ToleranceBox::kFree;
  return box;
}

TEST(SampleCells, TogetherAreTheBoxAndDoNotOverlap) {
  const ToleranceBox box = some_box();
  Vector6 step;
  step << 0.01, 0.007, 0.01, 0.06, 0.01, 0.8;
  const std::vector<Vector6> grid = sampling_grid(box, step);
  const SampleCells cells(box, grid);
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    Vector6 e;
    for (int k = 0; k < 6; ++k) {
      const bool free = std::isinf(box.lower[k]);
      const double low = free ? -3.14 : box.lower[k], high = free ? 2.7 : box.upper[k];
      e[k] = low == high ? low : std::uniform_real_distribution<double>(low, high)(random);
    }
    int holding = 0;
    for (const Vector6& sample : grid) {
      const ToleranceSample cell = cells.sample(Pose::Identity(), sample);
      EXPECT_TRUE((sample.array() >= cell.lower.array()).all());
      EXPECT_TRUE((sample.array() <= cell.upper.array()).all());
      if ((e.array() >= cell.lower.array()).all() && (e.array() <= cell.upper.array()).all())
        ++holding;
    }
    EXPECT_EQ(holding, 1) << e.transpose();
  }
}

TEST(SampleCells, AFreeAngleIsCoveredAllRound) {
  const ToleranceBox box = some_box();
  Vector6 step = Vector6::Ones();
  const std::vector<Vector6> grid = sampling_grid(box, step);
  const SampleCells cells(box, grid);
  double least = 10, most = -10;
  for (const Vector6& sample : grid) {
    const ToleranceSample cell = cells.sample(Pose::Identity(), sample);
    least = std::min(least, cell.lower[5]);
    most = std::max(most, cell.upper[5]);
  }
  EXPECT_NEAR(most - least, 2 * std::acos(-1.0), 1e-12);
}

TEST(SampleCells, ASingleSampleIsItsOwnCell) {
  const Vector6 alone = Vector6::Constant(0.001);
  const ToleranceSample cell = SampleCells(some_box(), {alone}).sample(Pose::Identity(), alone);
  EXPECT_EQ(cell.lower, alone);
  EXPECT_EQ(cell.upper, alone);
}

}  // namespace
}  // namespace wristwise
