#include "refine/spline.hpp"

#include <algorithm>
#include <cmath>

#include "refine/banded_qr.hpp"
#include "refine/gauss_quadrature.hpp"

namespace wristwise {

SplineBasis::SplineBasis(std::vector<double> breakpoints) : breakpoints_(std::move(breakpoints)) {
  knots_.assign(kDegree, breakpoints_.front());
  knots_.insert(knots_.end(), breakpoints_.begin(), breakpoints_.end());
  knots_.insert(knots_.end(), kDegree, breakpoints_.back());
}

// Piegl & Tiller, The NURBS Book, algorithm A2.3: ndu holds the basis functions of all degrees
// (upper triangle) and the knot differences (lower triangle); the derivatives follow from the
// differences of lower-degree functions (eq. 2.10).
SplineBasis::Values SplineBasis::at(double t) const {
  const auto after = std::upper_bound(breakpoints_.begin() + 1, breakpoints_.end() - 1, t);
  const int first = static_cast<int>(after - breakpoints_.begin()) - 1;
  const int span = first + kDegree;

  Eigen::Matrix<double, kLocal, kLocal> ndu;
  Eigen::Matrix<double, kLocal, 1> left, right;
  ndu(0, 0) = 1;
  for (int j = 1; j <= kDegree; ++j) {
    left[j] = t - knot(span + 1 - j);
    right[j] = knot(span + j) - t;
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      ndu(j, r) = right[r + 1] + left[j - r];
      const double term = ndu(r, j - 1) / ndu(j, r);
      ndu(r, j) = saved + right[r + 1] * term;
      saved = left[j - r] * term;
    }
    ndu(j, j) = saved;
  }

  Values values;
  values.first = first;
  values.derivatives.col(0) = ndu.col(kDegree);
  for (int r = 0; r < kLocal; ++r) {
    Eigen::Matrix<double, 2, kLocal> a = Eigen::Matrix<double, 2, kLocal>::Zero();
    int current = 0, next = 1;
    a(0, 0) = 1;
    double factor = 1;
    for (int k = 1; k <= 3; ++k) {
      double sum = 0;
      const int rk = r - k, pk = kDegree - k;
      if (r >= k) {
        a(next, 0) = a(current, 0) / ndu(pk + 1, rk);
        sum = a(next, 0) * ndu(rk, pk);
      }
      const int j1 = rk >= -1 ? 1 : -rk;
      const int j2 = r - 1 <= pk ? k - 1 : kDegree - r;
      for (int j = j1; j <= j2; ++j) {
        a(next, j) = (a(current, j) - a(current, j - 1)) / ndu(pk + 1, rk + j);
        sum += a(next, j) * ndu(rk + j, pk);
      }
      if (r <= pk) {
        a(next, k) = -a(current, k - 1) / ndu(pk + 1, r);
        sum += a(next, k) * ndu(r, pk);
      }
      factor *= kDegree - k + 1;
      values.derivatives(r, k) = factor * sum;
      std::swap(current, next);
    }
  }
  return values;
}

// (F15) c^(k)_i = (p - k + 1) (c^(k-1)_{i+1} - c^(k-1)_i) / (u_{i+p+1} - u_{i+k}).
std::vector<double> SplineBasis::derivative_weights(int derivative, int i) const {
  std::vector<std::vector<double>> weights(static_cast<std::size_t>(derivative) + 1);
  for (int m = 0; m <= derivative; ++m) {
    weights[static_cast<std::size_t>(m)].assign(static_cast<std::size_t>(derivative) + 1, 0.0);
    weights[static_cast<std::size_t>(m)][static_cast<std::size_t>(m)] = 1;
  }
  for (int k = 1; k <= derivative; ++k) {
    for (int m = 0; m + k <= derivative; ++m) {
      const double width = knot(i + m + kDegree + 1) - knot(i + m + k);
      const auto at = static_cast<std::size_t>(m);
      auto& here = weights[at];
      const auto& next = weights[at + 1];
      for (std::size_t w = 0; w < here.size(); ++w) {
        here[w] = (kDegree - k + 1) * (next[w] - here[w]) / width;
      }
    }
  }
  return weights.front();
}

JointVector Spline::evaluate(double t, int derivative) const {
  const SplineBasis::Values values = basis.at(t);
  return control.middleCols<SplineBasis::kLocal>(values.first) * values.derivatives.col(derivative);
}

JointVector Spline::value(const SplineBasis::Values& at) const {
  return control.middleCols<SplineBasis::kLocal>(at.first) * at.derivatives.col(0);
}

