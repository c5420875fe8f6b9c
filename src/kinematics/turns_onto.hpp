#pragma once

#include <Eigen/Core>
#include <array>

namespace wristwise {

/// The angle about the unit axis h that turns the direction `from` onto that of `to`, as far as a
/// turn about h can; in [-pi, pi], zero where one of them is along h.
double turn_onto(const Eigen::Vector3d& h, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

struct TwoTurns {
  double first = 0, second = 0;  ///< rad
};

struct TwoTurnsSolutions {
  int count = 0;
  std::array<TwoTurns, 2> turns;
  const TwoTurns* begin() const { return turns.data(); }
  const TwoTurns* end() const { return turns.data() + count; }
};

/// Turns with Rot(h1, first) Rot(h2, second) from = to (F78): two, or one where they coincide, or
/// none. Out of reach by no more than `slack`, a share of the vectors' squared length, is touching.
/// @pre h1 and h2 are unit vectors and not parallel, |from| = |to|
TwoTurnsSolutions two_turns_onto(const Eigen::Vector3d& h1, const Eigen::Vector3d& h2,
                                 const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double slack);

}  // namespace wristwise
