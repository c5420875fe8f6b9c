#include "task/taylor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace wristwise {

namespace {

constexpr int kTerms = Taylor::kTerms;

/// Bounds on |f^(k)(s)| / k! for all s, k = 0 .. 4.
using Sizes = std::array<double, kTerms + 1>;

constexpr std::array<std::array<double, kTerms + 1>, kTerms + 1> kBinomial = {
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// (F29) The k-th Taylor coefficient of f about s, as a function of s, is a Taylor polynomial
// itself:
//   |f^(k)(s)| / k! <= sum_{l=k..3} (l over k) |c_l| + (4 over k) rest.
Sizes sizes(const std::array<double, kTerms>& magnitude, double rest) {
  Sizes size{};
  for (int k = 0; k <= kTerms; ++k) {
    for (int l = k; l < kTerms; ++l) size[at(k)] += kBinomial[at(l)][at(k)] * magnitude[at(l)];
    size[at(k)] += kBinomial[kTerms][at(k)] * rest;
  }
  return size;
}

Sizes sizes(const Taylor& f) {
  return sizes({std::abs(f.c[0]), std::abs(f.c[1]), std::abs(f.c[2]), std::abs(f.c[3])}, f.rest);
}

double cubic(const std::array<double, kTerms>& c, double s) {
  return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

}  // namespace

double Taylor::upper() const {
  double largest = std::max(cubic(c, -1), cubic(c, 1));
  const auto raise = [&](double s) {
    if (std::abs(s) < 1) largest = std::max(largest, cubic(c, s));
  };
  // The roots of c1 + 2 c2 s + 3 c3 s^2, by the form that does not cancel.
  const double discriminant = c[2] * c[2] - 3 * c[1] * c[3];
  if (discriminant >= 0) {
    const double sum = -(c[2] + std::copysign(std::sqrt(discriminant), c[2]));
    if (c[3] != 0) raise(sum / (3 * c[3]));
    if (sum != 0) raise(c[1] / sum);
  }
  return largest + rest;
}

double Taylor::lower() const { return -(-1.0 * *this).upper(); }

Taylor operator+(const Taylor& f, const Taylor& g) {
  Taylor sum;
  for (std::size_t k = 0; k < kTerms; ++k) sum.c[k] = f.c[k] + g.c[k];
  sum.rest = f.rest + g.rest;
  return sum;
}

Taylor operator-(const Taylor& f, const Taylor& g) { return f + -1.0 * g; }

Taylor operator*(double factor, const Taylor& f) {
  Taylor product = f;
  for (double& c : product.c) c *= factor;
  product.rest *= std::abs(factor);
  return product;
}

Taylor operator*(const Taylor& f, const Taylor& g) {
  Taylor product;
  for (int k = 0; k < kTerms; ++k) {
    for (int i = 0; i <= k; ++i) product.c[at(k)] += f.c[at(i)] * g.c[at(k - i)];
  }
  const Sizes size_f = sizes(f), size_g = sizes(g);
  for (int i = 0; i <= kTerms; ++i) product.rest += size_f[at(i)] * size_g[at(kTerms - i)];
  return product;
}

// (F29) With r = sqrt f, 2 r_0 r_k = f_k - sum_{i=1..k-1} r_i r_{k-i}, at each s.
Taylor square_root(const Taylor& f) {
  Taylor root;
  const Sizes size_f = sizes(f);
  if (size_f[1] == 0 && f.c[0] >= 0) return Taylor::constant(std::sqrt(f.c[0]));
  const double least = f.lower();
  if (!(least > 0)) {
    root.rest = std::numeric_limits<double>::infinity();
    return root;
  }
  Sizes size{};
  root.c[0] = std::sqrt(f.c[0]);
  for (int k = 1; k <= kTerms; ++k) {
    double inner = 0, inner_size = size_f[at(k)];
    for (int i = 1; i < k; ++i) {
      inner += root.c[at(i)] * root.c[at(k - i)];
      inner_size += size[at(i)] * size[at(k - i)];
    }
    if (k < kTerms) root.c[at(k)] = (f.c[at(k)] - inner) / (2 * root.c[0]);
    size[at(k)] = inner_size / (2 * std::sqrt(least));
  }
  root.rest = size[kTerms];
  return root;
}

// (F29) With r = 1 / f, f_0 r_k = -sum_{i=1..k} f_i r_{k-i}, at each s.
Taylor reciprocal(const Taylor& f) {
  Taylor result;
  const double least = f.lower();
  if (!(least > 0)) {
    result.rest = std::numeric_limits<double>::infinity();
    return result;
  }
  const Sizes size_f = sizes(f);
  Sizes size{};
  result.c[0] = 1 / f.c[0];
  size[0] = 1 / least;
  for (int k = 1; k <= kTerms; ++k) {
    for (int i = 1; i <= k; ++i) {
      size[at(k)] += size_f[at(i)] * size[at(k - i)] / least;
      if (k < kTerms) result.c[at(k)] -= f.c[at(i)] * result.c[at(k - i)] / f.c[0];
    }
  }
  result.rest = size[kTerms];
  return result;
}

Taylor polynomial(const std::array<double, 6>& c, const Taylor& f) {
  Taylor sum = Taylor::constant(c[5]);
  for (std::size_t k = 5; k-- > 0;) sum = sum * f + Taylor::constant(c[k]);
  return sum;
}

// (F29) With w = g(v), k v_k = sum_{m=1..k} m f_m w_{k-m}, and w_k from g_1 .. g_k, v_1 .. v_k.
Taylor driven(const Taylor& f, const Taylor& g) {
  const auto coefficients = [](const Sizes& of_f, const Sizes& of_g) {
    Sizes v{}, w{};
    w[0] = of_g[0];
    for (int k = 1; k <= kTerms; ++k) {
      for (int m = 1; m <= k; ++m)
        v[at(k)] += static_cast<double>(m) / k * of_f[at(m)] * w[at(k - m)];
      if (k == 1) w[1] = of_g[1] * v[1];
      if (k == 2) w[2] = of_g[1] * v[2] + of_g[2] * v[1] * v[1];
      if (k == 3) w[3] = of_g[1] * v[3] + 2 * of_g[2] * v[1] * v[2] + of_g[3] * v[1] * v[1] * v[1];
    }
    return v;
  };
  const auto in_the_middle = [](const Taylor& of) {
    return Sizes{of.c[0], of.c[1], of.c[2], of.c[3], 0};
  };
  const Sizes v = coefficients(in_the_middle(f), in_the_middle(g));
  return {{0, v[1], v[2], v[3]}, coefficients(sizes(f), sizes(g))[kTerms]};
}

VectorTaylor VectorTaylor::constant(const Eigen::Vector3d& value) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return {{value, zero, zero, zero}, 0};
}

Taylor VectorTaylor::along(const Eigen::Vector3d& direction) const {
  Taylor f;
  for (std::size_t k = 0; k < kTerms; ++k) f.c[k] = direction.dot(c[k]);
  f.rest = rest * direction.norm();
  return f;
}

Taylor VectorTaylor::coordinate(int k) const {
  return {{c[0][k], c[1][k], c[2][k], c[3][k]}, rest};
}

VectorTaylor operator*(const Eigen::Matrix3d& rotation, const VectorTaylor& f) {
  VectorTaylor turned;
  for (std::size_t k = 0; k < kTerms; ++k) turned.c[k].noalias() = rotation * f.c[k];
  turned.rest = f.rest;
  return turned;
}

VectorTaylor operator+(const VectorTaylor& f, const VectorTaylor& g) {
  VectorTaylor sum;
  for (std::size_t k = 0; k < kTerms; ++k) sum.c[k] = f.c[k] + g.c[k];
  sum.rest = f.rest + g.rest;
  return sum;
}

VectorTaylor operator-(const VectorTaylor& f, const VectorTaylor& g) {
  VectorTaylor difference;
  for (std::size_t k = 0; k < kTerms; ++k) difference.c[k] = f.c[k] - g.c[k];
  difference.rest = f.rest + g.rest;
  return difference;
}

VectorTaylor along(const Eigen::Vector3d& direction, const Taylor& f) {
  VectorTaylor result;
  for (std::size_t k = 0; k < kTerms; ++k) result.c[k] = f.c[k] * direction;
  result.rest = f.rest * direction.norm();
  return result;
}

// (F29) E = exp(i angle) has E' = i angle' E, hence k E_k = i sum_{m=1..k} m angle_m E_{k-m}.
TaylorTurn::TaylorTurn(const Eigen::Vector3d& axis, const Taylor& angle) : axis_(axis) {
  const Sizes size_angle = sizes(angle);
  cosine_[0] = std::cos(angle.c[0]);
  sine_[0] = std::sin(angle.c[0]);
  size_[0] = 1;
  for (int k = 1; k <= kTerms; ++k) {
    for (int m = 1; m <= k; ++m) {
      const double share = static_cast<double>(m) / k;
      size_[at(k)] += share * size_angle[at(m)] * size_[at(k - m)];
      if (k == kTerms) continue;
      cosine_[at(k)] -= share * angle.c[at(m)] * sine_[at(k - m)];
      sine_[at(k)] += share * angle.c[at(m)] * cosine_[at(k - m)];
    }
  }
}

// (F29) What is along the axis stays; what is across it is multiplied by E in the plane across the
// axis, so that the fourth coefficient has a size of at most rest + sum_{i=1..4} |E_i|
// |across_{4-i}|.
VectorTaylor TaylorTurn::operator*(const VectorTaylor& f) const {
  std::array<Eigen::Vector3d, kTerms> across, ahead;
  std::array<double, kTerms> magnitude{};
  VectorTaylor turned;
  for (std::size_t k = 0; k < kTerms; ++k) {
    const Eigen::Vector3d on_axis = axis_.dot(f.c[k]) * axis_;
    across[k] = f.c[k] - on_axis;
    ahead[k] = axis_.cross(f.c[k]);
    magnitude[k] = across[k].norm();
    turned.c[k] = on_axis;
  }
  for (std::size_t k = 0; k < kTerms; ++k) {
    for (std::size_t i = 0; i <= k; ++i) {
      turned.c[k] += cosine_[i] * across[k - i] + sine_[i] * ahead[k - i];
    }
  }
  const Sizes size_across = sizes(magnitude, f.rest);
  turned.rest = f.rest;
  for (int i = 1; i <= kTerms; ++i) turned.rest += size_[at(i)] * size_across[at(kTerms - i)];
  return turned;
}

}  // namespace wristwise
