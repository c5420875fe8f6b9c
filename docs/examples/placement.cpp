// Where on its table should the part of a problem file stand? A quick look, with few evaluations.

#include <iostream>
#include <wristwise/wristwise.hpp>

int main(int, char** argv) {
  try {
    wristwise::PlacementRequest request = wristwise::load_placement(argv[1]);
    request.options.evaluations = 24;
    request.options.map_points = 0;
    const wristwise::PlacementResult result = wristwise::place(request);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    std::cout << "given: " << result.given.measure.value
              << ", found: " << result.found.measure.value << " at "
              << result.after.placed.part_frame.translation().transpose() << " m\n";
    return result.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
