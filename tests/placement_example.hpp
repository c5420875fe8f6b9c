#pragma once

// A short seam on a small plate before the KUKA KR 5 arc, and where it may stand.

#include <string>

#include "temporary_folder.hpp"
#include "wristwise/placement.hpp"

namespace wristwise::test {

inline std::string placement_text(const std::string& placement) {
  const std::string robot = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  return "robot:\n  urdf: " + robot +
         "kuka_kr5_arc.urdf\n  base_link: base_link\n  tip_link: torch_tip\n  limits: " + robot +
         R"(joint_limits.yaml
scene:
  objects:
    - {name: plate, box: [0.1, 0.2, 0.01], xyz: [1.0, 0, 0.79]}
    - {name: pillar, cylinder: [0.03, 0.6], xyz: [1.2, -0.5, 0.3]}
  clearance: 0.003
path:
  frame: {xyz: [1.0, 0, 0.8]}
  speed: 0.02
  waypoints: 7
  segments:
    - line: {from: {xyz: [0, -0.06, 0], rpy: [0, 135 deg, 0]}, to: {xyz: [0, 0.06, 0], rpy: [0, 135 deg, 0]}}
  tolerance: {rz: 10 deg}
graph: {samples: {rz: 10 deg}}
)" +
         "placement: " + placement + "\n";
}

inline PlacementRequest placement_request(const TemporaryFolder& folder,
                                          const std::string& placement) {
  return load_placement(folder.write("placement.yaml", placement_text(placement)));
}

}  // namespace wristwise::test
