#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wristwise/plan.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// What stands elsewhere when a placement is tried.
enum class Placed {
  part,   ///< the part, with the objects of `with`; the rest of the scene stays
  robot,  ///< the robot's base, with the objects of `with`; part and scene stay
};

/// How far what is placed is moved from where the problem has it: x, y, z (m) along the axes of the
/// base frame as it is in the problem, and rx, ry, rz (rad) about these axes, fixed, in this order,
/// through the origin of the part's frame (of the base frame for Placed::robot).
using Offset = Vector6;

/// Where to look, and for what.
struct PlacementOptions {
  Placed placed = Placed::part;  ///< what stands elsewhere
  /// Names of the objects that move with what is placed.
  std::vector<std::string> with;
  /// The region. A coordinate whose bounds are equal has that one value.
  Offset lower = Offset::Zero();
  Offset upper = Offset::Zero();  ///< see lower

  // The measure (F81): what is weighed is at most 1 each, but for a speed that can't be held.
  double speed_weight = 1;        ///< of the peak of |joint speed| / limit
  double singularity_weight = 1;  ///< of what is missing of the margin, as a share of it
  double clearance_weight = 1;    ///< likewise
  /// Wished for distance from a singular posture, 0 to 1 (F20, by cost.singularity.measure).
  double singularity_margin = 0.5;
  /// m, wished for beyond scene.clearance; between all bodies whose distance depends on the
  /// placement (not of the tool from what moves with the seam). What scene.clearance asks for is a
  /// condition, here as in plan().
  double clearance_margin = 0.02;

  int evaluations = 0;     ///< placements that the search measures at most; 0: 100 and 100 for each
                           ///< coordinate that is not fixed
  std::uint32_t seed = 1;  ///< of the search
  int map_points = 15;     ///< along each side of the map; 0: no map
  /// s, of search and map; then the best placement so far is taken. With a limit the result depends
  /// on the machine. Infinity: none.
  double time_limit = std::numeric_limits<double>::infinity();
};

/// A problem whose part, or robot, may stand elsewhere.
struct PlacementRequest {
  Problem problem;                     ///< as it is given
  Pose part_frame = Pose::Identity();  ///< of the part, in base, as it is given
  /// The task when the part has been moved by a motion given in the base frame.
  std::function<Task(const Pose& motion)> task_after;
  PlacementOptions options;  ///< where to look, and for what
};

/// Reads a problem file with its `placement` section (docs/problem-file.md).
/// @throws InvalidInput with file, key and what was expected; where there is no such section.
PlacementRequest load_placement(const std::filesystem::path& file, const LoadOptions& options = {});

/// What a placement is worth.
struct PlacementMeasure {
  bool feasible = false;  ///< the seam can be welded there: planned, and verified
  /// What is minimised: (F81) where feasible; else more than any of those, by what is missing
  /// (F82).
  double value = std::numeric_limits<double>::infinity();
  std::string obstacle;        ///< where not feasible: the reason of the diagnosis
  double waypoints_share = 0;  ///< of the waypoints, in the longest piece that stage 1 can pass
  // Of the refined trajectory, where there is one:
  double speed_ratio = 0;           ///< peak of |joint speed| / limit, at the full weld speed
  double singularity_distance = 0;  ///< the least, 0 to 1
  std::optional<double> clearance;  ///< m, least, of the pairs that count; nullopt: no pair does
};

/// A place that was tried.
struct Placement {
  Offset offset = Offset::Zero();  ///< from where the problem has it
  PlacementMeasure measure;        ///< what it is worth
};

/// The problem as it is with part, or robot, elsewhere; in the frame of the base where it then is.
struct PlacedProblem {
  Problem problem;                     ///< to be planned as any other
  Pose part_frame = Pose::Identity();  ///< of the part, in that base
  Pose motion = Pose::Identity();      ///< of the part and of `moved`: new pose = motion * old pose
  std::vector<std::string> moved;      ///< objects
};

/// A placement, planned in both modes.
struct PlacementPlans {
  PlacedProblem placed;   ///< what was planned
  PlanResult graph_only;  ///< plan_graph_only() of it
  PlanResult two_stage;   ///< plan() of it
};

/// The measure on a grid over two coordinates, the others being those of the placement found.
struct PlacementMap {
  std::vector<int> axes;           ///< coordinates, 0 to 5; none, one or two
  std::vector<int> points;         ///< along each axis
  std::vector<Placement> samples;  ///< the first axis varies fastest
};

/// What place() gives back.
struct PlacementResult {
  /// solved: found, planned in full and verified. infeasible: there is none in the region, as far
  /// as was looked. failed: found, but the full plan does not pass its check.
  Status status = Status::failed;
  Placement given;                               ///< offset zero, inside the region or not
  Placement found;                               ///< where infeasible: the one with least missing
  PlacementPlans before;                         ///< of the placement given
  PlacementPlans after;                          ///< of the one found, only where there is one
  PlacementMap map;                              ///< round the placement found
  std::size_t evaluations = 0;                   ///< placements measured
  std::map<std::string, std::size_t> obstacles;  ///< reason -> placements; "" where feasible
  bool out_of_time = false;                      ///< PlacementOptions::time_limit ended it
  double seconds = 0;                            ///< it took, by the clock
  std::vector<Diagnosis> diagnosis;              ///< where not solved: why
};

/// Looks for the placement with the least measure: NLopt's controlled random search from several
/// starts, each followed by Sbplx; the given placement counts where it is inside the region. The
/// result does not depend on the number of threads. Stages of Monitor::progress: "search", "map",
/// perhaps "search" again, and those of plan().
/// @throws InvalidInput for an inverted or infinite region, unknown objects, options out of range,
/// and as plan().
PlacementResult place(const PlacementRequest& request, const PlanOptions& options = {});

/// What moving by `offset` makes of the problem.
/// @throws InvalidInput as place(), and where the task can't be built there.
PlacedProblem placed(const PlacementRequest& request, const Offset& offset);

}  // namespace wristwise
