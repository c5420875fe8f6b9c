#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace wristwise {

/// A turn about z by its cosine and sine: products and differences without trigonometry.
struct PlanarTurn {
  double cosine = 1;
  double sine = 0;

  /// Onto the direction (x, y); none where that has no length.
  static PlanarTurn onto(double x, double y) {
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return {};
    return {x / length, y / length};
  }
  static PlanarTurn by(double angle) { return {std::cos(angle), std::sin(angle)}; }

  double angle() const { return std::atan2(sine, cosine); }
  PlanarTurn inverse() const { return {cosine, -sine}; }
  PlanarTurn operator*(const PlanarTurn& other) const {
    return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
  }
  Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()};
  }
};

/// Half of an angle in [0, pi] by its cosine and sine: well conditioned at both ends.
class HalfAngle {
 public:
  /// Half the angle whose cosine and sine are in proportion to x and y >= 0.
  static HalfAngle of(double x, double y) {
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return {};
    if (x >= 0) {
      const double cosine = std::sqrt((length + x) / (2 * length));
      return {y / (2 * length * cosine), cosine};
    }
    const double sine = std::sqrt((length - x) / (2 * length));
    return {sine, y / (2 * length * sine)};
  }

  /// From the squares of its sine and cosine up to a common factor; negative ones count as zero.
  static HalfAngle from_squares(double sine_squared, double cosine_squared) {
    const double s = std::max(sine_squared, 0.0);
    const double c = std::max(cosine_squared, 0.0);
    if (!(s + c > 0)) return {};
    return {std::sqrt(s / (s + c)), std::sqrt(c / (s + c))};
  }

  /// The same, with the whole angle kept in [separation, pi - separation].
  HalfAngle kept_off_ends(double separation) const {
    if (!(separation > 0)) return *this;
    const double half = std::atan2(sine, cosine);
    const double least = separation / 2;
    const double most = std::atan2(1.0, 0.0) - least;
    if (half >= least && half <= most) return *this;
    return {std::sin(std::clamp(half, least, most)), std::cos(std::clamp(half, least, most))};
  }

  PlanarTurn whole_turn() const { return {(cosine - sine) * (cosine + sine), 2 * sine * cosine}; }

  double sine = 0;
  double cosine = 1;

 private:
  HalfAngle() = default;
  HalfAngle(double s, double c) : sine(s), cosine(c) {}
};

}  // namespace wristwise
