#pragma once

#include <Eigen/Core>
#include <array>

namespace wristwise {

/// A function of s in [-1, 1], enclosed (F29): f(s) = c[0] + c[1] s + c[2] s^2 + c[3] s^3 + r(s),
/// where |f''''(s)| / 4! <= rest for all s, so that |r(s)| <= rest.
struct Taylor {
  static constexpr int kTerms = 4;

  std::array<double, kTerms> c{};
  double rest = 0;

  static Taylor constant(double value) { return {{value, 0, 0, 0}, 0}; }

  /// The largest value for all s, and the least, as far as the enclosure tells.
  double upper() const;
  double lower() const;
};

Taylor operator+(const Taylor& f, const Taylor& g);
Taylor operator-(const Taylor& f, const Taylor& g);
Taylor operator*(double factor, const Taylor& f);
Taylor operator*(const Taylor& f, const Taylor& g);
/// Of a function that is positive; infinite rest where that is not certain.
Taylor square_root(const Taylor& f);
/// 1 / f of a function that is positive; infinite rest where that is not certain.
Taylor reciprocal(const Taylor& f);
/// sum of c_k f^k, k = 0 .. 5.
Taylor polynomial(const std::array<double, 6>& c, const Taylor& f);
/// v(s) with v(0) = 0 and v'(s) = f'(s) g(v(s)), where v stays in [-1, 1].
Taylor driven(const Taylor& f, const Taylor& g);

/// The same for a vector; |f''''(s)| / 4! <= rest in the Euclidean norm.
struct VectorTaylor {
  std::array<Eigen::Vector3d, Taylor::kTerms> c{};
  double rest = 0;

  VectorTaylor() = default;
  VectorTaylor(const std::array<Eigen::Vector3d, Taylor::kTerms>& coefficients, double bound)
      : c(coefficients), rest(bound) {}

  static VectorTaylor constant(const Eigen::Vector3d& value);

  Taylor along(const Eigen::Vector3d& direction) const;
  Taylor coordinate(int k) const;
};

VectorTaylor operator*(const Eigen::Matrix3d& rotation, const VectorTaylor& f);
VectorTaylor operator+(const VectorTaylor& f, const VectorTaylor& g);
VectorTaylor operator-(const VectorTaylor& f, const VectorTaylor& g);
/// f times a fixed vector.
VectorTaylor along(const Eigen::Vector3d& direction, const Taylor& f);

/// Turning about a fixed axis by a given angle (rad), enclosed once for all the vectors it turns.
class TaylorTurn {
 public:
  TaylorTurn(const Eigen::Vector3d& axis, const Taylor& angle);
  VectorTaylor operator*(const VectorTaylor& f) const;

 private:
  Eigen::Vector3d axis_;
  std::array<double, Taylor::kTerms> cosine_{}, sine_{};
  std::array<double, Taylor::kTerms + 1> size_{};  ///< of the turn's own Taylor coefficients
};

}  // namespace wristwise
