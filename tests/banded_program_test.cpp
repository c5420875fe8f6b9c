#include "timing/banded_program.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace wristwise {
namespace {

constexpr int kSize = BandedRow::kWidth;

double value(const std::vector<double>& gains, const Eigen::VectorXd& x) {
  double sum = 0;
  for (std::size_t i = 0; i < gains.size(); ++i) sum += gains[i] * x[static_cast<Eigen::Index>(i)];
  return sum;
}

double left_of(const BandedRow& row, const Eigen::VectorXd& x) {
  double sum = 0;
  for (int k = 0; k < kSize; ++k)
    sum += row.weights[static_cast<std::size_t>(k)] * x[row.first + k];
  return sum;
}

/// The best vertex: every choice of as many rows as unknowns, held with equality.
double best_vertex(const std::vector<double>& gains, const std::vector<BandedRow>& rows) {
  double best = -INFINITY;
  std::vector<bool> chosen(rows.size(), false);
  std::fill(chosen.begin(), chosen.begin() + kSize, true);
  do {
    Eigen::MatrixXd a(kSize, kSize);
    Eigen::VectorXd c(kSize);
    int count = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (!chosen[r]) continue;
      for (int k = 0; k < kSize; ++k) a(count, k) = rows[r].weights[static_cast<std::size_t>(k)];
      c[count++] = rows[r].limit;
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
    if (!lu.isInvertible()) continue;
    const Eigen::VectorXd x = lu.solve(c);
    bool inside = true;
    for (const BandedRow& row : rows) inside = inside && left_of(row, x) <= row.limit + 1e-9;
    if (inside) best = std::max(best, value(gains, x));
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return best;
}

std::vector<BandedRow> at_most_one(int count) {
  std::vector<BandedRow> rows;
  for (int i = 0; i < count; ++i) {
    BandedRow row{std::min(i, count - kSize), {}, 1};
    row.weights[static_cast<std::size_t>(i - row.first)] = 1;
    rows.push_back(row);
  }
  return rows;
}

TEST(BandedProgram, FindsTheBestVertex) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> weight(-1, 1), limit(0.1, 1), gain(0.1, 2);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<BandedRow> rows = at_most_one(kSize);
    for (int r = 0; r < 8; ++r) {
      BandedRow row{0, {}, limit(random)};
      for (double& w : row.weights) w = weight(random);
      rows.push_back(row);
    }
    std::vector<double> gains(kSize);
    for (double& g : gains) g = gain(random);
    const std::vector<double> x = maximise(gains, rows, std::vector<double>(kSize, 0.0));
    const Eigen::VectorXd found = Eigen::Map<const Eigen::VectorXd>(x.data(), kSize);
    for (const BandedRow& row : rows) EXPECT_LE(left_of(row, found), row.limit);
    EXPECT_NEAR(value(gains, found), best_vertex(gains, rows), 1e-6) << trial;
  }
}

/// Maximise the sum under x_i <= 1, x_k <= low and |x_i+1 - x_i| <= slope: a tent.
TEST(BandedProgram, FindsATentOverManyUnknowns) {
  constexpr int kCount = 5000, kPeak = 2000;
  constexpr double kLow = 0.01, kSlope = 0.003;
  std::vector<BandedRow> rows = at_most_one(kCount);
  rows[kPeak].limit = kLow;
  for (int i = 0; i + 1 < kCount; ++i) {
    BandedRow up{std::min(i, kCount - kSize), {}, kSlope}, down = up;
    const auto k = static_cast<std::size_t>(i - up.first);
    up.weights[k] = down.weights[k + 1] = -1;
    up.weights[k + 1] = down.weights[k] = 1;
    rows.push_back(up);
    rows.push_back(down);
  }
  const std::vector<double> x =
      maximise(std::vector<double>(kCount, 1.0), rows, std::vector<double>(kCount, 0.005));
  for (int i = 0; i < kCount; ++i) {
    EXPECT_NEAR(x[static_cast<std::size_t>(i)], std::min(1.0, kLow + kSlope * std::abs(i - kPeak)),
                1e-4);
  }
}

}  // namespace
}  // namespace wristwise
