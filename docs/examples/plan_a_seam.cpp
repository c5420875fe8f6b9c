#include <iostream>
#include <wristwise/wristwise.hpp>

int main(int, char** argv) {
  try {
    const wristwise::Problem problem = wristwise::load_problem(argv[1]);
    const wristwise::PlanResult result = wristwise::plan(problem);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    std::cout << "cost " << result.refine.objective << ", " << result.path.size() << " waypoints\n";
    return result.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
