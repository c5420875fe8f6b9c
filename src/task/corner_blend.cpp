#include "task/corner_blend.hpp"

#include <algorithm>
#include <cmath>

#include "task/shifted_polynomial.hpp"

namespace wristwise {

namespace {

constexpr double kSafety = 1 + 1e-9;  // of an interval, for round-off
constexpr double kLeastWidth = 1e-9;  // likewise

using Controls = std::array<Eigen::Vector3d, 6>;

/// Three control points that leave `point` by its tangent and its curvature k, towards the corner
/// at the signed distance d. There the first derivative of a quintic is 5 (p1 - p0) = 5/2 d t, the
/// second 20 (p2 - 2 p1 + p0), so p2 lies (5/2 d)^2 / 20 k = 5/16 d^2 k off the tangent.
std::array<Eigen::Vector3d, 3> end_controls(const PathPoint& point, double d) {
  const Eigen::Vector3d p = point.frame.translation();
  return {p, p + 0.5 * d * point.tangent,
          p + d * point.tangent + 5.0 / 16.0 * d * d * point.curvature};
}

Controls blend_controls(const PathPoint& from, const PathPoint& to, double distance) {
  const auto first = end_controls(from, distance), last = end_controls(to, -distance);
  return {first[0], first[1], first[2], last[2], last[1], last[0]};
}

/// De Casteljau's scheme on `count` points.
template <std::size_t Count>
Eigen::Vector3d bezier(std::array<Eigen::Vector3d, Count> points, double u) {
  for (std::size_t left = Count - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) points[i] += u * (points[i + 1] - points[i]);
  return points[0];
}

/// Column k: the coefficient of u^k, the k-th difference times 5 over k.
Eigen::Matrix<double, 3, 6> power_form(Controls points) {
  constexpr std::array<double, 6> kBinomial = {1, 5, 10, 10, 5, 1};
  Eigen::Matrix<double, 3, 6> c;
  for (std::size_t k = 0; k < 6; ++k) {
    c.col(static_cast<Eigen::Index>(k)) = kBinomial[k] * points[0];
    for (std::size_t i = 0; i + k + 1 < 6; ++i) points[i] = points[i + 1] - points[i];
  }
  return c;
}

double bezier_speed(const Controls& control, double u) {
  std::array<Eigen::Vector3d, 5> steps;
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = 5 * (control[i + 1] - control[i]);
  return bezier(steps, u).norm();
}

Eigen::Matrix3d turned(const Eigen::Vector3d& turn, const Eigen::Matrix3d& rotation) {
  const double angle = turn.norm();
  if (angle == 0) return rotation;
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * rotation;
}

double smooth_step(double x) { return x * x * x * (10 + x * (-15 + 6 * x)); }

/// Its integral from 0 to x; 1/2 at 1.
double risen(double x) { return x * x * x * x * (2.5 + x * (-3 + x)); }

}  // namespace

CornerBlend::CornerBlend(const PathPoint& from, const PathPoint& to, double distance)
    : start_(from.frame.linear()),
      control_(blend_controls(from, to, distance)),
      arc_length_([control = control_](double u) { return bezier_speed(control, u); }),
      before_(length() * from.turning),
      after_(length() * (to.frame.linear().transpose() * to.turning)) {
  // At the end: turned(before / 2, start) gap turned(after / 2) = to.
  gap_ = turned(0.5 * before_, start_).transpose() * to.frame.linear() *
         turned(0.5 * after_, Eigen::Matrix3d::Identity()).transpose();
}

Pose CornerBlend::frame_at(double fraction) const {
  Pose frame = Pose::Identity();
  frame.translation() = bezier(control_, arc_length_.parameter_at(fraction * length()));
  frame.linear() = orientation_at(fraction);
  return frame;
}

// (F25) Three turns about fixed axes: the rate of the first falls to zero, that of the last rises
// from it.
Eigen::Matrix3d CornerBlend::orientation_at(double fraction) const {
  const Eigen::Matrix3d before = turned((fraction - risen(fraction)) * before_, start_);
  const Eigen::AngleAxisd gap(smooth_step(fraction) * gap_.angle(), gap_.axis());
  return before * gap.toRotationMatrix() *
         turned(risen(fraction) * after_, Eigen::Matrix3d::Identity());
}

// The parameter u goes on by u' = l' / |B'(u)| with the length l. Over an interval that u does not
// leave, v runs from -1 to 1.
VectorTaylor CornerBlend::position(const Taylor& fraction) const {
  const Taylor reached = length() * fraction;
  const double middle = arc_length_.parameter_at(reached.c[0]);
  const double width =
      kSafety * std::max({arc_length_.parameter_at(reached.upper()) - middle,
                          middle - arc_length_.parameter_at(reached.lower()), kLeastWidth});
  const Eigen::Matrix<double, 3, 6> c = shifted(power_form(control_), middle);
  const Taylor v{{0, 1, 0, 0}, 0};
  Taylor square = Taylor::constant(0);
  for (int i = 0; i < 3; ++i) {
    const Taylor slope =
        polynomial({c(i, 1), 2 * c(i, 2), 3 * c(i, 3), 4 * c(i, 4), 5 * c(i, 5), 0}, width * v);
    square = square + slope * slope;
  }
  const Taylor step = driven(reached, (1 / width) * reciprocal(square_root(square)));
  if (!std::isfinite(step.rest)) return anywhere();  // |B'| may be zero, as far as can be told
  return vector_polynomial(c, width * step);
}

EnclosedOrientation CornerBlend::orientation(const Taylor& fraction) const {
  const auto turn = [](const Eigen::Vector3d& by, const Taylor& share) -> EnclosedTurn {
    const double angle = by.norm();
    if (angle == 0) return {Eigen::Vector3d::UnitZ(), Taylor::constant(0)};
    return {by / angle, angle * share};
  };
  const Taylor square = fraction * fraction;
  const Taylor part =
      square * square * (Taylor::constant(2.5) + fraction * (fraction - Taylor::constant(3)));
  const Taylor step = polynomial({0, 0, 0, 10, -15, 6}, fraction);
  return {turn(before_, fraction - part),
          start_,
          {{gap_.axis(), gap_.angle() * step}, turn(after_, part)}};
}

}  // namespace wristwise
