#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wristwise/trajectory.hpp"

namespace wristwise {

/// What a trajectory.csv holds: points, and a curve where it has velocity and acceleration columns.
struct TrajectoryFile {
  JointPath path;
  std::optional<Trajectory> trajectory;
};

/// Reads `time,<joint>,...` (s, rad or m), in any column order, extra columns ignored.
/// @throws InvalidInput with file and line: a joint is missing, a cell is no finite number, times
/// do not increase, or there are fewer than two rows.
TrajectoryFile read_trajectory(const std::filesystem::path& file,
                               const std::vector<std::string>& joint_names);

/// Write CSV with as many digits as give the same double back; the file appears whole or not at
/// all.
void write_path(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                const JointPath& path);
void write_trajectory(const std::filesystem::path& file,
                      const std::vector<std::string>& joint_names, const Trajectory& trajectory);
/// The curve sampled every `period` s, and at its end.
void write_dense(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                 const Trajectory& trajectory, double period);

}  // namespace wristwise
