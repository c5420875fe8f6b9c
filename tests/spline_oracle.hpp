#pragma once

// Stage 2's formulation on small problems, written down once more from the textbook and from the
// robot's facts, and solved by NLopt's SLSQP. Nothing of src/refine is used.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlopt.hpp>
#include <utility>
#include <vector>

namespace wristwise::test::oracle {

/// B-splines of degree 5 on clamped knots, by the recursion of Cox and de Boor.
class Basis {
 public:
  explicit Basis(const std::vector<double>& breakpoints) {
    knots_.assign(5, breakpoints.front());
    knots_.insert(knots_.end(), breakpoints.begin(), breakpoints.end());
    knots_.insert(knots_.end(), 5, breakpoints.back());
  }

  int count() const { return static_cast<int>(knots_.size()) - 6; }

  /// k-th derivatives of all functions at t.
  Eigen::VectorXd at(double t, int k) const {
    Eigen::VectorXd values(count());
    for (int i = 0; i < count(); ++i) values[i] = function(i, 5, t, k);
    return values;
  }

  /// Rows: the control points of the k-th derivative, from those of the curve (de Boor).
  Eigen::MatrixXd derivative_control(int k) const {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Identity(count(), count());
    for (int order = 1; order <= k; ++order) {
      const int degree = 6 - order;
      Eigen::MatrixXd next(rows.rows() - 1, count());
      for (int i = 0; i < next.rows(); ++i) {
        const double width = knot(i + degree + order) - knot(i + order);
        next.row(i) = degree * (rows.row(i + 1) - rows.row(i)) / width;
      }
      rows = std::move(next);
    }
    return rows;
  }

  /// Integral of sum_k weight[k] |N^(k)|^2 as a matrix, by Simpson's rule.
  Eigen::MatrixXd gram(const std::vector<double>& weight) const {
    constexpr int kSteps = 64;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(count(), count());
    for (int s = 5; s < count(); ++s) {
      const double h = (knot(s + 1) - knot(s)) / kSteps;
      for (int i = 0; i <= kSteps; ++i) {
        const double share = (i == 0 || i == kSteps) ? 1 : i % 2 == 1 ? 4 : 2;
        // The third derivative of a quintic with single knots has no jump: either side will do.
        const double t = knot(s) + h * i;
        for (int k = 1; k <= 3; ++k) {
          const Eigen::VectorXd n = at(t, k);
          sum += share * h / 3 * weight[static_cast<std::size_t>(k)] * n * n.transpose();
        }
      }
    }
    return sum;
  }

 private:
  double knot(int i) const { return knots_[static_cast<std::size_t>(i)]; }

  double function(int i, int degree, double t, int k) const {
    const auto share = [](double above, double below) { return below > 0 ? above / below : 0; };
    if (k > 0) {
      return degree *
             (share(function(i, degree - 1, t, k - 1), knot(i + degree) - knot(i)) -
              share(function(i + 1, degree - 1, t, k - 1), knot(i + degree + 1) - knot(i + 1)));
    }
    if (degree == 0) {
      const bool last = t >= knots_.back() && knot(i) < knot(i + 1) && knot(i + 1) >= knots_.back();
      return last || (knot(i) <= t && t < knot(i + 1)) ? 1 : 0;
    }
    return share(t - knot(i), knot(i + degree) - knot(i)) * function(i, degree - 1, t, 0) +
           share(knot(i + degree + 1) - t, knot(i + degree + 1) - knot(i + 1)) *
               function(i + 1, degree - 1, t, 0);
  }

