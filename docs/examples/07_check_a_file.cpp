// Checks a trajectory from anywhere against a problem: the check that has the last word in
// planning, which shares no cost and no constraint with it.
//
// A file with velocity and acceleration columns is a curve, and everything is shown for all t. A
// file without them is a list of points joined by straight joint-space moves.

#include <iostream>
#include <wristwise/wristwise.hpp>

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw wristwise::InvalidInput("usage", "PROBLEM.yaml TRAJECTORY.csv");
    const wristwise::Problem problem = wristwise::load_problem(argv[1]);
    const wristwise::TrajectoryFile file =
        wristwise::read_trajectory(argv[2], problem.robot->joint_names());

    const wristwise::Verification found = wristwise::check(problem, file);
    std::cout << (found.curve ? "a curve of " : "a list of ") << file.path.size() << " points\n"
              << "position beyond the tolerance: " << 1000 * found.position_error << " mm\n"
              << "joint speed / limit: " << found.velocity_ratio << '\n';
    // Absent where no pair of bodies counts.
    if (found.clearance)
      std::cout << "clearance: " << 1000 * *found.clearance << " mm between "
                << found.clearance_pair.first << " and " << found.clearance_pair.second << '\n';

    // Each line says what is wrong, where, and by how much.
    for (const std::string& failure : found.failures) std::cout << "failure: " << failure << '\n';
    for (const std::string& warning : found.warnings) std::cout << "warning: " << warning << '\n';
    std::cout << (found.passed ? "passed\n" : "rejected\n");
    return found.passed ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
