#pragma once

#include <array>
#include <vector>

#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {

/// Cuts a tolerance box into parts, one about each sample of a grid: half-way to its neighbours, or
/// to the side of the box.
class SampleCells {
 public:
  SampleCells(const ToleranceBox& box, const std::vector<Vector6>& grid);

  ToleranceSample sample(const Pose& path_frame, const Vector6& deviation) const;

 private:
  ToleranceBox box_;
  std::array<std::vector<double>, 6> values_;  // of the samples, in order
};

}  // namespace wristwise
