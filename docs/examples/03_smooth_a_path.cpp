// Smooths a joint path that was recorded, taught or planned elsewhere. Nothing is needed but the
// robot: no seam, no scene, no inverse kinematics.
//
// The path is its rows, joined by straight moves. At any time the TCP stays within a tolerance of
// where the path has it at that time; within that, the joints move as smoothly as they can. The
// result has the same times, and more rows where those of the path are far apart.

#include <iomanip>
#include <iostream>
#include <string>
#include <wristwise/wristwise.hpp>

namespace {

/// The largest |d^k q / dt^k| of each joint, from the points.
wristwise::JointVector peaks(const wristwise::JointPath& path, int order) {
  wristwise::JointVector largest = wristwise::JointVector::Zero(path.positions.front().size());
  for (const wristwise::JointVector& value : divided_differences(path, order))
    largest = largest.cwiseMax(value.cwiseAbs());
  return largest;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 5)
      throw wristwise::InvalidInput("usage", "ROBOT.urdf LIMITS.yaml PATH.csv SMOOTH.csv");
    // Acceleration and jerk limits stand in no URDF; they come from MoveIt's joint_limits.yaml. The
    // chain runs from the root of the tree to its farthest tip, unless `source` names other links.
    wristwise::RobotSource source;
    source.urdf = argv[1];
    source.limits = argv[2];
    const auto robot = std::make_shared<const wristwise::Robot>(wristwise::load_robot(source));
    const wristwise::JointPath path =
        wristwise::read_trajectory(argv[3], robot->joint_names()).path;

    wristwise::SmoothingOptions smoothing;
    smoothing.position_tolerance = 0.5e-3;                   // m
    smoothing.angle_tolerance = 0.5 * 0.017453292519943295;  // rad: 0.5 deg
    const wristwise::PlanResult result = wristwise::smooth(robot, path, smoothing);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    if (result.trajectory.empty()) return 1;

    const wristwise::JointVector before = peaks(path, 3);
    const wristwise::JointVector after = peaks(result.trajectory.waypoints(), 3);
    std::cout << "peak jerk, rad/s^3\n";
    for (int j = 0; j < robot->joint_count(); ++j)
      std::cout << std::setw(12) << robot->joint_names()[static_cast<std::size_t>(j)]
                << std::setw(12) << before[j] << " -> " << after[j] << '\n';
    std::cout << (result.verification.passed ? "check passed\n" : "check failed\n");

    write_trajectory(argv[4], robot->joint_names(), result.trajectory);
    return result.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
