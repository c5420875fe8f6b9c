#pragma once

#include <map>
#include <memory>
#include <vector>

#include "graph/rung.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/monitor.hpp"
#include "wristwise/options.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// What became of the samples of one waypoint.
struct SampleCounts {
  std::size_t samples = 0;                                 ///< poses tried
  std::size_t out_of_reach = 0;                            ///< poses without a branch
  std::map<int, std::size_t> joint_limit;                  ///< joint -> branches that it excludes
  std::map<ClearanceModel::Names, std::size_t> collision;  ///< pair -> postures it excludes
};

struct SampledPath {
  std::vector<Rung> rungs;  ///< may be empty of vertices
  std::vector<SampleCounts> counts;
  std::size_t postures = 0;          ///< inside the joint limits, whole turns not counted
  std::size_t collision_checks = 0;  ///< exact distance queries
};

/// What sampling needs beside the task.
struct SamplingInput {
  const Robot& robot;
  const InverseKinematics& ik;
  std::shared_ptr<const ClearanceModel> clearance;
  const CostOptions& cost;
  const GraphOptions& options;
};

/// rad: 2 pi for the joints that have copies by whole turns inside their limits, else infinity.
JointVector turn_periods(const Robot& robot, Turns turns);

/// What a posture costs at a waypoint: its Euler deviation (eq. 9) and the nearness of a
/// singularity.
double posture_cost(const SamplingInput& input, const Waypoint& waypoint, const JointVector& q);

/// Samples the tolerance of every waypoint, solves the inverse kinematics of every sample, and
/// keeps every posture inside the joint limits, once for all its copies by whole turns. With
/// CollisionChecks::eager those without the required clearance are left out.
SampledPath sample_path(const SamplingInput& input, const Task& task, int threads,
                        const Monitor& monitor);

/// The same on a grid of its own for each waypoint (deviations, m and rad), clearance not checked.
std::vector<Rung> sample_grids(const SamplingInput& input, const Task& task,
                               const std::vector<std::vector<Vector6>>& grids, int threads);

/// The samples of one waypoint that have the required clearance.
Rung sample_waypoint(const SamplingInput& input, const Waypoint& waypoint, SampleCounts& counts);

}  // namespace wristwise
