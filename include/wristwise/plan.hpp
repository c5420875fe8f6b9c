#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wristwise/monitor.hpp"
#include "wristwise/problem.hpp"
#include "wristwise/trajectory.hpp"
#include "wristwise/trajectory_file.hpp"
#include "wristwise/verification.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Which stages are run.
enum class Mode {
  two_stage,   ///< ladder graph, then refinement
  graph_only,  ///< ladder graph
  smooth,      ///< refinement of a joint path that is given
};

/// How a run ended.
enum class Status {
  solved,       ///< and the independent check passed
  infeasible,   ///< no trajectory meets the problem; see the diagnosis
  failed,       ///< something was found, but it does not pass the check
  interrupted,  ///< cancelled by the caller
};

/// How to run, whatever the problem.
struct PlanOptions {
  int threads = 0;                   ///< 0: one per core. The result does not depend on it.
  Monitor monitor;                   ///< to watch the run and to stop it
  VerificationOptions verification;  ///< clearance_epsilon is that of the problem's RefineOptions
};

/// What became of the samples of a waypoint that cannot be passed.
struct FailureCounts {
  std::size_t samples = 0;                                 ///< poses tried
  std::size_t out_of_reach = 0;                            ///< poses without a branch
  std::map<std::string, std::size_t> joint_limit;          ///< joint -> branches that it excludes
  std::map<ClearanceModel::Names, std::size_t> collision;  ///< pair -> postures it excludes
  std::size_t usable = 0;                                  ///< postures, whole turns included
  // Of those, moves to them from the best posture at the waypoint before:
  std::size_t too_fast = 0;  ///< for a joint
  std::size_t too_far = 0;   ///< for graph.max_tcp_step or max_tcp_turn
  std::size_t astray = 0;    ///< for graph.max_stray
  std::size_t blocked = 0;   ///< by a collision on the way
};

/// Why there is no trajectory, or what is wrong with the one there is.
struct Diagnosis {
  std::optional<std::size_t> waypoint;  ///< the first that fails
  /// Of stage 1: out_of_reach, joint_limit, collision or no_edge. Of stage 2: refinement, seed or
  /// infeasible_at_this_speed. Else verification or interrupted.
  std::string reason;
  std::string detail;      ///< one sentence
  std::string suggestion;  ///< what would help; of stage 1, found by trying where that succeeded
  std::optional<FailureCounts> counts = std::nullopt;  ///< of that waypoint, by stage 1
};

/// A path of stage 1, to start stage 2 from.
struct Seed {
  JointPath path;              ///< at the waypoints
  double cost = 0;             ///< of stage 1, rad of joint motion
  std::size_t differs_at = 0;  ///< waypoint at which it differs from those before
  /// What stage 2 made of it: how it ended, and the objective (F14) where all constraints hold.
  std::string refinement = "not run";
  std::optional<double> objective = std::nullopt;  ///< see refinement
};

/// What stage 1 looked at and found.
struct GraphStatistics {
  std::size_t vertices = 0;          ///< copies by whole turns included
  std::size_t postures = 0;          ///< copies by whole turns not included
  std::size_t postures_checked = 0;  ///< for clearance, before any move
  double edges = 0;                  ///< of the whole graph
  double edges_evaluated = 0;        ///< looked at
  std::size_t collision_checks = 0;  ///< exact distance queries; varies with the threads
  std::size_t edges_checked = 0;     ///< swept
  double edges_if_eager = 0;   ///< moves that an eager check would sweep: one per pair of postures
  double cost = 0;             ///< of the path found, rad of joint motion
  double joint_motion_l1 = 0;  ///< rad and m: the sum of its joint steps
  /// Whole turns of each joint between its value and (-pi, pi], at the first and the last waypoint.
  std::vector<int> first_turns;
  std::vector<int> last_turns;    ///< likewise
  int grid_rounds = 0;            ///< coarse to fine: searches after the first
  double first_cost = 0;          ///< coarse to fine: on the grid of the options
  std::size_t sparse_points = 0;  ///< sparse: waypoints planned
  int replans = 0;                ///< sparse: searches after the first
  /// Where there is no path: the first and last waypoints of the pieces that have one.
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
};

/// A term of the objective of stage 2 (F14).
struct CostTerm {
  std::string name;    ///< joint_motion, acceleration, jerk, ...
  double initial = 0;  ///< of the seed: integral over time, weighted
  double final = 0;    ///< of the refined trajectory, likewise
};

/// A constraint that the refined motion presses against, over a stretch of time.
struct ActiveConstraint {
  /// In what the constraint is measured.
  enum class Unit {
    metre,   ///< m, of a position or a clearance
    radian,  ///< rad, of an angle
    share,   ///< of a velocity, acceleration or jerk limit
  };
  std::string name;          ///< coordinate, joint, or pair of bodies
  Unit unit = Unit::metre;   ///< of relative_gain: per one of these
  double from = 0;           ///< s, where the stretch begins
  double to = 0;             ///< s, where it ends
  double relative_gain = 0;  ///< share of the objective that widening saves, per unit (F33)
  std::string sentence;      ///< the same for people
};

