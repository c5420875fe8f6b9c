#pragma once

#include <map>
#include <memory>
#include <vector>

#include "graph/ladder_graph.hpp"
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
  std::size_t collision_checks = 0;  ///< exact distance queries
};

/// Samples the tolerance of every waypoint, solves the inverse kinematics of every sample, and
/// keeps every posture inside the joint limits that has the required clearance.
SampledPath sample_path(const Robot& robot, const Task& task, const InverseKinematics& ik,
                        const std::shared_ptr<const ClearanceModel>& clearance,
                        const CostOptions& cost, const GraphOptions& options, int threads,
                        const Monitor& monitor);

}  // namespace wristwise
