#pragma once

#include <vector>

#include "task/taylor.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// A turn about a fixed axis.
struct EnclosedTurn {
  Eigen::Vector3d axis;  ///< unit
  Taylor angle;          ///< rad
};

/// The orientation turn(before) * start * turn(after[0]) * turn(after[1]) ..., base frame.
struct EnclosedOrientation {
  EnclosedTurn before{Eigen::Vector3d::UnitZ(), Taylor::constant(0)};
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
  std::vector<EnclosedTurn> after{};
};

/// A curve that can be enclosed (F29) while a fraction of its time is.
class EnclosedCurve : public SeamCurve {
 public:
  virtual VectorTaylor position(const Taylor& fraction) const = 0;  ///< base frame, m
  virtual EnclosedOrientation orientation(const Taylor& fraction) const = 0;
};

/// Of which nothing is known: a remainder (m) that no path has, yet finite, so that it may be
/// multiplied by zero.
VectorTaylor anywhere();
EnclosedOrientation any_orientation();  ///< likewise

/// A vector of polynomials: column k is the coefficient of f^k.
VectorTaylor vector_polynomial(const Eigen::Matrix<double, 3, 6>& c, const Taylor& f);

}  // namespace wristwise
