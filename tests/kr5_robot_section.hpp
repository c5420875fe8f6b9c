#pragma once

#include <string>

namespace wristwise::test {

/// Of a problem file: the KUKA KR 5 arc without a torch.
inline const std::string kKr5Folder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
inline const std::string kKr5RobotSection = "robot:\n  urdf: " + kKr5Folder +
                                            "kuka_kr5_arc.urdf\n"
                                            "  base_link: base_link\n"
                                            "  tip_link: tool0\n"
                                            "  limits: " +
                                            kKr5Folder + "joint_limits.yaml\n";

}  // namespace wristwise::test
