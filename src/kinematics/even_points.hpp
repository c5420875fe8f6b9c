#pragma once

#include <vector>

namespace wristwise {

/// A sequence of points that fills the unit cube evenly, however many of them are taken: multiples
/// of the powers of the root of x^(d+1) = x + 1 (Roberts 2018).
class EvenPoints {
 public:
  explicit EvenPoints(int dimensions);

  /// In [0, 1).
  double at(int index, int dimension) const;

 private:
  std::vector<double> steps_;
};

}  // namespace wristwise
