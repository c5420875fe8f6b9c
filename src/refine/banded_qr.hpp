#pragma once

#include <Eigen/Core>
#include <vector>

#include "refine/spline.hpp"

namespace wristwise {

/// QR factorisation of least-squares rows that each see the control points of one span, handed in
/// span after span. The Gram matrix is never formed: its condition is the square of that of the
/// rows, which derivatives over short spans make large.
class BandedQr {
 public:
  static constexpr int kLocal = SplineBasis::kLocal;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, kLocal>;

  /// One row of R: the control points first, first + 1, ... and what they are to add up to.
  struct Row {
    int first = 0;
    Eigen::Matrix<double, 1, kLocal> coefficients;
    Eigen::RowVectorXd right;
  };

  explicit BandedQr(Eigen::Index right_columns);

  /// The rows of the next span: rows * [c_s .. c_s+5]^T = right.
  void add_span(const Rows& rows, const Eigen::MatrixXd& right);

  /// All rows of R, as many as control points, in order. Call it once, at the end.
  std::vector<Row> finish();

 private:
  int span_ = 0;
  Eigen::Matrix<double, kLocal, kLocal> left_ = Eigen::Matrix<double, kLocal, kLocal>::Zero();
  Eigen::MatrixXd left_right_;
  std::vector<Row> rows_;
};

/// The control points (one row each) that solve R c = right.
Eigen::MatrixXd back_substituted(const std::vector<BandedQr::Row>& rows);

}  // namespace wristwise