/// How stage 2 went, of the seed that was taken.
struct RefineStatistics {
  bool run = false;                      ///< whether it was run at all
  int rounds = 0;                        ///< of the augmented Lagrangian
  int iterations = 0;                    ///< of the inner solver, over all rounds
  int evaluations = 0;                   ///< of objective and constraints, over all rounds
  int control_points = 0;                ///< of the spline, each with a value for every joint
  int constraint_points = 0;             ///< times at which constraints are held
  std::string termination;               ///< how it ended, in words
  double objective = 0;                  ///< integral over time (F14)
  double max_violation = 0;              ///< m or rad, of the constraints at their points
  std::size_t distance_queries = 0;      ///< exact ones
  std::vector<CostTerm> terms;           ///< of the objective
  std::vector<ActiveConstraint> active;  ///< the most costly first
};

/// A stretch of the weld that is run slower than the problem's times, because the joints can't keep
/// up.
struct SlowedStretch {
  double from = 0;         ///< s, real time
  double to = 0;           ///< s, real time
  double least_ratio = 1;  ///< of the problem's speed
  int joint = -1;          ///< the one that is nearest to its limits there
};

/// Wall-clock time of each stage, s.
struct Timing {
  double load = 0;      ///< reading the problem; filled in by who reads it
  double sampling = 0;  ///< of stage 1: samples, inverse kinematics
  double search = 0;    ///< of stage 1
  double refine = 0;    ///< stage 2, other speeds included
  double verify = 0;    ///< the independent check
  double total = 0;     ///< of plan() or smooth()
};

/// A joint path as it was given, its jumps by whole turns undone, and what the check says of it.
struct GivenPath {
  JointPath path;             ///< at its own times
  Verification verification;  ///< of it, as points joined by straight moves
};

/// What plan(), plan_graph_only() and smooth() give back, solved or not.
struct PlanResult {
  Status status = Status::failed;  ///< `solved` only where the verification passed
  Mode mode = Mode::two_stage;     ///< the one asked for
  std::vector<Seed> seeds;         ///< of stage 1, distinct, the best first
  JointPath path;                  ///< at the waypoints; may be partial where there is no solution
  Trajectory trajectory;           ///< the curve; empty in graph-only mode
  Trajectory seam_time;            ///< the time law it runs the seam by; empty: that of the problem
  std::vector<SlowedStretch> slowed;  ///< by SpeedPolicy::slow, in order
  GraphStatistics graph;              ///< of stage 1
  RefineStatistics refine;            ///< of stage 2
  Verification verification;          ///< of the trajectory, or of the path where there is none
  std::optional<GivenPath> before;    ///< what smooth() started from
  std::vector<Diagnosis> diagnosis;   ///< empty where solved; the first matters most
  std::vector<std::string> warnings;  ///< one line each
  std::vector<ClearanceModel::Names> permanent_contacts;  ///< pairs left out of the check
  std::string inverse_kinematics;                         ///< what was recognised
  Timing timing;                                          ///< s, of each stage
};

/// Both stages: ladder graph, refinement, verification. No solution is a result with a diagnosis.
/// @throws InvalidInput, naming the member, for a problem that is not complete or whose parts do
/// not fit together: no robot, fewer than two waypoints, options out of range or not one per joint,
/// names of pairs that the scene does not have
PlanResult plan(const Problem& problem, const PlanOptions& options = {});

/// Stage 1 alone, verified: what a Descartes-style planner gives.
/// @throws InvalidInput as plan()
PlanResult plan_graph_only(const Problem& problem, const PlanOptions& options = {});

/// Stage 2 alone on an existing joint path, whose times become the waypoints. Without a problem:
/// smoothing.hpp.
/// @throws InvalidInput as plan(), and where the path does not fit the robot or the seam.
PlanResult smooth(const Problem& problem, const JointPath& path, const PlanOptions& options = {});

/// The independent check of any trajectory; no planning. Points are joined by straight joint-space
/// moves.
/// @throws InvalidInput where the motion does not fit the robot, or as plan()
Verification check(const Problem& problem, const JointPath& path, const PlanOptions& options = {});
/// Likewise of a curve.
Verification check(const Problem& problem, const Trajectory& trajectory,
                   const PlanOptions& options = {});

/// Of what a file holds. Where it has a time law of the seam that law counts, in place of the
/// problem's: it may not run back, faster than the weld speed or, unless the problem says so
/// there, slower.
Verification check(const Problem& problem, const TrajectoryFile& file,
                   const PlanOptions& options = {});

}  // namespace wristwise
