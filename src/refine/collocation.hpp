#pragma once

#include <cstddef>
#include <vector>

#include "refine/point_constraint.hpp"

namespace wristwise {

/// Which of the task's waypoints are constraint points. A seam cut finely has more waypoints than
/// its curve has freedom; a few for each span hold the rest, and those that they do not hold join.
class Collocation {
 public:
  explicit Collocation(const Task& task) : task_(task), included_(task.waypoints.size(), false) {}

  /// Constraints at up to `per_span` waypoints of each span (chosen evenly; the first, the last and
  /// all joint waypoints always), weighted by the time they stand for in units of `unit` (s).
  /// Multipliers are taken over from `before`, as densities over time.
  std::vector<PointConstraint> choose(const SplineBasis& basis, int per_span, double unit,
                                      const std::vector<PointConstraint>& before);

  /// Whether every waypoint was chosen.
  bool is_complete() const;

  /// Constraints at the waypoints, one for each span and coordinate at most, that are farther
  /// outside what they ask than `tolerance` (m, rad) and all others of the span, the chosen ones
  /// among them.
  std::vector<PointConstraint> violated(const Robot& robot, const Spline& spline, double tolerance,
                                        double unit) const;

 private:
  std::vector<std::size_t> spread(const SplineBasis& basis, int per_span) const;

  const Task& task_;
  std::vector<bool> included_;  ///< waypoints that are constraint points already
};

}  // namespace wristwise