Trajectory Spline::sampled_at(const std::vector<double>& times) const {
  std::vector<JointVector> position, velocity, acceleration;
  for (const double t : times) {
    position.push_back(evaluate(t, 0));
    velocity.push_back(evaluate(t, 1));
    acceleration.push_back(evaluate(t, 2));
  }
  return {times, position, velocity, acceleration};
}

namespace {

/// The polar form of the curve's piece on span [knot(k), knot(k + 1)] at five arguments (Ramshaw
/// 1989; de Boor's recursion with another argument in each step).
JointVector polar_form(const Spline& spline, int k, const SplineBasis& arguments, int first) {
  constexpr int p = SplineBasis::kDegree;
  Eigen::Matrix<double, Eigen::Dynamic, SplineBasis::kLocal, 0, kMaxJoints, SplineBasis::kLocal>
      points = spline.control.middleCols<SplineBasis::kLocal>(k - p);
  for (int r = 1; r <= p; ++r) {
    for (int j = p; j >= r; --j) {
      const double from = spline.basis.knot(k - p + j), to = spline.basis.knot(k + 1 + j - r);
      const double share = (arguments.knot(first + r - 1) - from) / (to - from);
      points.col(j) = (1 - share) * points.col(j - 1) + share * points.col(j);
    }
  }
  return points.col(p);
}

}  // namespace

// Control point i of the finer curve is the polar form of any of its pieces in the support of basis
// function i, at the knots i+1 .. i+5.
Spline with_breakpoints(const Spline& spline, std::vector<double> breakpoints) {
  Spline finer{SplineBasis(std::move(breakpoints)), {}};
  finer.control.resize(spline.control.rows(), finer.basis.control_count());
  for (int i = 0; i < finer.basis.control_count(); ++i) {
    int piece = i;
    while (finer.basis.knot(piece) >= finer.basis.knot(piece + 1)) ++piece;
    const int k = spline.basis.at(finer.basis.knot(piece)).first + SplineBasis::kDegree;
    finer.control.col(i) = polar_form(spline, k, finer.basis, i + 1);
  }
  return finer;
}

Spline fit_spline(const JointPath& path, std::vector<double> breakpoints, double smoothing) {
  Spline spline{SplineBasis(std::move(breakpoints)), {}};
  const SplineBasis& basis = spline.basis;
  const Eigen::Index joints = path.positions.front().size();
  // Derivatives are made comparable with positions by powers of the mean span.
  const double duration = path.times.back() - path.times.front();
  const double span_width = duration / basis.span_count();
  const double trace = 1e-9 * static_cast<double>(path.size()) / duration;
  // sum_i |q(t_i) - q_i|^2 ~ N/T integral |q - q_i|^2: the jerk of waves of period 2 pi smoothing
  // then counts as much as leaving them out.
  const double jerk_weight = std::pow(smoothing, 6) * static_cast<double>(path.size()) / duration;
  const double acceleration_factor = std::sqrt(trace * std::pow(span_width, 4));
  const double jerk_factor = std::sqrt(trace * std::pow(span_width, 6) + jerk_weight);

  const auto points = gauss_points(basis.breakpoints());
  auto next = points.begin();
  BandedQr qr(joints);
  std::size_t i = 0;
  for (int span = 0; span < basis.span_count(); ++span) {
    const std::size_t first = i;
    while (i < path.size() && basis.at(path.times[i]).first == span) ++i;
    const auto count = static_cast<Eigen::Index>(i - first);
    BandedQr::Rows rows(count + 2 * kGaussPoints, BandedQr::kLocal);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(rows.rows(), joints);
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t at = first + static_cast<std::size_t>(k);
      rows.row(k) = basis.at(path.times[at]).derivatives.col(0).transpose();
      right.row(k) = path.positions[at].transpose();
    }
    for (Eigen::Index k = 0; k < kGaussPoints; ++k) {
      const QuadraturePoint& point = *next++;
      const SplineBasis::Values values = basis.at(point.time);
      const double root = std::sqrt(point.weight);
      rows.row(count + 2 * k) = root * acceleration_factor * values.derivatives.col(2).transpose();
      rows.row(count + 2 * k + 1) = root * jerk_factor * values.derivatives.col(3).transpose();
    }
    qr.add_span(rows, right);
  }
  spline.control = back_substituted(qr.finish()).transpose();
  return spline;
}

}  // namespace wristwise
