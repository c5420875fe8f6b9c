#include "wristwise/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "task/polynomial.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void validate_times(const std::vector<double>& times, const std::string& where) {
  if (times.size() < 2) {
    throw InvalidInput(where, std::to_string(times.size()) + " points", "at least two");
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1])) {
      throw InvalidInput(where, "time " + std::to_string(i) + " is " + std::to_string(times[i]),
                         "finite, strictly increasing times");
    }
  }
}

void validate_vectors(const std::vector<JointVector>& values, std::size_t count,
                      Eigen::Index joints, const std::string& where) {
  if (values.size() != count) {
    throw InvalidInput(where, std::to_string(values.size()) + " vectors",
                       "one for each of the " + std::to_string(count) + " times");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].size() != joints || joints == 0 || !values[i].allFinite()) {
      throw InvalidInput(where, "bad joint vector at index " + std::to_string(i),
                         std::to_string(joints) + " finite values");
    }
  }
}

}  // namespace

void validate(const JointPath& path, int joints, const std::string& where) {
  validate_times(path.times, where);
  validate_vectors(path.positions, path.times.size(), joints, where);
}

Trajectory::Trajectory(std::vector<double> times, std::vector<JointVector> positions,
                       std::vector<JointVector> velocities, std::vector<JointVector> accelerations)
    : times_(std::move(times)),
      positions_(std::move(positions)),
      velocities_(std::move(velocities)),
      accelerations_(std::move(accelerations)) {
  validate_times(times_, "trajectory.times");
  const Eigen::Index joints = positions_.empty() ? 0 : positions_.front().size();
  validate_vectors(positions_, times_.size(), joints, "trajectory.positions");
  validate_vectors(velocities_, times_.size(), joints, "trajectory.velocities");
  validate_vectors(accelerations_, times_.size(), joints, "trajectory.accelerations");
  pieces_.reserve(times_.size() - 1);
  for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
    const double h = times_[i + 1] - times_[i];
    const JointVector p0 = positions_[i];
    const JointVector v0 = velocities_[i] * h, v1 = velocities_[i + 1] * h;
    const JointVector a0 = accelerations_[i] * (h * h), a1 = accelerations_[i + 1] * (h * h);
    const JointVector step = positions_[i + 1] - p0;
    Coefficients c(p0.size(), 6);
    c.col(0) = p0;
    c.col(1) = v0;
    c.col(2) = 0.5 * a0;
    c.col(3) = 10 * step - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
    c.col(4) = -15 * step + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
    c.col(5) = 6 * step - 3 * (v0 + v1) - 0.5 * a0 + 0.5 * a1;
    pieces_.push_back(c);
  }
}

std::size_t Trajectory::piece_at(double t) const {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  return static_cast<std::size_t>(after - times_.begin()) - 1;
}

JointVector Trajectory::evaluate(double t, int derivative) const {
  const std::size_t i = piece_at(t);
  const Coefficients& c = pieces_[i];
  const double h = times_[i + 1] - times_[i];
  const double u = std::clamp((t - times_[i]) / h, 0.0, 1.0);
  JointVector value = JointVector::Zero(c.rows());
  for (int k = 5; k >= derivative; --k) {
    double factor = 1;
    for (int m = 0; m < derivative; ++m) factor *= k - m;
    value = value * u + factor * c.col(k);
  }
  return value / std::pow(h, derivative);
}

void Trajectory::extremes(std::size_t piece, int derivative, JointVector& least,
                          JointVector& largest) const {
  const Coefficients& c = pieces_[piece];
  const double scale = std::pow(times_[piece + 1] - times_[piece], -derivative);
  least.resize(c.rows());
  largest.resize(c.rows());
  for (Eigen::Index j = 0; j < c.rows(); ++j) {
    Polynomial p{};
    for (int k = 0; k < 6; ++k) p[static_cast<std::size_t>(k)] = c(j, k);
    for (int d = 0; d < derivative; ++d) p = wristwise::derivative(p);
    const auto [low, high] = extremes_on_unit_interval(p);
    least[j] = low * scale;
    largest[j] = high * scale;
  }
}

// u = (1 + s) / 2: synthetic division about 1/2.
Trajectory::Polynomials Trajectory::polynomials(std::size_t piece) const {
  Polynomials c = pieces_[piece];
  for (int from = 0; from < 5; ++from) {
    for (int k = 4; k >= from; --k) c.col(k) += 0.5 * c.col(k + 1);
  }
  double power = 1;
  for (int k = 1; k < 6; ++k) c.col(k) *= power *= 0.5;
  return c;
}

std::vector<JointVector> divided_differences(const JointPath& path, int order) {
  std::vector<JointVector> differences = path.positions;
  for (int k = 1; k <= order; ++k) {
    if (differences.size() < 2) return {};
    for (std::size_t i = 0; i + 1 < differences.size(); ++i) {
      differences[i] = k * (differences[i + 1] - differences[i]) /
                       (path.times[i + static_cast<std::size_t>(k)] - path.times[i]);
    }
    differences.pop_back();
  }
  return differences;
}

}  // namespace wristwise
