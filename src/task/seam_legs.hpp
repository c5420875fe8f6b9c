#pragma once

#include "task/stretches.hpp"

namespace wristwise {

/// A part of a piece on which the speed is even, or goes over from one to another. Its ends are
/// waypoints.
struct Leg {
  std::size_t stretch = 0;
  double from = 0, to = 0;            ///< s, nominal
  double real_from = 0, real_to = 0;  ///< s
  bool is_even = true;                ///< run at one speed
  bool ends_stretch = false;
  int intervals = 1;  ///< equal in real time
};

/// The legs of a seam that is timed, cut into intervals as the description asks.
/// @param first the piece of the seam that is the first stretch
std::vector<Leg> cut_into_legs(const SeamDescription& description,
                               const std::vector<Stretch>& stretches, const Seam& seam,
                               std::size_t first);

/// Intervals of a length no longer than `spacing`, both in m; at least one.
int intervals_by_spacing(double length, double spacing);

}  // namespace wristwise
