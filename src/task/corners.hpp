#pragma once

#include "task/stretches.hpp"

namespace wristwise {

/// A place where the tangent or the frame of the seam jumps (by more than 1e-3 rad).
struct Corner {
  std::size_t before = 0;      ///< the stretch that ends there
  std::optional<double> bend;  ///< rad, between the tangents; nullopt beside a turn on the spot
  double turn = 0;             ///< rad, of the frame
};

std::vector<Corner> find_corners(const std::vector<Stretch>& stretches);

/// Does with the corners what the description says: rounds them off, sets the speed at them, adds
/// stretches on which the torch stands and turns.
/// @throws InvalidInput naming the corner where it can't be done.
void treat_corners(const SeamDescription& description, std::vector<Stretch>& stretches);

}  // namespace wristwise
