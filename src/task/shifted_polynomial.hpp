#pragma once

namespace wristwise {

/// The coefficients about another point: sum of c_k (x + s)^k, k = 0 .. 5, as a polynomial in s, by
/// repeated synthetic division. Column k: c_k, one row for each polynomial.
template <class Coefficients>
Coefficients shifted(Coefficients c, double x) {
  for (int from = 0; from < 5; ++from) {
    for (int k = 4; k >= from; --k) c.col(k) += x * c.col(k + 1);
  }
  return c;
}

}  // namespace wristwise
