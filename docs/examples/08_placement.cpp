// Where should the part stand? A problem file with a section `placement` gives the region in which
// part, or robot, may be moved; what is looked for is a place where joints are slow, the wrist is
// far from singular, and the clearance is wide.

#include <iostream>
#include <wristwise/wristwise.hpp>

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw wristwise::InvalidInput("usage", "PROBLEM.yaml");
    wristwise::PlacementRequest request = wristwise::load_placement(argv[1]);

    // A quick look: as many placements are measured, each by planning the seam there. Left at 0
    // there are 100, and 100 more for each coordinate that may change.
    request.options.evaluations = 24;
    request.options.map_points = 0;  // no map of the measure

    const wristwise::PlacementResult result = wristwise::place(request);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    if (result.status != wristwise::Status::solved) return 1;

    // The measure is 0 at best. `after` holds the problem with the part where it was found, planned
    // in full and checked.
    std::cout << "given: " << result.given.measure.value
              << ", found: " << result.found.measure.value << " at "
              << result.after.placed.part_frame.translation().transpose() << " m\n"
              << "joint speed / limit: " << result.before.two_stage.verification.velocity_ratio
              << " -> " << result.after.two_stage.verification.velocity_ratio << '\n';
    return 0;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