  std::vector<double> knots_;
};

/// Values at one time that must be zero, or must not be positive, as functions of the posture.
struct Station {
  double time = 0;
  std::function<Eigen::VectorXd(const Eigen::VectorXd& q)> values;
};

struct Formulation {
  Basis basis;
  double smoothing_time = 0;                 ///< s
  std::vector<Station> zero, not_positive;   ///< m and rad
  Eigen::VectorXd lower, upper;              ///< of the joints: rad
  std::vector<Eigen::VectorXd> rate_limits;  ///< of q', q'', q''': rad/s^k; infinity: none
};

struct Solution {
  Eigen::MatrixXd control;  ///< joints x control points
  double objective = 0;     ///< integral over time
  double violation = 0;     ///< largest, m and rad, and shares of the rate limits
  int active_stations = 0;  ///< rows of not_positive at zero
  int active_rates = 0;     ///< control points of derivatives at their limit
};

class Solver {
 public:
  explicit Solver(Formulation formulation)
      : f_(std::move(formulation)),
        joints_(static_cast<int>(f_.lower.size())),
        count_(f_.basis.count()),
        gram_(
            f_.basis.gram({0, 1, std::pow(f_.smoothing_time, 2), std::pow(f_.smoothing_time, 4)})) {
    // Variables y = R c, R^T R ~ gram: the objective is then a sphere but for what moves nothing.
    const double trace = 1e-3 * gram_.trace() / count_;
    const Eigen::MatrixXd factor =
        (gram_ + trace * Eigen::MatrixXd::Identity(count_, count_)).llt().matrixU();
    from_variables_ = factor.inverse();
    for (int j = 0; j < joints_; ++j) {
      add_rows(0, j, -f_.lower[j], f_.upper[j]);
      for (int k = 1; k <= 3; ++k) {
        const double limit = f_.rate_limits[static_cast<std::size_t>(k - 1)][j];
        add_rows(k, j, limit, limit);
      }
    }
  }

  /// Control points of the curve nearest to the postures at the given times; a trace of the
  /// objective settles what they leave open.
  Eigen::MatrixXd fit(const std::vector<double>& times, const Eigen::MatrixXd& postures) const {
    Eigen::MatrixXd matrix = 1e-6 * gram_, right = Eigen::MatrixXd::Zero(count_, joints_);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Eigen::VectorXd n = f_.basis.at(times[i], 0);
      matrix += n * n.transpose();
      right += n * postures.col(static_cast<Eigen::Index>(i)).transpose();
    }
    return matrix.ldlt().solve(right).transpose();
  }

  double objective(const Eigen::MatrixXd& control) const {
    return (control * gram_ * control.transpose()).trace();
  }

  Solution solve(const Eigen::MatrixXd& start) {
    const auto variables = static_cast<unsigned>(joints_ * count_);
    nlopt::opt slsqp(nlopt::LD_SLSQP, variables);
    slsqp.set_min_objective(objective_function, this);
    slsqp.add_equality_mconstraint(zero_function, this, tolerance(row_count(f_.zero)));
    slsqp.add_inequality_mconstraint(below_function, this, tolerance(row_count(f_.not_positive)));
    slsqp.add_inequality_mconstraint(linear_function, this, tolerance(linear_.size()));
    slsqp.set_xtol_rel(1e-8);
    slsqp.set_maxeval(1000);
    std::vector<double> x(variables);
    Eigen::Map<Eigen::MatrixXd>(x.data(), count_, joints_) =
        from_variables_.inverse() * start.transpose();
    double value = 0;
    try {
      slsqp.optimize(x, value);
    } catch (const nlopt::roundoff_limited&) {  // as near as doubles allow; x is the best point
    }
    return describe(control(x.data()));
  }

 private:
  /// weights . c_joint <= bound
  struct LinearRow {
    int derivative, joint;
    Eigen::RowVectorXd weights;
    double bound;
  };

  static std::vector<double> tolerance(std::size_t rows) { return std::vector<double>(rows, 1e-9); }

  void add_rows(int derivative, int joint, double below, double above) {
    const Eigen::MatrixXd rows = f_.basis.derivative_control(derivative);
    for (int i = 0; i < rows.rows(); ++i) {
      if (std::isfinite(above)) linear_.push_back({derivative, joint, rows.row(i), above});
      if (std::isfinite(below)) linear_.push_back({derivative, joint, -rows.row(i), below});
    }
  }

  Eigen::MatrixXd control(const double* x) const {
    return (from_variables_ * Eigen::Map<const Eigen::MatrixXd>(x, count_, joints_)).transpose();
  }

