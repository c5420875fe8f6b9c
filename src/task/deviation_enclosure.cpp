#include "task/deviation_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Infinite where remainders have grown beyond all numbers.
double largest_magnitude(const Taylor& f) {
  const double largest = std::max(f.upper(), -f.lower());
  return std::isnan(largest) ? std::numeric_limits<double>::infinity() : largest;
}

}  // namespace

DeviationEnclosure::DeviationEnclosure(const Robot& robot, const MotionPiece::Polynomials& joints,
                                       const Seam& seam, double t0, double t1,
                                       const ToleranceBox& box)
    : box_(box), order_(euler_axes(box.sequence())) {
  std::array<bool, 3> axes{};
  const auto is_bounded = [&](int k) {
    return !box.is_free(3 + order_[static_cast<std::size_t>(k)]);
  };
  const auto need = [&](int k) {
    axes[static_cast<std::size_t>(order_[static_cast<std::size_t>(k)])] = true;
  };
  if (is_bounded(0) || is_bounded(1)) need(2);
  if (is_bounded(2)) {
    need(0);
    need(1);
  }
  PoseTaylor tcp = tcp_taylor(robot, joints, axes);
  const FrameTaylor frame(seam, t0, t1);
  if (box.frame == ToleranceFrame::base) {
    position_ = tcp.position - frame.position();
  } else {
    position_ = frame.point(tcp.position);
    for (std::size_t k = 0; k < 3; ++k) {
      if (axes[k]) tcp.axes[k] = frame.direction(tcp.axes[k]);
    }
  }
  enclose_angles(tcp, frame);
}

// (F30) By (F1), with the axes in the order of the sequence,
//   cos b (cos a, sin a) = (M22, -M12),  sin b = M02,  cos b (cos c, sin c) = (M00, -M01).
// In the base frame the difference of two such angles has the cosine and the sine
//   x x' + y y',  y x' - x y'.
void DeviationEnclosure::enclose_angles(const PoseTaylor& tcp, const FrameTaylor& frame) {
  const auto element = [&](const std::array<VectorTaylor, 3>& axes, std::size_t row,
                           std::size_t column) {
    return axes[static_cast<std::size_t>(order_[column])].coordinate(order_[row]);
  };
  const bool in_base = box_.frame == ToleranceFrame::base;
  std::array<VectorTaylor, 3> nominal;
  if (in_base) {
    for (int k = 0; k < 3; ++k) nominal[static_cast<std::size_t>(k)] = frame.axis(k);
  }
  const auto angle = [&](std::size_t row, std::size_t column, std::size_t cosine_at) {
    Angle of_tcp{element(tcp.axes, cosine_at, cosine_at), -1.0 * element(tcp.axes, row, column)};
    if (!in_base) return of_tcp;
    const Taylor cosine = element(nominal, cosine_at, cosine_at);
    const Taylor sine = -1.0 * element(nominal, row, column);
    return Angle{of_tcp.cosine * cosine + of_tcp.sine * sine,
                 of_tcp.sine * cosine - of_tcp.cosine * sine};
  };
  if (!box_.is_free(3 + order_[0])) first_ = angle(1, 2, 2);
  if (!box_.is_free(3 + order_[2])) last_ = angle(0, 1, 0);
  if (box_.is_free(3 + order_[1])) return;
  middle_sine_ = element(tcp.axes, 0, 2);
  nominal_cosine_ = Taylor::constant(1);
  if (in_base) {
    nominal_sine_ = element(nominal, 0, 2);
    nominal_cosine_ = square_root(Taylor::constant(1) - nominal_sine_ * nominal_sine_);
  }
}

bool DeviationEnclosure::inside(const ToleranceBox& box) const {
  for (int k = 0; k < 3; ++k) {
    const Taylor x = position_.coordinate(k);
    if (!(x.upper() <= box.upper[k] && x.lower() >= box.lower[k])) return false;
  }
  const auto bounds = [&](std::size_t k) {
    return std::pair(box.lower[3 + order_[k]], box.upper[3 + order_[k]]);
  };
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
    if (box_.is_free(3 + order_[k])) continue;
    const auto [lower, upper] = bounds(k);
    if (!(k == 0 ? first_ : last_).inside(lower, upper)) return false;
  }
  if (box_.is_free(3 + order_[1])) return true;
  const auto [lower, upper] = bounds(1);
  return middle_inside(lower, upper);
}

// (F30) With r >= 0 the factor, r sin(a - upper) <= 0 says that a lies in the half turn below
// `upper`, r sin(lower - a) <= 0 in the half turn above `lower`. An arc of up to half a turn is
// what these have in common; a larger one is what at least one of them holds.
bool DeviationEnclosure::Angle::inside(double lower, double upper) const {
  lower = std::max(lower, -kPi);
  upper = std::min(upper, kPi);
  if (lower > upper) return false;
  if (upper - lower >= 2 * kPi) return true;
  const auto is_below = [&] {
    return (std::cos(upper) * sine - std::sin(upper) * cosine).upper() <= 0;
  };
  const auto is_above = [&] {
    return (std::sin(lower) * cosine - std::cos(lower) * sine).upper() <= 0;
  };
  return upper - lower <= kPi ? is_below() && is_above() : is_below() || is_above();
}

double DeviationEnclosure::Angle::largest() const {
  const double least_cosine = cosine.lower();
  if (!(least_cosine > 0)) return kPi;
  return std::atan2(largest_magnitude(sine), least_cosine);
}

// (F30) With b, b' in [-pi/2, pi/2] and B = b' + upper: b <= B where sin b <= sin B, unless
// B < -pi/2; where B > pi/2 it holds anyway. Likewise below.
bool DeviationEnclosure::middle_inside(double lower, double upper) const {
  const double least = std::asin(std::clamp(nominal_sine_.lower(), -1.0, 1.0));
  const double largest = std::asin(std::clamp(nominal_sine_.upper(), -1.0, 1.0));
  const auto sine_of_nominal_plus = [&](double angle) {
    return std::cos(angle) * nominal_sine_ + std::sin(angle) * nominal_cosine_;
  };
  const bool is_below =
      least + upper >= kPi / 2 ||
      (least + upper >= -kPi / 2 && (middle_sine_ - sine_of_nominal_plus(upper)).upper() <= 0);
  if (!is_below) return false;
  return largest + lower <= -kPi / 2 ||
         (largest + lower <= kPi / 2 && (sine_of_nominal_plus(lower) - middle_sine_).upper() <= 0);
}

double DeviationEnclosure::distance() const {
  Eigen::Vector3d size;
  for (int k = 0; k < 3; ++k) size[k] = largest_magnitude(position_.coordinate(k));
  return size.norm();
}

double DeviationEnclosure::angle() const {
  double largest = 0;
  if (!box_.is_free(3 + order_[0])) largest = std::max(largest, first_.largest());
  if (!box_.is_free(3 + order_[2])) largest = std::max(largest, last_.largest());
  if (box_.is_free(3 + order_[1])) return largest;
  const Taylor one = Taylor::constant(1);
  const Taylor cosine = square_root(one - middle_sine_ * middle_sine_);
  const Angle middle{cosine * nominal_cosine_ + middle_sine_ * nominal_sine_,
                     middle_sine_ * nominal_cosine_ - cosine * nominal_sine_};
  return std::max(largest, middle.largest());
}

}  // namespace wristwise
