#pragma once

// A robot on a rail and a plan of a few points: run-in, weld, run-out.

#include <memory>

#include "wristwise/robot_program.hpp"

namespace wristwise::test {

constexpr double kDegree = 3.14159265358979323846 / 180;

/// A rail, then six turning joints.
inline std::shared_ptr<const Robot> rail_robot() {
  Robot::Parts parts;
  parts.name = "rail robot";
  parts.base_link = "floor";
  parts.tip_link = "tip";
  for (int j = 0; j < 7; ++j) {
    Joint joint;
    joint.name = j == 0 ? "rail" : "joint_" + std::to_string(j);
    joint.type = j == 0 ? JointType::prismatic : JointType::revolute;
    joint.axis = j == 0 || j == 2 || j == 3 || j == 5 ? Eigen::Vector3d::UnitY()
                 : j == 1                             ? Eigen::Vector3d::UnitZ()
                                                      : Eigen::Vector3d::UnitX();
    joint.origin.translation() = Eigen::Vector3d(0.1 * j, 0, 0.3);
    joint.lower = -4;
    joint.upper = 4;
    joint.max_velocity = 2;
    joint.max_acceleration = joint.max_jerk = 100;
    parts.joints.push_back(joint);
  }
  parts.tcp.translation() = Eigen::Vector3d(0.3, 0, 0);
  return std::make_shared<const Robot>(parts);
}

/// A task with waypoints at these times; the first and last intervals are run-in and run-out.
inline Task task_with_runs(const std::vector<double>& times) {
  SeamPiece piece;
  piece.start_time = times.front();
  piece.end_time = times.back();
  piece.to.translation() = Eigen::Vector3d(1, 0, 0);
  Task task;
  task.seam = Seam({piece});
  for (std::size_t i = 0; i < times.size(); ++i) {
    Waypoint waypoint;
    waypoint.time = times[i];
    waypoint.welding = i > 0 && i + 1 < times.size();
    task.waypoints.push_back(waypoint);
  }
  return task;
}

inline JointVector rail_posture(double rail_mm, const std::array<double, 6>& degrees) {
  JointVector q(7);
  q[0] = rail_mm * 1e-3;
  for (int j = 0; j < 6; ++j) q[j + 1] = degrees[static_cast<std::size_t>(j)] * kDegree;
  return q;
}

struct ExportExample {
  Problem problem;
  PlanResult result;
};

/// Five points; the weld runs from 0 to 2 s.
inline ExportExample export_example() {
  ExportExample example;
  example.problem.name = "short-weld";
  example.problem.robot = rail_robot();
  example.problem.task = task_with_runs({-1, 0, 0.75, 2, 3.5});
  example.result.status = Status::solved;
  example.result.path.times = {-1, 0, 0.75, 2, 3.5};
  example.result.path.positions = {rail_posture(-1000, {10, -90, 100, 0, 45, 170}),
                                   rail_posture(0, {11, -91, 101.5, 0.25, 45, 170}),
                                   rail_posture(12.5, {12, -92, 103, 0.5, 44.5, 171}),
                                   rail_posture(25, {13, -93, 104.5, -0.00001, 44, 172}),
                                   rail_posture(30, {14, -80, 90, 5, 40, -172.125})};
  return example;
}

}  // namespace wristwise::test