  std::size_t row_count(const std::vector<Station>& stations) const {
    Eigen::Index rows = 0;
    const Eigen::VectorXd q = 0.5 * (f_.lower + f_.upper);
    for (const Station& station : stations) rows += station.values(q).size();
    return static_cast<std::size_t>(rows);
  }

  Solution describe(const Eigen::MatrixXd& control) const {
    Solution solution;
    solution.control = control;
    solution.objective = objective(control);
    const auto raise = [&](double v) { solution.violation = std::max(solution.violation, v); };
    for (const Station& station : f_.zero) {
      raise(station.values(control * f_.basis.at(station.time, 0)).cwiseAbs().maxCoeff());
    }
    for (const Station& station : f_.not_positive) {
      const Eigen::VectorXd c = station.values(control * f_.basis.at(station.time, 0));
      raise(c.maxCoeff());
      solution.active_stations += static_cast<int>((c.array() > -1e-6).count());
    }
    for (const LinearRow& row : linear_) {
      const double excess = row.weights.dot(control.row(row.joint)) - row.bound;
      raise(excess);
      if (row.derivative > 0 && excess > -1e-6 * row.bound) ++solution.active_rates;
    }
    return solution;
  }

  static const Solver& self(void* data) { return *static_cast<const Solver*>(data); }

  static double objective_function(unsigned, const double* x, double* gradient, void* data) {
    const Solver& s = self(data);
    const Eigen::MatrixXd control = s.control(x);
    if (gradient != nullptr) {
      Eigen::Map<Eigen::MatrixXd>(gradient, s.count_, s.joints_) =
          s.from_variables_.transpose() * (2 * s.gram_ * control.transpose());
    }
    return s.objective(control);
  }

  static void zero_function(unsigned, double* result, unsigned, const double* x, double* gradient,
                            void* data) {
    self(data).evaluate(self(data).f_.zero, x, result, gradient);
  }

  static void below_function(unsigned, double* result, unsigned, const double* x, double* gradient,
                             void* data) {
    self(data).evaluate(self(data).f_.not_positive, x, result, gradient);
  }

  /// d c / d c_ij = (d c / d q_j) N_i(t), the first by central differences. NLopt's gradients: one
  /// row after the other.
  void evaluate(const std::vector<Station>& stations, const double* x, double* result,
                double* gradient) const {
    constexpr double kStep = 1e-5;
    const Eigen::MatrixXd at = control(x);
    for (const Station& station : stations) {
      const Eigen::VectorXd n = f_.basis.at(station.time, 0), q = at * n;
      const Eigen::VectorXd m = from_variables_.transpose() * n, c = station.values(q);
      result = std::copy(c.begin(), c.end(), result);
      if (gradient == nullptr) continue;
      const auto rows = c.size();
      for (int j = 0; j < joints_; ++j) {
        const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(joints_, j);
        const Eigen::VectorXd slope =
            (station.values(q + step) - station.values(q - step)) / (2 * kStep);
        for (Eigen::Index r = 0; r < rows; ++r) {
          Eigen::Map<Eigen::VectorXd>(gradient + (r * joints_ + j) * count_, count_) = slope[r] * m;
        }
      }
      gradient += rows * joints_ * count_;
    }
  }

  static void linear_function(unsigned, double* result, unsigned, const double* x, double* gradient,
                              void* data) {
    const Solver& s = self(data);
    const Eigen::MatrixXd control = s.control(x);
    for (const LinearRow& row : s.linear_) {
      *result++ = row.weights.dot(control.row(row.joint)) - row.bound;
      if (gradient == nullptr) continue;
      Eigen::Map<Eigen::MatrixXd> slope(gradient, s.count_, s.joints_);
      slope.setZero();
      slope.col(row.joint) = (row.weights * s.from_variables_).transpose();
      gradient += slope.size();
    }
  }

  Formulation f_;
  int joints_, count_;
  Eigen::MatrixXd gram_;
  Eigen::MatrixXd from_variables_;  ///< control points of one joint = this times its variables
  std::vector<LinearRow> linear_;
};

}  // namespace wristwise::test::oracle
