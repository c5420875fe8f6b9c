#pragma once

// Arms without a closed form in the library, from published dimensions.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "wristwise/robot.hpp"

namespace wristwise::test {

/// Standard Denavit-Hartenberg: Rz(q) Tz(d) Tx(a) Rx(alpha).
struct DhRow {
  double d, a, alpha;  // m, m, rad
  double limit;        // rad, either way
};

inline std::shared_ptr<const Robot> dh_arm(const std::string& name, const std::vector<DhRow>& rows,
                                           const Pose& tool = Pose::Identity()) {
  const auto link = [](const DhRow& row) {
    Pose pose = Pose::Identity();
    pose.translate(Eigen::Vector3d(row.a, 0, row.d));
    pose.rotate(Eigen::AngleAxisd(row.alpha, Eigen::Vector3d::UnitX()));
    return pose;
  };
  Robot::Parts parts;
  parts.name = name;
  Pose origin = Pose::Identity();
  for (const DhRow& row : rows) {
    Joint joint;
    joint.name = "joint_" + std::to_string(parts.joints.size() + 1);
    joint.origin = origin;
    joint.lower = -row.limit;
    joint.upper = row.limit;
    joint.max_velocity = 3;
    joint.max_acceleration = joint.max_jerk = std::numeric_limits<double>::infinity();
    parts.joints.push_back(joint);
    origin = link(row);
  }
  parts.tcp = origin * tool;
  return std::make_shared<const Robot>(parts);
}

constexpr double kQuarterTurn = 1.57079632679489661923;

/// Universal Robots, "DH parameters for calculations of kinematics and dynamics": UR5e.
inline const std::vector<DhRow>& ur5e_rows() {
  static const std::vector<DhRow> rows = {{0.1625, 0, kQuarterTurn, 4 * kQuarterTurn},
                                          {0, -0.425, 0, 4 * kQuarterTurn},
                                          {0, -0.3922, 0, 2 * kQuarterTurn},
                                          {0.1333, 0, kQuarterTurn, 4 * kQuarterTurn},
                                          {0.0997, 0, -kQuarterTurn, 4 * kQuarterTurn},
                                          {0.0996, 0, 0, 4 * kQuarterTurn}};
  return rows;
}

/// Likewise: UR10e.
inline const std::vector<DhRow>& ur10e_rows() {
  static const std::vector<DhRow> rows = {{0.1807, 0, kQuarterTurn, 4 * kQuarterTurn},
                                          {0, -0.6127, 0, 4 * kQuarterTurn},
                                          {0, -0.57155, 0, 2 * kQuarterTurn},
                                          {0.17415, 0, kQuarterTurn, 4 * kQuarterTurn},
                                          {0.11985, 0, -kQuarterTurn, 4 * kQuarterTurn},
                                          {0.11655, 0, 0, 4 * kQuarterTurn}};
  return rows;
}

inline std::shared_ptr<const Robot> ur5e() { return dh_arm("ur5e", ur5e_rows()); }
inline std::shared_ptr<const Robot> ur10e() { return dh_arm("ur10e", ur10e_rows()); }

/// KUKA, LBR iiwa 14 R820 data sheet: 360, 420, 400 and 126 mm; 170 deg, 120 deg in turns, 175 deg.
inline std::shared_ptr<const Robot> iiwa14() {
  constexpr double wide = 170 * kQuarterTurn / 90, narrow = 120 * kQuarterTurn / 90;
  return dh_arm("iiwa14", {{0.36, 0, -kQuarterTurn, wide},
                           {0, 0, kQuarterTurn, narrow},
                           {0.42, 0, kQuarterTurn, wide},
                           {0, 0, -kQuarterTurn, narrow},
                           {0.4, 0, -kQuarterTurn, wide},
                           {0, 0, kQuarterTurn, narrow},
                           {0.126, 0, 0, 175 * kQuarterTurn / 90}});
}

/// Three parallel axes; links of 0.5, 0.4 and 0.2 m.
inline std::shared_ptr<const Robot> planar_3r() {
  return dh_arm("planar 3R", {{0, 0.5, 0, 2.6}, {0, 0.4, 0, 2.6}, {0, 0.2, 0, 2.6}});
}

}  // namespace wristwise::test
