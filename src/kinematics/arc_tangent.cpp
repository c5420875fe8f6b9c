#include "kinematics/arc_tangent.hpp"

#include <cmath>
#include <limits>

namespace wristwise {

// The direction is mirrored into the octant 0 <= y <= x, where the angle is b = atan(y / x), and
// beyond pi/8 turned back by pi/4: b = pi/4 + atan((y - x) / (y + x)). That leaves |t| <= tan(pi/8)
// for
//   atan t = t + t z P(z),   z = t^2,
// P of degree 10 by Remez' exchange with the weight z, relative error 1.3e-18. Undoing the mirrors
// gives k pi/4 +- atan t with k = 0 .. 4. The double next to pi/4 has 50 bits, so that k times it
// is exact, and what it misses is added to the small terms.
//
// Free of branches, so that the loop is compiled to vector instructions.

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kEighth = 0.78539816339744830962;         // pi/4
constexpr double kEighthRest = 3.0616169978683829431e-17;  // pi/4 - kEighth
constexpr double kTanPi8 = 0.41421356237309504880;         // tan(pi/8)
constexpr double kLarge = 1e300, kShrink = 0x1p-60;        // keeps sums below overflow
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// P(z), in pairs of powers so that few operations wait for one another.
double minimax(double z) {
  const double z2 = z * z, z4 = z2 * z2;
  const double p01 = -0.333333333333331989730 + z * 0.199999999999540537490;
  const double p23 = -0.142857142802463097010 + z * 0.111111107860496498100;
  const double p45 = -0.090908978343663427280 + z * 0.076920616062161874441;
  const double p67 = -0.066631200879870461682 + z * 0.058480070913445116069;
  const double p89 = -0.050398385211730521378 + z * 0.038078169912542559155;
  const double p8910 = p89 - z2 * 0.017922138880121914344;
  return (p01 + z2 * p23) + z4 * ((p45 + z2 * p67) + z4 * p8910);
}

double angle_of_direction(double x, double y) {
  const double across = std::abs(x), up = std::abs(y);
  const double steep = up > across ? -1 : 1;
  const double scale = across + up > kLarge ? kShrink : 1;
  const double least = (up > across ? across : up) * scale;
  const double most_or_zero = (up > across ? up : across) * scale;
  const double most = most_or_zero > kTiny ? most_or_zero : kTiny;  // zero only for no direction
  const double oblique = least > kTanPi8 * most ? 1 : 0;
  const double t = (least - oblique * most) / (most + oblique * least);
  const double z = t * t;
  const double right = std::copysign(1.0, x);
  const double eighths = 2 - right * (2 - (1 - steep * (1 - oblique)));
  const double turn = right * steep * t;
  const double rest = turn * (z * minimax(z)) + eighths * kEighthRest;
  const double angle = std::copysign(eighths * kEighth + (turn + rest), y);
  return angle <= -kPi ? kPi : angle;
}

}  // namespace

void angles_of_directions(std::size_t count, const double* x, const double* y, double* angle) {
  for (std::size_t i = 0; i < count; ++i) angle[i] = angle_of_direction(x[i], y[i]);
}

}  // namespace wristwise
