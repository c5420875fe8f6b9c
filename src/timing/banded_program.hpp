#pragma once

#include <array>
#include <vector>

namespace wristwise {

/// sum_k weights[k] x[first + k] <= limit
struct BandedRow {
  static constexpr int kWidth = 6;
  int first = 0;
  std::array<double, kWidth> weights{};
  double limit = 0;
};

/// The x that maximises sum_i gains[i] x[i] under the rows, by Mehrotra's predictor-corrector
/// interior-point method; each step is a Cholesky factorisation of a few diagonals, so that the
/// time is linear in the rows (S. Wright, Primal-Dual Interior-Point Methods, 1997, ch. 10). The
/// result keeps every row, however the method ends, and is within about 1e-9 of the rows it is
/// pressed to.
/// @pre start, of at least BandedRow::kWidth values, keeps every row with room to spare; the rows
/// bound each x from above
std::vector<double> maximise(const std::vector<double>& gains, const std::vector<BandedRow>& rows,
                             const std::vector<double>& start);

}  // namespace wristwise
