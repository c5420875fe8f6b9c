#pragma once

#include <vector>

#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/pose.hpp"

namespace wristwise {

/// What is minimised, in both stages.
struct CostOptions {
  double joint_motion = 1;  ///< weight of |q'|^2 (stage 2) and of the L1 step (stage 1)
  double acceleration = 1;  ///< weight of tau^2 |q''|^2
  double jerk = 1;          ///< weight of tau^4 |q'''|^2
  double euler_graph = 0;   ///< rad of joint motion per rad of deviation at each vertex
  double euler_refine = 0;  ///< weight of (eta^2 alpha^2 + beta^2) / tau^2
  double euler_eta = 1;     ///< alpha's share against beta's (eq. 9)
  std::vector<double>
      joint_weights;  ///< one per joint, of its step or its derivatives; empty: ones
};

/// Stage 1.
struct GraphOptions {
  /// Sampling step of x, y, z (m), rx, ry, rz (rad); used where the tolerance has a width.
  /// 0: the ends and the nominal for a bounded coordinate, 10 deg for a free one.
  Vector6 step = Vector6::Zero();
  /// Sampling step of the ranges of joint waypoints, rad or m, one per joint; 0: the ends and the
  /// middle. Empty: all 0.
  std::vector<double> joint_step;
  Turns turns = Turns::all;
  /// m; no edge on which the TCP strays farther than this from the seam half-way between two
  /// waypoints: a joint-space move that swings the torch away from the weld is no way past an
  /// obstacle. Infinity: any.
  double max_stray = 0.02;
};

/// Stage 2.
struct RefineOptions {
  double smoothing_time = 2.5;  ///< tau, s: motion is ironed over about this long
  double knot_spacing = 0;      ///< s between knots; 0: 0.4 tau, but at least 100 spans where
                                ///< there are waypoints to put them on
  int max_rounds = 30;          ///< of the augmented Lagrangian
  int max_iterations = 40;      ///< of the inner solver in a round
  double constraint_tolerance = 5e-7;  ///< m and rad, of the constraints at the points they hold at
  double clearance_epsilon = 5e-5;     ///< m kept in hand, so that the clearance holds for all t
};

}  // namespace wristwise
