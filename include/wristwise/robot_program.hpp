#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wristwise/plan.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// What a trajectory can be written as.
enum class ProgramFormat {
  krl,              ///< KUKA: `<name>.src`
  rapid,            ///< ABB: `<name>.mod`
  ls,               ///< Fanuc: `<name>.ls`
  trajectory_msgs,  ///< ROS: joint_trajectory.yaml
  moveit,           ///< MoveIt: robot_trajectory.yaml
};

/// As `--export` takes it: krl, rapid, ls, trajectory_msgs or moveit.
std::string format_name(ProgramFormat format);
/// All of them.
const std::vector<ProgramFormat>& program_formats();

/// A place that the robot is sent to.
struct ProgramPoint {
  double time = 0;       ///< s, from the first point
  JointVector joints;    ///< rad or m, in the chain's order and signs
  bool welding = false;  ///< on the move that ends here
};

/// A motion as robot controllers take it: joint-space moves at constant rates from point to point.
struct RobotProgram {
  std::string name;                  ///< as in the problem; each format cuts it to its own rules
  std::vector<ProgramPoint> points;  ///< in order; the first is the start
  /// m: the farthest that the moves take the TCP from where the curve has it, looked at every half
  /// controller period. 0 where the plan is points already.
  double deviation = 0;
  double angle_deviation = 0;  ///< rad: likewise its orientation
};

/// The plan as such a program: its points where it is points, the curve thinned as the problem's
/// export options say where it is a curve.
/// @throws InvalidInput where there is nothing to export or the options are out of range.
RobotProgram robot_program(const PlanResult& result, const Problem& problem);

/// The same as text of a KUKA controller (docs/exports.md).
/// @throws InvalidInput where the axes of the options do not fit the robot.
std::string krl_text(const RobotProgram& program, const Problem& problem);
/// Of an ABB controller, as krl_text.
std::string rapid_text(const RobotProgram& program, const Problem& problem);
/// Of a Fanuc controller, as krl_text.
std::string ls_text(const RobotProgram& program, const Problem& problem);

/// The plan as trajectory_msgs/JointTrajectory, as ROS 2 prints messages: at the rows of
/// trajectory.csv, a curve with velocities and accelerations.
std::string joint_trajectory_text(const PlanResult& result, const Problem& problem);
/// The same as moveit_msgs/RobotTrajectory.
std::string robot_trajectory_text(const PlanResult& result, const Problem& problem);

/// The name that a format makes of a program's: its characters, its length.
std::string program_name(ProgramFormat format, const std::string& name);

/// @throws InvalidInput where a format cannot take this robot with these options. To be asked
/// before planning.
void check_export(ProgramFormat format, const Problem& problem);

/// Removes what an earlier run left under that name, and writes the program where the plan is
/// solved. @return the file; empty where the plan is not solved
std::filesystem::path write_program(ProgramFormat format, const std::filesystem::path& folder,
                                    const PlanResult& result, const Problem& problem);

}  // namespace wristwise
