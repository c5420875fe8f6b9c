#include "smoothing/tolerance_ball.hpp"

#include <cmath>

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

// (F51) Rx(a) Ry(b) Rz(c) turns by theta with
//   cos(theta/2) = cos a/2 cos b/2 cos c/2 - sin a/2 sin b/2 sin c/2,
// least on [-h, h]^3 at a = b = c = h. With d = cos h/2 - sin h/2 that is d (3 - d^2) / 2, so that
// theta = angle where d = 2 cos(pi/3 + angle/6); and d = sqrt(2) cos(h/2 + pi/4).
ToleranceBox box_in_ball(double position, double angle) {
  const double p = position / std::sqrt(3.0);
  const double h = 2 * std::acos(std::sqrt(2.0) * std::cos(kPi / 3 + angle / 6)) - kPi / 2;
  ToleranceBox box;
  box.upper << p, p, p, h, h, h;
  box.lower = -box.upper;
  return box;
}

}  // namespace wristwise
