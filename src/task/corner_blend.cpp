#include "task/corner_blend.hpp"

namespace wristwise {

namespace {

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
  frame.linear() = orientation(fraction);
  return frame;
}

// (F25) Three turns about fixed axes: the rate of the first falls to zero, that of the last rises
// from it.
Eigen::Matrix3d CornerBlend::orientation(double fraction) const {
  const Eigen::Matrix3d before = turned((fraction - risen(fraction)) * before_, start_);
  const Eigen::AngleAxisd gap(smooth_step(fraction) * gap_.angle(), gap_.axis());
  return before * gap.toRotationMatrix() *
         turned(risen(fraction) * after_, Eigen::Matrix3d::Identity());
}

}  // namespace wristwise
