#include "kinematics/arc_tangent.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "random_arm.hpp"

namespace wristwise {
namespace {

using test::Dice;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
constexpr double kLeastNormal = std::numeric_limits<double>::min();
constexpr double kMost = std::numeric_limits<double>::max();

double angle_of(double x, double y) {
  double angle = NAN;
  angles_of_directions(1, &x, &y, &angle);
  return angle;
}

/// Units in the last place of the exact angle, from the wider type of the mathematical library.
double error_in_ulp(double x, double y, double angle) {
  const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  const double size = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(std::abs(static_cast<long double>(angle) - exact)) / ulp;
}

/// pi stands for both ends of the range.
bool is_at_the_cut(double x, double y) { return std::atan2(y, x) <= -kPi; }

void expect_angle(double x, double y) {
  const double angle = angle_of(x, y);
  if (is_at_the_cut(x, y)) {
    EXPECT_EQ(angle, kPi) << x << ", " << y;
  } else {
    EXPECT_LT(error_in_ulp(x, y, angle), 2) << x << ", " << y;
  }
}

TEST(AnglesOfDirections, AreWithinTwoUlpOfTheExactAngle) {
  Dice dice(1);
  for (int trial = 0; trial < 1000000; ++trial) {
    expect_angle(dice.uniform(-1, 1), dice.uniform(-1, 1));
  }
}

TEST(AnglesOfDirections, AreWithinTwoUlpAtEveryMagnitude) {
  Dice dice(2);
  for (int trial = 0; trial < 300000; ++trial) {
    const double x = dice.sign() * std::pow(10, dice.uniform(-307, 308));
    const double near = x * std::pow(10, dice.uniform(-20, 20));
    const double y = trial % 2 == 0 ? dice.sign() * std::pow(10, dice.uniform(-307, 308)) : near;
    if (std::isfinite(y)) expect_angle(x, y);
  }
}

TEST(AnglesOfDirections, AreWithinTwoUlpWhereTheOctantChanges) {
  Dice dice(3);
  for (int eighth = 0; eighth < 16; ++eighth) {
    for (int trial = 0; trial < 20000; ++trial) {
      const double size = std::pow(10, dice.uniform(-5, 5));
      const double angle = eighth * kPi / 8 + dice.sign() * std::pow(10, dice.uniform(-17, -1));
      expect_angle(size * std::cos(angle), size * std::sin(angle));
    }
  }
}

TEST(AnglesOfDirections, AreThoseOfTheLibraryForZerosDenormalsAndTheLargest) {
  const std::vector<double> sizes = {
      0, kDenormal, 3 * kDenormal, kLeastNormal / 2, kLeastNormal, 1e-9,
      1, 1e9,       1e300,         kMost / 2,        kMost};
  for (const double x : sizes) {
    for (const double y : sizes) {
      for (const double sign_x : {1.0, -1.0}) {
        for (const double sign_y : {1.0, -1.0}) expect_angle(sign_x * x, sign_y * y);
      }
    }
  }
}

TEST(AnglesOfDirections, KeepTheSignOfZeroExceptAtMinusPi) {
  EXPECT_FALSE(std::signbit(angle_of(1, 0.0)));
  EXPECT_TRUE(std::signbit(angle_of(1, -0.0)));
  EXPECT_EQ(angle_of(0.0, 0.0), 0);
  EXPECT_EQ(angle_of(-1, 0.0), kPi);
  EXPECT_EQ(angle_of(-1, -0.0), kPi);
  EXPECT_EQ(angle_of(-1, -1e-300), kPi);
  EXPECT_EQ(angle_of(-0.0, -0.0), kPi);
}

TEST(AnglesOfDirections, AreTheSameBitsAtEveryPlaceInTheArray) {
  Dice dice(4);
  std::array<double, 37> x{}, y{}, angle{};
  for (int trial = 0; trial < 1000; ++trial) {
    const auto count = static_cast<std::size_t>(dice.uniform(0, 38));
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = dice.uniform(-1, 1);
      y[i] = dice.uniform(-1, 1);
    }
    angle.fill(7);
    angles_of_directions(count, x.data(), y.data(), angle.data());
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(angle[i], angle_of(x[i], y[i]));
    for (std::size_t i = count; i < angle.size(); ++i) EXPECT_EQ(angle[i], 7);
  }
}

}  // namespace
}  // namespace wristwise
