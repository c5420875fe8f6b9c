#pragma once

#include <vector>

#include "wristwise/joint_box.hpp"
#include "wristwise/options.hpp"
#include "wristwise/tolerance.hpp"

namespace wristwise {

/// The samples of one coordinate (design: sampling grid). Bounded [lower, upper] with step s:
/// ceil((upper - lower) / s) equal intervals, both ends included, and 0 where it lies inside and is
/// not on the grid. Free (infinite bounds): n = ceil(2 pi / s) samples -pi + k 2 pi / n.
/// @param step > 0, or 0 for the default of GraphOptions::step
std::vector<double> coordinate_samples(double lower, double upper, double step);

/// Steps with which a waypoint has about `samples` samples: one step for all rotations, and for
/// positions what turns the joints by about as much at a distance of 1 m.
Vector6 automatic_step(const ToleranceBox& box, int samples);

/// The grid that the options ask for.
std::vector<Vector6> waypoint_grid(const ToleranceBox& box, const GraphOptions& options);

/// The product of the samples of all coordinates, the last coordinate running fastest.
std::vector<Vector6> sampling_grid(const ToleranceBox& box, const Vector6& step);

/// The postures of a joint waypoint: the product of the samples of all joints, the last joint
/// running fastest. Each range is sampled like a bounded coordinate, with its middle for 0.
/// @param step rad or m, one per joint, 0 for the default; empty: all 0
/// @throws InvalidInput for another number of steps than of joints, a step that is no number or
/// negative, or more than a million samples
std::vector<JointVector> joint_grid(const JointBox& box, const std::vector<double>& step);

}  // namespace wristwise
