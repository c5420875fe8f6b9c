#include "task/enclosed_curve.hpp"

namespace wristwise {

namespace {

constexpr double kUnknown = 1e9;  // m or rad

}  // namespace

VectorTaylor anywhere() {
  VectorTaylor unknown = VectorTaylor::constant(Eigen::Vector3d::Zero());
  unknown.rest = kUnknown;
  return unknown;
}

// Turns about two axes leave no direction in place.
EnclosedOrientation any_orientation() {
  Taylor any = Taylor::constant(0);
  any.rest = kUnknown;
  EnclosedOrientation unknown;
  unknown.before.angle = any;
  unknown.after.push_back({Eigen::Vector3d::UnitX(), any});
  return unknown;
}

VectorTaylor vector_polynomial(const Eigen::Matrix<double, 3, 6>& c, const Taylor& f) {
  VectorTaylor sum = VectorTaylor::constant(Eigen::Vector3d::Zero());
  for (int i = 0; i < 3; ++i) {
    const Taylor value = polynomial({c(i, 0), c(i, 1), c(i, 2), c(i, 3), c(i, 4), c(i, 5)}, f);
    sum = sum + along(Eigen::Vector3d::Unit(i), value);
  }
  return sum;
}

}  // namespace wristwise
