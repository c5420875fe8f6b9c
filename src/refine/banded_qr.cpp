#include "refine/banded_qr.hpp"

#include <Eigen/QR>
#include <utility>

namespace wristwise {

BandedQr::BandedQr(Eigen::Index right_columns)
    : left_right_(Eigen::MatrixXd::Zero(kLocal, right_columns)) {}

// Span s sees the control points s .. s+5. Its rows are stacked under what earlier spans left for
// these (upper triangular) and factorised; no later span sees control point s, so that the first
// row is final and the rest is handed on, one column to the left.
void BandedQr::add_span(const Rows& rows, const Eigen::MatrixXd& right) {
  Eigen::MatrixXd stacked(kLocal + rows.rows(), kLocal);
  stacked << left_, rows;
  Eigen::MatrixXd stacked_right(kLocal + rows.rows(), left_right_.cols());
  stacked_right << left_right_, right;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(stacked);
  left_ = qr.matrixQR().topRows<kLocal>().triangularView<Eigen::Upper>();
  left_right_ = (qr.householderQ().transpose() * stacked_right).topRows<kLocal>();
  rows_.push_back({span_, left_.row(0), left_right_.row(0)});
  ++span_;
  left_.topLeftCorner<kLocal - 1, kLocal - 1>() =
      left_.bottomRightCorner<kLocal - 1, kLocal - 1>().eval();
  left_.row(kLocal - 1).setZero();
  left_.col(kLocal - 1).setZero();
  left_right_.topRows<kLocal - 1>() = left_right_.bottomRows<kLocal - 1>().eval();
  left_right_.row(kLocal - 1).setZero();
}

std::vector<BandedQr::Row> BandedQr::finish() {
  for (int k = 0; k + 1 < kLocal; ++k) {
    Row row{span_ - 1, {}, left_right_.row(k)};
    row.coefficients << 0, left_.row(k).head<kLocal - 1>();
    rows_.push_back(std::move(row));
  }
  return std::move(rows_);
}

Eigen::MatrixXd back_substituted(const std::vector<BandedQr::Row>& rows) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd solution(count, rows.front().right.cols());
  for (Eigen::Index i = count - 1; i >= 0; --i) {
    const BandedQr::Row& row = rows[static_cast<std::size_t>(i)];
    const auto own = static_cast<int>(i) - row.first;
    Eigen::RowVectorXd rest = row.right;
    for (int k = own + 1; k < BandedQr::kLocal && row.first + k < count; ++k)
      rest -= row.coefficients[k] * solution.row(row.first + k);
    solution.row(i) = rest / row.coefficients[own];
  }
  return solution;
}

}  // namespace wristwise
