#pragma once

// A motion of the gantry whose values can be written down, and its pictures read back.

#include "gantry.hpp"
#include "picture/motion_picture.hpp"
#include "plot_reader.hpp"
#include "temporary_folder.hpp"

namespace wristwise::test {

constexpr double kDuration = 4;  // s

/// A weld of 1 m along x at z = 1 m in 4 s.
inline Problem gantry_problem(int waypoints = 20) {
  Problem problem;
  problem.name = "gantry";
  Robot::Parts parts = gantry::parts();
  parts.joints[0].max_velocity = 0.5;
  parts.joints[3].max_velocity = 50;
  parts.joints[3].max_acceleration = 5;
  problem.robot = gantry::robot(parts);
  problem.scene.find_permanent_contacts = false;
  problem.task = gantry::task({{0, 0, 1}, {1, 0, 1}}, kDuration, waypoints, gantry::box(0.01, 0.4));
  problem.task.between_position = 0.001;
  return problem;
}

/// Its k-th derivative: along the weld, swinging a little to the side and turning.
inline JointVector swing(double t, int k = 0) {
  const double turn = std::pow(2.0, k), phase = 2 * t + k * 1.5707963267948966;
  const double along = k == 0 ? t / kDuration : k == 1 ? 1 / kDuration : 0;
  return gantry::posture(along, 0.005 * turn * std::sin(phase), k == 0 ? 1 : 0,
                         0.3 * turn * std::sin(phase));
}

inline Trajectory swinging(const std::vector<double>& times) {
  std::vector<JointVector> positions, velocities, accelerations;
  for (const double t : times) {
    positions.push_back(swing(t));
    velocities.push_back(swing(t, 1));
    accelerations.push_back(swing(t, 2));
  }
  return {times, positions, velocities, accelerations};
}

inline std::vector<double> times_of(const Task& task) {
  std::vector<double> times;
  for (const Waypoint& waypoint : task.waypoints) times.push_back(waypoint.time);
  return times;
}

/// Two-stage, its seed without the swing.
inline PlanResult swinging_result(const Problem& problem) {
  PlanResult result;
  result.status = Status::solved;
  result.trajectory = swinging(times_of(problem.task));
  result.path = result.trajectory.waypoints();
  result.seeds.push_back({gantry::path_along(problem.task)});
  return result;
}

/// The pictures as files, read back.
class Plotted {
 public:
  Plotted(const Problem& problem, const PlanResult& result, const PlanResult* graph_only = nullptr)
      : names(write_motion_pictures(folder_.path(), problem, result, graph_only)) {}

  std::string text(const std::string& name) const { return file_text(folder_.path() / name); }
  PlotReader read(const std::string& name) const { return PlotReader(text(name)); }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;

 public:
  std::vector<std::string> names;
};

}  // namespace wristwise::test
