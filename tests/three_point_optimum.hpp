#pragma once

// What stage 2 minimises, solved in closed form for one coordinate.

#include <Eigen/Dense>
#include <cmath>
#include <complex>

namespace wristwise::test {

/// What holds beside the three values.
struct ThreePointConditions {
  bool rest_at_start = false, rest_at_end = false;
  bool near_zero = false;  ///< q^2 / tau^2 is minimised too
};

/// The least integral of |q'|^2 + tau^2 |q''|^2 + tau^4 |q'''|^2 over [0, m] and [m, T] through
/// three values. Euler-Lagrange: q'' - tau^2 q'''' + tau^4 q^(6) = 0 on both sides, solved by 1, t
/// and exp(r t) with (tau r)^4 - (tau r)^2 + 1 = 0, that is tau r = exp(i (+-30, +-150) deg).
/// With q^2 / tau^2 too: 1 - x + x^2 - x^3 = 0 for x = (tau r)^2, that is x = 1, i, -i and
/// tau r = +-1, exp(i (+-45, +-135) deg).
/// q' to q'''' are continuous at m. At an end q' = q'' = 0 at rest; free: q''' = 0 and
/// q'' = tau^2 q''''.
class ThreePointOptimum {
 public:
  ThreePointOptimum(double middle, double duration, double tau,
                    const ThreePointConditions& conditions = {})
      : middle_(middle), duration_(duration), tau_(tau), near_zero_(conditions.near_zero) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(12, 12);
    const Row zero = Row::Zero();
    int row = 0;
    const auto add = [&](const Row& left, const Row& right) { matrix.row(row++) << left, right; };
    add(basis(0, 0, 0), zero);
    add(basis(0, middle, 0), zero);
    add(zero, basis(1, middle, 0));
    add(zero, basis(1, duration, 0));
    for (int k = 1; k <= 4; ++k) add(basis(0, middle, k), -basis(1, middle, k));
    for (const bool first : {true, false}) {
      add(first ? end_condition(0, 0, conditions.rest_at_start) : zero,
          first ? zero : end_condition(1, duration, conditions.rest_at_end));
      add(first ? end_slope(0, 0, conditions.rest_at_start) : zero,
          first ? zero : end_slope(1, duration, conditions.rest_at_end));
    }
    solver_.compute(matrix);
  }

  /// Sets the three values.
  void pass_through(double start, double middle, double end) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(12);
    right.head<4>() << start, middle, middle, end;
    coefficients_ = solver_.solve(right);
  }

  double value(double t, int derivative = 0) const {
    const int piece = t < middle_ ? 0 : 1;
    return basis(piece, t, derivative) * coefficients_.segment<6>(6 * piece);
  }

  double objective() const {
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double t = duration_ * (i + 0.5) / kSteps;
      sum += std::pow(value(t, 1), 2) + std::pow(tau_ * value(t, 2), 2) +
             std::pow(tau_ * tau_ * value(t, 3), 2);
      if (near_zero_) sum += std::pow(value(t) / tau_, 2);
    }
    return sum * duration_ / kSteps;
  }

 private:
  using Complex = std::complex<double>;
  using Row = Eigen::Matrix<double, 1, 6>;

  Row end_condition(int piece, double t, bool rest) const {
    return rest ? basis(piece, t, 1) : basis(piece, t, 3);
  }
  Row end_slope(int piece, double t, bool rest) const {
    return rest ? basis(piece, t, 2) : Row(basis(piece, t, 2) - tau_ * tau_ * basis(piece, t, 4));
  }

  /// Real and imaginary parts of exp(r (t - t0)), t0 the end at which it is largest.
  Row basis(int piece, double t, int k) const {
    const double begin = piece == 0 ? 0 : middle_, end = piece == 0 ? middle_ : duration_;
    const Complex growing = std::polar(1 / tau_, std::acos(-1.0) / (near_zero_ ? 4 : 6));
    const Complex decaying = -std::conj(growing);
    const Complex up = std::pow(growing, k) * std::exp(growing * (t - end));
    const Complex down = std::pow(decaying, k) * std::exp(decaying * (t - begin));
    double one = k == 0 ? 1 : 0, other = k == 0 ? t : (k == 1 ? 1 : 0);
    if (near_zero_) {
      one = std::pow(1 / tau_, k) * std::exp((t - end) / tau_);
      other = std::pow(-1 / tau_, k) * std::exp((begin - t) / tau_);
    }
    Row row;
    row << one, other, up.real(), up.imag(), down.real(), down.imag();
    return row;
  }

  double middle_, duration_, tau_;
  bool near_zero_;
  Eigen::FullPivLU<Eigen::MatrixXd> solver_;
  Eigen::VectorXd coefficients_;
};

}  // namespace wristwise::test
