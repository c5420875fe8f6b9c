#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wristwise/seam.hpp"
#include "wristwise/trajectory.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// What a trajectory.csv holds: points, a curve where it has velocity and acceleration columns, and
/// the time law of the seam (s) where it has the columns of that.
struct TrajectoryFile {
  JointPath path;                        ///< the rows
  std::optional<Trajectory> trajectory;  ///< the curve through them
  std::optional<Trajectory> seam_time;   ///< one joint: nominal time over real time, s
};

/// What a file says about the seam, beside the joints.
class SeamColumns {
 public:
  SeamColumns() = default;  ///< nothing
  /// `welding` (1 or 0) where the task has a run-in or a run-out; `seam_time`,
  /// `seam_time_velocity` and `seam_time_acceleration` (s, 1, 1/s) where its seam is retimed.
  explicit SeamColumns(const Task& task);

  std::vector<std::string> names() const;      ///< of the columns; none: nothing is said
  std::vector<double> values(double t) const;  ///< at time t (s)

 private:
  bool has_welding_ = false;
  double weld_start_ = 0, weld_end_ = 0;
  Seam seam_;
};

/// Reads `time,<joint>,...` (s, rad or m), in any column order, extra columns ignored. A time law
/// is read where all three columns `seam_time...` are there.
/// @throws InvalidInput with file and line: a joint is missing, a cell is no finite number, times
/// do not increase, or there are fewer than two rows.
TrajectoryFile read_trajectory(const std::filesystem::path& file,
                               const std::vector<std::string>& joint_names);

/// Writes points as CSV with as many digits as give the same double back; the file appears whole or
/// not at all. @throws InvalidInput where its folder does not exist; std::runtime_error where it
/// can't be written
void write_path(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                const JointPath& path, const SeamColumns& seam = {});
/// As write_path, with a velocity and an acceleration column for each joint.
void write_trajectory(const std::filesystem::path& file,
                      const std::vector<std::string>& joint_names, const Trajectory& trajectory,
                      const SeamColumns& seam = {});
/// The curve sampled every `period` s, and at its end.
void write_dense(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                 const Trajectory& trajectory, double period, const SeamColumns& seam = {});

}  // namespace wristwise
