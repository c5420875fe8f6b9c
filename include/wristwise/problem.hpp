#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "wristwise/export_options.hpp"
#include "wristwise/options.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/scene.hpp"
#include "wristwise/seam.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Everything that a problem file says.
struct Problem {
  std::string name;                    ///< names the output; any text
  std::shared_ptr<const Robot> robot;  ///< not null
  /// The caller's own; null: what find_inverse_kinematics finds.
  std::shared_ptr<const InverseKinematics> inverse_kinematics;
  Scene scene;                               ///< what to keep clear of
  Task task;                                 ///< seam, waypoints and tolerances
  CostOptions cost;                          ///< what is minimised
  GraphOptions graph;                        ///< of stage 1
  RefineOptions refine;                      ///< of stage 2
  double controller_period = 0.004;          ///< s, spacing of trajectory_dense.csv
  ExportOptions exports;                     ///< of robot programs
  std::vector<std::filesystem::path> files;  ///< that it was read from
};

/// How a problem file is read.
struct LoadOptions {
  bool mesh_cache = true;  ///< keep the pieces of meshes in .wristwise_cache beside the problem
};

/// Reads a problem file (docs/problem-file.md). Paths in it are relative to the file.
/// @throws InvalidInput with file, key and what was expected.
Problem load_problem(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace wristwise
