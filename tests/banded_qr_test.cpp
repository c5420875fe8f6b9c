#include "refine/banded_qr.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>

namespace wristwise {
namespace {

constexpr int kLocal = BandedQr::kLocal;

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// Against one dense factorisation of all rows.
TEST(BandedQr, SolvesLeastSquares) {
  for (const int spans : {1, 2, 9}) {
    const int count = spans + kLocal - 1;
    BandedQr qr(2);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(8 * spans, count), right(8 * spans, 2);
    for (int span = 0; span < spans; ++span) {
      const Eigen::MatrixXd rows = random_matrix(8, kLocal, static_cast<unsigned>(span));
      const Eigen::MatrixXd values = random_matrix(8, 2, static_cast<unsigned>(100 + span));
      dense.block(8 * span, span, 8, kLocal) = rows;
      right.middleRows(8 * span, 8) = values;
      qr.add_span(rows, values);
    }
    const Eigen::MatrixXd expected = dense.colPivHouseholderQr().solve(right);
    EXPECT_LT((back_substituted(qr.finish()) - expected).norm(), 1e-9) << spans;
  }
}

TEST(BandedQr, RowsHaveTheSameNormAsWhatWasHandedIn) {
  constexpr int kSpans = 7;
  BandedQr qr(0);
  const Eigen::MatrixXd control = random_matrix(kSpans + kLocal - 1, 1, 5);
  double expected = 0;
  for (int span = 0; span < kSpans; ++span) {
    const Eigen::MatrixXd rows = random_matrix(span % 3, kLocal, static_cast<unsigned>(span));
    expected += (rows * control.middleRows<kLocal>(span)).squaredNorm();
    qr.add_span(rows, Eigen::MatrixXd(rows.rows(), 0));
  }
  double found = 0;
  const auto rows = qr.finish();
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(kSpans + kLocal - 1));
  for (const BandedQr::Row& row : rows)
    found += (row.coefficients * control.middleRows<kLocal>(row.first)).squaredNorm();
  EXPECT_NEAR(found, expected, 1e-9 * expected);
}

}  // namespace
}  // namespace wristwise
