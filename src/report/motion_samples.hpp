#pragma once

#include <optional>
#include <vector>

#include "verify/checked_motion.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// A motion looked at over time.
struct MotionSamples {
  std::vector<double> times;          ///< s: those of the motion, and others between them
  std::vector<Eigen::Vector3d> seam;  ///< m, the nominal TCP; the real one where none is
                                      ///< prescribed
  /// m, rad from the path frame; nullopt where no path is prescribed.
  std::vector<std::optional<Vector6>> deviation;
  /// See tolerance_use; infinity for a free angle, as the deviation.
  std::vector<std::optional<Vector6>> use;
  std::vector<std::optional<ToleranceBox>> boxes;    ///< what it is measured by, not widened
  std::vector<std::optional<PairDistance>> nearest;  ///< nullopt where no pair counts
};

/// Times of a motion with about `aim` samples, evenly between those given; some of them only where
/// they are more than four times that.
std::vector<double> sample_times(const std::vector<double>& times, std::size_t aim);

/// The share of the tolerance that is used: 0 in the middle of the box, 1 at its edge and where
/// the box widened by what holds between waypoints ends, more outside of it. Of a coordinate
/// without a width the share of that widening. Infinity where it is free.
Vector6 tolerance_use(const ToleranceBox& box, const Vector6& deviation, const Vector6& widening);

/// m and rad beyond the box that pass between waypoints.
Vector6 widening_of(const Task& task);

/// The deviation and its share of the tolerance; `nearest` stays empty.
/// @param task the one that the motion runs, its seam retimed
MotionSamples sample_tolerance(const Task& task, const Robot& robot, const CheckedMotion& motion,
                               std::size_t aim);

/// Everything.
MotionSamples sample_motion(const Task& task,
                            const std::shared_ptr<const ClearanceModel>& clearance,
                            const CheckedMotion& motion, std::size_t aim);

}  // namespace wristwise
