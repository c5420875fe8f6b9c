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

enum class Mode { two_stage, graph_only, smooth };
enum class Status {
  solved,       ///< and the independent check passed
  infeasible,   ///< no trajectory meets the problem; see the diagnosis
  failed,       ///< something was found, but it does not pass the check
  interrupted,  ///< cancelled by the caller
};

struct PlanOptions {
  int threads = 0;  ///< 0: one per core. The result does not depend on it.
  Monitor monitor;
  VerificationOptions verification;
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
  std::string reason;      ///< out_of_reach, joint_limit, collision, no_edge, tolerance, ...
  std::string detail;      ///< one sentence
  std::string suggestion;  ///< what would help; of stage 1, found by trying where that succeeded
  std::optional<FailureCounts> counts = std::nullopt;
};

/// A path of stage 1, to start stage 2 from.
struct Seed {
  JointPath path;
  double cost = 0;
  std::size_t differs_at = 0;  ///< waypoint at which it differs from those before
  /// What stage 2 made of it: how it ended, and the objective (F14) where all constraints hold.
  std::string refinement = "not run";
  std::optional<double> objective = std::nullopt;
};

struct GraphStatistics {
  std::size_t vertices = 0;          ///< copies by whole turns included
  std::size_t postures = 0;          ///< copies by whole turns not included
  std::size_t postures_checked = 0;  ///< for clearance, before any move
  double edges = 0;                  ///< of the whole graph
  double edges_evaluated = 0;        ///< looked at
  std::size_t collision_checks = 0;  ///< exact distance queries; varies with the threads
  std::size_t edges_checked = 0;     ///< swept
  double edges_if_eager = 0;  ///< moves that an eager check would sweep: one per pair of postures
  double cost = 0;
  double joint_motion_l1 = 0;  ///< rad and m
  /// Whole turns of each joint between its value and (-pi, pi], at the first and the last waypoint.
  std::vector<int> first_turns, last_turns;
  int grid_rounds = 0;            ///< coarse to fine: searches after the first
  double first_cost = 0;          ///< coarse to fine: on the grid of the options
  std::size_t sparse_points = 0;  ///< sparse: waypoints planned
  int replans = 0;                ///< sparse: searches after the first
  /// Where there is no path: the first and last waypoints of the pieces that have one.
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
};

struct CostTerm {
  std::string name;
  double initial = 0, final = 0;  ///< integral over time, weighted
};

/// A constraint that the refined motion presses against, over a stretch of time.
struct ActiveConstraint {
  enum class Unit { metre, radian, share };  ///< share: of a velocity, acceleration or jerk limit
  std::string name;                          ///< coordinate, joint, or pair of bodies
  Unit unit = Unit::metre;
  double from = 0, to = 0;   ///< s
  double relative_gain = 0;  ///< share of the objective that widening saves, per unit (F33)
  std::string sentence;
};

struct RefineStatistics {
  bool run = false;
  int rounds = 0;
  int iterations = 0;
  int evaluations = 0;
  int control_points = 0;
  int constraint_points = 0;
  std::string termination;
  double objective = 0;              ///< integral over time (F14)
  double max_violation = 0;          ///< m or rad, of the constraints at their points
  std::size_t distance_queries = 0;  ///< exact ones
  std::vector<CostTerm> terms;
  std::vector<ActiveConstraint> active;  ///< the most costly first
};

/// A stretch of the weld that is run slower than the problem's times, because the joints can't keep
/// up.
struct SlowedStretch {
  double from = 0, to = 0;  ///< s
  double least_ratio = 1;   ///< of the problem's speed
  int joint = -1;           ///< the one that is nearest to its limits there
};

struct Timing {  ///< s
  double load = 0, sampling = 0, search = 0, refine = 0, verify = 0, total = 0;
};

/// A joint path as it was given, its jumps by whole turns undone, and what the check says of it.
struct GivenPath {
  JointPath path;
  Verification verification;
};

struct PlanResult {
  Status status = Status::failed;
  Mode mode = Mode::two_stage;
  std::vector<Seed> seeds;  ///< of stage 1, distinct, the best first
  JointPath path;           ///< at the waypoints; may be partial where there is no solution
  Trajectory trajectory;    ///< the curve; empty in graph-only mode
  Trajectory seam_time;     ///< the time law it runs the seam by; empty: that of the problem
  std::vector<SlowedStretch> slowed;  ///< by SpeedPolicy::slow, in order
  GraphStatistics graph;
  RefineStatistics refine;
  Verification verification;
  std::optional<GivenPath> before;  ///< what smooth() started from
  std::vector<Diagnosis> diagnosis;
  std::vector<std::string> warnings;
  std::vector<ClearanceModel::Names> permanent_contacts;  ///< pairs left out of the check
  std::string inverse_kinematics;                         ///< what was recognised
  Timing timing;
};

/// Both stages: ladder graph, refinement, verification.
PlanResult plan(const Problem& problem, const PlanOptions& options = {});

/// Stage 1 alone, verified: what a Descartes-style planner gives.
PlanResult plan_graph_only(const Problem& problem, const PlanOptions& options = {});

/// Stage 2 alone on an existing joint path, whose times become the waypoints. Without a problem:
/// smoothing.hpp.
/// @throws InvalidInput where the path does not fit the robot or the seam.
PlanResult smooth(const Problem& problem, const JointPath& path, const PlanOptions& options = {});

/// The independent check of any trajectory; no planning.
Verification check(const Problem& problem, const JointPath& path, const PlanOptions& options = {});
Verification check(const Problem& problem, const Trajectory& trajectory,
                   const PlanOptions& options = {});

/// Of what a file holds. Where it has a time law of the seam that law counts, in place of the
/// problem's: it may not run back, faster than the weld speed or, unless the problem says so
/// there, slower.
Verification check(const Problem& problem, const TrajectoryFile& file,
                   const PlanOptions& options = {});

}  // namespace wristwise
