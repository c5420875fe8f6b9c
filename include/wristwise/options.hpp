#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// How far a posture is from a singular one, from 0 (singular) to 1 (F20).
enum class SingularityMeasure {
  wrist,           ///< sine of the angle between the last joint's axis and the last but two's
  manipulability,  ///< Yoshikawa's measure, relative to the largest found in the robot's workspace
};

/// A cost of the caller's own in stage 2: a function r(t, q) of the time (s) and the posture,
/// rad/s, whose square is integrated over time beside |q'|^2. Differentiable by q; it may be
/// negative, and should pass zero rather than touch it, so that it is smooth where it vanishes.
/// Where `gradient` is not null it is to be set to d r / d q, one value per joint. Called from
/// several threads.
using PostureResidual =
    std::function<double(double time, const JointVector& q, JointVector* gradient)>;

/// What is minimised, in both stages.
struct CostOptions {
  double joint_motion = 1;       ///< weight of |q'|^2 (stage 2) and of the L1 step (stage 1)
  double acceleration = 1;       ///< weight of tau^2 |q''|^2
  double jerk = 1;               ///< weight of tau^4 |q'''|^2
  double euler_graph = 0;        ///< rad of joint motion per rad of deviation at each vertex
  double euler_refine = 0;       ///< weight of (eta^2 alpha^2 + beta^2) / tau^2
  double euler_eta = 1;          ///< alpha's share against beta's (eq. 9)
  double position_graph = 0;     ///< rad of joint motion per m of |x| + |y| + |z| at each vertex
  double position_refine = 0;    ///< weight of (x^2 + y^2 + z^2) / tau^2, rad^2 / m^2
  bool squared_steps = false;    ///< stage 1: the sum of squared joint steps instead of eq. 4
  double singularity_graph = 0;  ///< rad of joint motion at each vertex that is singular; less
                                 ///< where it is farther from that: w (1 - measure)
  SingularityMeasure singularity_measure =
      SingularityMeasure::wrist;  ///< of singularity_graph and of place()
  double singularity_refine = 0;  ///< stage 2: weight of cos^8(wrist) / tau^2 (F32)
  /// Stage 2: weight of |q - preferred|^2 / tau^2; unused where preferred_posture is empty.
  double posture = 1;
  std::vector<double> preferred_posture;  ///< rad or m, one per joint; empty: none
  /// The caller's own cost of a posture (at a waypoint) and of a move (in the interval after a
  /// waypoint) in stage 1, rad of joint motion, >= 0, added to the rest. Infinity: not allowed.
  /// Called from several threads.
  std::function<double(std::size_t waypoint, const JointVector& q)> vertex_cost;
  /// See vertex_cost.
  std::function<double(std::size_t interval, const JointVector& from, const JointVector& to)>
      edge_cost;
  std::vector<PostureResidual> posture_residuals;  ///< stage 2: each adds the integral of r^2 (F14)
  std::vector<double>
      joint_weights;  ///< one per joint, of its step or its derivatives; empty: ones
};

/// When stage 1 measures whether a posture has the clearance.
enum class CollisionChecks {
  lazy,   ///< only where a best path needs it: the same path and cost with fewer checks
  eager,  ///< for every sample
};

/// Which waypoints stage 1 plans.
enum class Planner {
  dense,   ///< all of them
  sparse,  ///< a few, with joint interpolation between them; more where that goes astray
};

/// Stage 1.
struct GraphOptions {
  /// Sampling step of x, y, z (m), rx, ry, rz (rad); used where the tolerance has a width.
  /// 0: the ends and the nominal for a bounded coordinate, 10 deg for a free one.
  Vector6 step = Vector6::Zero();
  /// Sampling step of the ranges of joint waypoints, rad or m, one per joint; 0: the ends and the
  /// middle. Empty: all 0.
  std::vector<double> joint_step;
  /// Of joints to spare, which are sampled like a tolerance (find_redundant_inverse_kinematics).
  JointSteps redundancy;
  /// > 0: steps are chosen so that a waypoint has about so many samples, `step` unused.
  int automatic_samples = 0;
  /// Samples again, ever finer, around the best path until the cost settles.
  bool coarse_to_fine = false;
  /// False: moves between waypoints are taken as they are, whatever they hit and wherever the TCP
  /// strays, as the Descartes algorithm does; `max_stray` is unused. To compare with; the
  /// verification does check them.
  bool check_moves = true;
  Planner planner = Planner::dense;  ///< which waypoints are planned
  /// rad or m; sparse: how far an interpolated posture may be from the nearest one in tolerance.
  double sparse_deviation = 0.05;
  bool try_relaxations = true;  ///< where there is no path, look for the smallest that would help
  int seeds = 1;                ///< distinct paths to look for, the best first; each is refined
  int spare_seeds = 3;          ///< so many more are tried where none of those can be refined
  /// rad or m; usable postures of a waypoint that differ by less in every joint are neighbours.
  /// Paths are distinct where at some waypoint no chain of neighbours joins them: other branches of
  /// the robot, other sides of an obstacle. Whole turns are not counted.
  double seed_separation = 0.5;
  Turns turns = Turns::all;  ///< whole turns of joints that are taken
  /// m; no edge on which the TCP strays farther than this from the seam half-way between two
  /// waypoints: a joint-space move that swings the torch away from the weld is no way past an
  /// obstacle. Infinity: any.
  double max_stray = 0.02;
  double max_tcp_step = std::numeric_limits<double>::infinity();  ///< m, from waypoint to waypoint
  double max_tcp_turn = std::numeric_limits<double>::infinity();  ///< rad, likewise
  CollisionChecks collision_checks = CollisionChecks::lazy;       ///< when clearance is measured
};

/// Stage 2.
struct RefineOptions {
  double smoothing_time = 2.5;  ///< tau, s: motion is ironed over about this long
  double knot_spacing = 0;      ///< s between knots; 0: 0.4 tau, but at least 100 spans where
                                ///< there are waypoints to put them on
  int max_rounds = 60;          ///< of the augmented Lagrangian
  int max_iterations = 40;      ///< of the inner solver in a round
  double constraint_tolerance = 5e-7;  ///< m and rad, of the constraints at the points they hold at
  double clearance_epsilon = 5e-5;     ///< m kept in hand, so that the clearance holds for all t
  /// Where the weld speed can't be held, find by trying the highest uniform speed that works.
  bool try_speeds = true;
  /// s; after it the best motion so far that holds everything is taken. Infinity: none. With a
  /// limit the result depends on the machine.
  double time_limit = std::numeric_limits<double>::infinity();
};

}  // namespace wristwise
