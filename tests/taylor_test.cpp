// Enclosures (F29) against the functions themselves, at many s.

#include "task/taylor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>

namespace wristwise {
namespace {

constexpr int kSamples = 200;

class Random {
 public:
  explicit Random(unsigned seed) : rng_(seed) {}
  double in(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng_);
  }
  Eigen::Vector3d vector() { return {in(-1, 1), in(-1, 1), in(-1, 1)}; }

 private:
  std::mt19937 rng_;
};

/// A polynomial of degree 6 and its enclosure; every derivative of it is known.
struct Known {
  std::array<double, 7> p{};
  double operator()(double s) const {
    double value = 0;
    for (std::size_t k = p.size(); k-- > 0;) value = value * s + p[k];
    return value;
  }
  Taylor enclosed() const {
    return {{p[0], p[1], p[2], p[3]}, std::abs(p[4]) + 5 * std::abs(p[5]) + 15 * std::abs(p[6])};
  }
};

Known random_function(Random& random, double size) {
  Known known;
  for (double& c : known.p) c = random.in(-size, size);
  return known;
}

void expect_encloses(const Taylor& f, const std::function<double(double)>& truth) {
  double largest = -INFINITY, least = INFINITY;
  for (int i = 0; i <= kSamples; ++i) {
    const double s = -1 + 2.0 * i / kSamples;
    const double cubic = f.c[0] + s * (f.c[1] + s * (f.c[2] + s * f.c[3]));
    EXPECT_LE(std::abs(truth(s) - cubic), f.rest * std::pow(s, 4) + 1e-13);
    largest = std::max(largest, truth(s));
    least = std::min(least, truth(s));
  }
  EXPECT_GE(f.upper(), largest - 1e-13);
  EXPECT_LE(f.lower(), least + 1e-13);
  EXPECT_LE(f.upper(), largest + 2 * f.rest + 1e-3 * std::abs(largest - least) + 1e-13);
}

TEST(Taylor, SumsProductsAndRootsAreEnclosed) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const double size = std::pow(10, random.in(-3, 0));
    const Known f = random_function(random, size), g = random_function(random, size);
    expect_encloses(f.enclosed(), f);
    expect_encloses(f.enclosed() - 0.7 * g.enclosed(), [&](double s) { return f(s) - 0.7 * g(s); });
    expect_encloses(f.enclosed() * g.enclosed(), [&](double s) { return f(s) * g(s); });
    const Taylor root = square_root(Taylor::constant(1) + 0.02 * f.enclosed());
    expect_encloses(root, [&](double s) { return std::sqrt(1 + 0.02 * f(s)); });
    EXPECT_TRUE(std::isfinite(root.rest));
  }
}

TEST(Taylor, ARootThatMayVanishIsNotEnclosed) {
  EXPECT_TRUE(std::isinf(square_root(Taylor{{0.5, 0.6, 0, 0}, 0}).rest));
  EXPECT_EQ(square_root(Taylor::constant(0)).rest, 0);
  EXPECT_EQ(square_root(Taylor::constant(4)).c[0], 2);
}

/// The rest shrinks with the fourth power of the interval.
TEST(Taylor, TheRestIsOfFourthOrder) {
  Random random(2);
  const Known f = random_function(random, 1);
  const auto rest = [&](double width) {
    Known narrow = f;
    for (std::size_t k = 0; k < narrow.p.size(); ++k) narrow.p[k] *= std::pow(width, k);
    const TaylorTurn turn(Eigen::Vector3d::UnitZ(), narrow.enclosed());
    return (turn * VectorTaylor::constant({1, 1, 0})).rest;
  };
  EXPECT_NEAR(rest(1e-2) / rest(5e-3), 16, 1);
}

TEST(TaylorTurn, TurnedVectorsAreEnclosed) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const double size = std::pow(10, random.in(-2, 0));
    const Eigen::Vector3d axis = random.vector().normalized();
    const Known angle = random_function(random, size);
    std::array<Known, 3> x;
    VectorTaylor enclosed;
    double rest = 0;
    for (int k = 0; k < 3; ++k) {
      x[static_cast<std::size_t>(k)] = random_function(random, size);
      const Taylor f = x[static_cast<std::size_t>(k)].enclosed();
      for (std::size_t m = 0; m < 4; ++m) enclosed.c[m][k] = f.c[m];
      rest += f.rest * f.rest;
    }
    enclosed.rest = std::sqrt(rest);
    const VectorTaylor turned = TaylorTurn(axis, angle.enclosed()) * enclosed;
    for (int k = 0; k < 3; ++k) {
      expect_encloses(turned.coordinate(k), [&](double s) {
        const Eigen::Vector3d at(x[0](s), x[1](s), x[2](s));
        return (Eigen::AngleAxisd(angle(s), axis) * at)[k];
      });
    }
  }
}

}  // namespace
}  // namespace wristwise
