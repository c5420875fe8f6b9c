#pragma once

#include <Eigen/Core>
#include <array>

namespace wristwise {

/// The angle about the unit axis h that turns the direction `from` onto that of `to`, as far as a
/// turn about h can; in [-pi, pi], zero where one of them is along h.
double turn_onto(const Eigen::Vector3d& h, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// At most two values.
template <class Value>
struct UpToTwo {
  int count = 0;
  std::array<Value, 2> values{};
  void add(const Value& value) { values[static_cast<std::size_t>(count++)] = value; }
  const Value* begin() const { return values.data(); }
  const Value* end() const { return values.data() + count; }
};

/// The component of a vector along a unit axis, m or 1.
struct Component {
  const Eigen::Vector3d& axis;
  double value = 0;
};

/// The vectors of a length with two given components: two, or one where they coincide, or none
/// (F78). Out of reach by no more than `slack`, a share of the squared length, is touching.
/// @pre the axes are not parallel
UpToTwo<Eigen::Vector3d> vectors_with(const Component& first, const Component& second,
                                      double squared_length, double slack);

struct TwoTurns {
  double first = 0, second = 0;  ///< rad
};

/// Turns with Rot(h1, first) Rot(h2, second) from = to; slack as above.
/// @pre h1 and h2 are unit vectors and not parallel, |from| = |to|
UpToTwo<TwoTurns> two_turns_onto(const Eigen::Vector3d& h1, const Eigen::Vector3d& h2,
                                 const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double slack);

}  // namespace wristwise
