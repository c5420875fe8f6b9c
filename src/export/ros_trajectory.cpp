// trajectory_msgs/msg/JointTrajectory and moveit_msgs/msg/RobotTrajectory, in the layout of
// rosidl_runtime_py's message_to_yaml, which `ros2 topic echo` prints.

#include <cmath>
#include <cstdint>

#include "export/ros_yaml.hpp"
#include "wristwise/robot_program.hpp"

namespace wristwise {

namespace {

constexpr std::int64_t kNanoseconds = 1000000000;

void append_header(int indent, const std::string& frame, RosYaml& yaml) {
  yaml.key(indent, "header");
  yaml.key(indent + 2, "stamp");
  yaml.value(indent + 4, "sec", "0");
  yaml.value(indent + 4, "nanosec", "0");
  yaml.value(indent + 2, "frame_id", yaml_word(frame));
}

void append_derivative(int indent, const std::string& name,
                       const std::vector<JointVector>& derivatives, std::size_t i, RosYaml& yaml) {
  if (derivatives.empty())
    yaml.empty_list(indent, name);
  else
    yaml.numbers(indent, name, derivatives[i].data(),
                 static_cast<std::size_t>(derivatives[i].size()));
}

void append_trajectory(int indent, const PlanResult& result, const Problem& problem,
                       RosYaml& yaml) {
  const bool curve = !result.trajectory.empty();
  const JointPath path = curve ? result.trajectory.waypoints() : result.path;
  validate(path, problem.robot->joint_count(), "export");
  const std::vector<std::string> names = problem.robot->joint_names();

  append_header(indent, problem.robot->base_link(), yaml);
  yaml.words(indent, "joint_names", names);
  yaml.key(indent, "points");
  const int inner = indent + 2;
  for (std::size_t i = 0; i < path.size(); ++i) {
    yaml.numbers(inner, "positions", path.positions[i].data(), names.size(), true);
    append_derivative(inner, "velocities", result.trajectory.velocities(), i, yaml);
    append_derivative(inner, "accelerations", result.trajectory.accelerations(), i, yaml);
    yaml.empty_list(inner, "effort");
    yaml.key(inner, "time_from_start");
    const std::int64_t time =
        std::llround((path.times[i] - path.times[0]) * static_cast<double>(kNanoseconds));
    yaml.value(inner + 2, "sec", std::to_string(time / kNanoseconds));
    yaml.value(inner + 2, "nanosec", std::to_string(time % kNanoseconds));
  }
}

}  // namespace

std::string joint_trajectory_text(const PlanResult& result, const Problem& problem) {
  RosYaml yaml;
  append_trajectory(0, result, problem, yaml);
  return yaml.text();
}

std::string robot_trajectory_text(const PlanResult& result, const Problem& problem) {
  RosYaml yaml;
  yaml.key(0, "joint_trajectory");
  append_trajectory(2, result, problem, yaml);
  yaml.key(0, "multi_dof_joint_trajectory");
  append_header(2, problem.robot->base_link(), yaml);
  yaml.empty_list(2, "joint_names");
  yaml.empty_list(2, "points");
  return yaml.text();
}

}  // namespace wristwise
