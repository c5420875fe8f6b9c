#include <algorithm>
#include <cmath>

#include "import/program_move.hpp"
#include "import/ros_message.hpp"
#include "wristwise/error.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/program_file.hpp"

namespace wristwise {

namespace {

/// s: of the joint that needs longest for its step at the given shares (percent) of its limit.
double slowest_joint(const Robot& robot, const JointVector& step, const JointVector& percent) {
  double time = 0;
  for (int j = 0; j < step.size(); ++j) {
    const double limit = robot.joints()[static_cast<std::size_t>(j)].max_velocity;
    time = std::max(time, std::abs(step[j]) / (limit * percent[j] / 100));
  }
  return time;
}

/// One percentage for each joint.
JointVector joint_percent(const AxisValues& percent, const Robot& robot,
                          const std::vector<ControllerAxis>& axes) {
  JointVector values(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j)
    values[j] = percent[static_cast<std::size_t>(axes[static_cast<std::size_t>(j)].number)];
  return values;
}

double duration(const ProgramMove& move, const Robot& robot, const ControllerAxes& axes,
                const JointVector& from, const JointVector& to) {
  if (move.time) return *move.time;
  const JointVector full = JointVector::Constant(robot.joint_count(), 100);
  if (move.speed) {
    const double length =
        (tcp_pose(robot, to).translation() - tcp_pose(robot, from).translation()).norm();
    return std::max(length / *move.speed, slowest_joint(robot, to - from, full));
  }
  const AxisValues percent = move.percent.value_or(all_percent(100));
  return slowest_joint(robot, to - from, joint_percent(percent, robot, axes.axes()));
}

JointPath timed(const ProgramMoves& moves, const Robot& robot, const ControllerAxes& axes,
                const std::string& file) {
  JointPath path;
  for (const ProgramMove& move : moves) {
    if (move.linear)
      throw InvalidInput(move.where, "a linear move",
                         "joint moves; linear ones are a seam (path.segments: program)");
    if (!move.axes) throw InvalidInput(move.where, "a joint move to a pose", "values of the axes");
    const JointVector joints = axes.joints(*move.axes, move.where);
    if (path.size() == 0) {
      path.times.push_back(0);
    } else {
      const double time = duration(move, robot, axes, path.positions.back(), joints);
      if (time == 0) continue;
      if (!(time > 0) || !std::isfinite(path.times.back() + time))
        throw InvalidInput(move.where, "no time for this move", "a speed limit of each joint");
      path.times.push_back(path.times.back() + time);
    }
    path.positions.push_back(joints);
  }
  if (path.size() < 2)
    throw InvalidInput(file, std::to_string(path.size()) + " points", "at least two");
  return path;
}

JointPath read_program(const std::filesystem::path& file, const Robot& robot,
                       const ExportOptions& options, double start_time) {
  JointPath path = is_program(file) ? timed(read_moves(file, options.ls.j3_coupling), robot,
                                            ControllerAxes(robot, options.axes), file.string())
                                    : read_ros_message(file, robot.joint_names());
  for (double& time : path.times) time += start_time;
  return path;
}

}  // namespace

JointPath read_joint_path(const std::filesystem::path& file, const Robot& robot,
                          const ExportOptions& options, double start_time) {
  if (is_program(file) || is_ros_message(file))
    return read_program(file, robot, options, start_time);
  return read_trajectory(file, robot.joint_names()).path;
}

}  // namespace wristwise
