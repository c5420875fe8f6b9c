#pragma once

#include <string>
#include <vector>

#include "wristwise/joints.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Joint positions at given times: taken as joined by straight joint-space moves.
struct JointPath {
  std::vector<double> times;           ///< s, strictly increasing
  std::vector<JointVector> positions;  ///< rad or m

  std::size_t size() const { return times.size(); }  ///< points
};

/// @throws InvalidInput where the path has fewer than two points, times that do not increase, or
/// positions that are not finite or not of `joints` values. `where` names the input.
void validate(const JointPath& path, int joints, const std::string& where);

/// A piecewise quintic through positions, velocities and accelerations at given times.
/// Twice continuously differentiable; the jerk may jump at the times.
class Trajectory {
 public:
  Trajectory() = default;  ///< empty
  /// @throws InvalidInput for fewer than two times, times that do not increase, sizes that differ
  /// or values that are not finite.
  Trajectory(std::vector<double> times, std::vector<JointVector> positions,
             std::vector<JointVector> velocities, std::vector<JointVector> accelerations);

  /// Whether there are no times: nothing below may then be asked for.
  bool empty() const { return times_.empty(); }
  /// s, strictly increasing; two or more.
  const std::vector<double>& times() const { return times_; }
  /// rad or m, at the times.
  const std::vector<JointVector>& positions() const { return positions_; }
  /// rad/s or m/s, at the times.
  const std::vector<JointVector>& velocities() const { return velocities_; }
  /// rad/s^2 or m/s^2, at the times.
  const std::vector<JointVector>& accelerations() const { return accelerations_; }
  /// The times and positions alone.
  JointPath waypoints() const { return {times_, positions_}; }

  /// The derivative of the given order (0 to 5) at time t (s), in rad or m per s to that power;
  /// held at the ends outside. At a time between two pieces that of the later one.
  JointVector evaluate(double t, int derivative = 0) const;

  /// For each joint, the least and the largest value of q^(k), k = 0 to 3, over the piece
  /// [times[i], times[i+1]]: exact, from the roots of the next derivative (F11).
  void extremes(std::size_t piece, int derivative, JointVector& least, JointVector& largest) const;

  /// One row per joint, column k: the coefficient of the k-th power, k = 0 to 5.
  using Polynomials = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, kMaxJoints, 6>;

  /// The piece [times[i], times[i+1]] in powers of s, which runs from -1 to 1 over it; rad or m.
  Polynomials polynomials(std::size_t piece) const;

 private:
  std::size_t piece_at(double t) const;
  /// In powers of u = (t - times[i]) / (times[i+1] - times[i]).
  using Coefficients = Polynomials;
  std::vector<double> times_;
  std::vector<JointVector> positions_, velocities_, accelerations_;
  std::vector<Coefficients> pieces_;
};

/// Divided differences of order k (1, 2, 3) over uneven times: k! [q_i, ..., q_{i+k}], size - k of
/// them: an estimate of the k-th derivative (F12).
std::vector<JointVector> divided_differences(const JointPath& path, int order);

}  // namespace wristwise
