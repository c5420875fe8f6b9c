#include "task/run_curve.hpp"

#include <array>

#include "task/arc_length.hpp"
#include "task/shifted_polynomial.hpp"

namespace wristwise {

namespace {

JointVector joined(const Eigen::Vector3d& position, double angle) {
  JointVector values(4);
  values << position, angle;
  return values;
}

}  // namespace

// The angle follows a rate that rises from zero like a smoothstep: half of duration times full
// rate.
RunCurve::RunCurve(Way way, const PathPoint& end, double speed, const Eigen::Vector3d& rest,
                   double duration)
    : at_seam_(end.frame.linear()) {
  const double rate = speed * end.turning.norm() * duration;  // all derivatives by the fraction
  axis_ = rate > 0 ? end.turning.normalized() : Eigen::Vector3d::UnitZ();
  const double step = speed * duration;
  const double side = way == Way::in ? -1 : 1;
  std::vector<JointVector> positions{joined(rest, side * 0.5 * rate),
                                     joined(end.frame.translation(), 0)};
  std::vector<JointVector> velocities{JointVector::Zero(4), joined(step * end.tangent, rate)};
  std::vector<JointVector> accelerations{JointVector::Zero(4),
                                         joined(step * step * end.curvature, 0)};
  if (way == Way::out) {
    std::swap(positions[0], positions[1]);
    std::swap(velocities[0], velocities[1]);
    std::swap(accelerations[0], accelerations[1]);
  }
  motion_ =
      Trajectory({0, 1}, std::move(positions), std::move(velocities), std::move(accelerations));
  length_ = ArcLength([this](double u) { return motion_.evaluate(u, 1).head<3>().norm(); }).total();
}

Pose RunCurve::frame_at(double fraction) const {
  const JointVector at = motion_.evaluate(fraction);
  Pose frame = Pose::Identity();
  frame.translation() = at.head<3>();
  frame.linear() = Eigen::AngleAxisd(at[3], axis_).toRotationMatrix() * at_seam_;
  return frame;
}

// polynomials(0) runs over [-1, 1].
VectorTaylor RunCurve::position(const Taylor& fraction) const {
  const Eigen::Matrix<double, 3, 6> c = motion_.polynomials(0).topRows<3>();
  const double middle = 2 * fraction.c[0] - 1;
  return vector_polynomial(shifted(c, middle), 2.0 * (fraction - Taylor::constant(fraction.c[0])));
}

EnclosedOrientation RunCurve::orientation(const Taylor& fraction) const {
  const Trajectory::Polynomials all = motion_.polynomials(0);
  std::array<double, 6> c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = all(3, static_cast<Eigen::Index>(k));
  const Taylor angle = polynomial(c, 2.0 * fraction - Taylor::constant(1));
  return {{axis_, angle}, at_seam_, {}};
}

}  // namespace wristwise
