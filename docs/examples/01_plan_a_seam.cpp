// Plans the seam of a problem file and writes the joint trajectory.

#include <iostream>
#include <wristwise/wristwise.hpp>

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw wristwise::InvalidInput("usage", "PROBLEM.yaml TRAJECTORY.csv");
    const wristwise::Problem problem = wristwise::load_problem(argv[1]);

    // Graph search, refinement, and an independent check. No solution is no exception: the result
    // says where and why there is none, and what would help.
    const wristwise::PlanResult result = wristwise::plan(problem);
    for (const auto& diagnosis : result.diagnosis)
      std::cout << diagnosis.detail << "; " << diagnosis.suggestion << '\n';
    if (result.status != wristwise::Status::solved) return 1;

    // Solved means: checked, for all t. The trajectory is a curve; a row is a waypoint.
    write_trajectory(argv[2], problem.robot->joint_names(), result.trajectory);
    std::cout << result.path.size() << " waypoints, cost " << result.refine.objective << '\n';
    return 0;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
