#pragma once

#include <vector>

#include "wristwise/seam.hpp"

namespace wristwise {

/// How the direction of travel turns along the waypoints of a seam.
class SeamTurning {
 public:
  /// @param step s; turns are seen in steps of at least this: the noise of a recorded path is none
  SeamTurning(const Task& task, double step);

  /// rad, from the start up to `t` (s). Never falls; a sharp corner is spread over the steps that
  /// it lies between.
  double until(double t) const;
  double total() const { return turned_.back(); }

 private:
  std::vector<double> times_;   ///< middles of the steps, s
  std::vector<double> turned_;  ///< up to there, rad
};

}  // namespace wristwise
