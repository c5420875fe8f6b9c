#pragma once

// Shipped arms as their makers publish them, as plain matrix products that share nothing with the
// library.

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "kuka_kr5_arc.hpp"

namespace wristwise::test {

struct PublishedJoint {
  std::string name;
  double range_deg;  ///< +-
  double speed_deg;  ///< per second
};

struct PublishedArm {
  std::string name;
  std::vector<PublishedJoint> joints;
  std::function<Eigen::Matrix4d(const Eigen::VectorXd&)> flange;
  std::vector<std::vector<double>> usual_postures_deg;
  double least_share_touching, largest_share_touching;  ///< of random postures, of itself

  RobotSource source() const {
    const std::string folder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/" + name + "/";
    RobotSource result;
    result.urdf = folder + name + ".urdf";
    result.base_link = "base_link";
    result.tip_link = "torch_tip";
    result.limits = folder + "joint_limits.yaml";
    return result;
  }
  std::shared_ptr<const Robot> load() const {
    return std::make_shared<const Robot>(load_robot(source()));
  }
};

inline void PrintTo(const PublishedArm& arm, std::ostream* out) { *out << arm.name; }

/// Denavit-Hartenberg: Rz(theta) Tz(d) Tx(a) Rx(alpha).
inline Eigen::Matrix4d denavit_hartenberg(double theta, double d, double a, double alpha) {
  return kr5::turn(2, theta) * kr5::shift({a, 0, d}) * kr5::turn(0, alpha);
}

/// Universal Robots UR10e.
inline PublishedArm offset_wrist_arm() {
  const auto flange = [](const Eigen::VectorXd& q) -> Eigen::Matrix4d {
    const double h = std::acos(0.0);
    return denavit_hartenberg(q[0], 0.1807, 0, h) * denavit_hartenberg(q[1], 0, -0.6127, 0) *
           denavit_hartenberg(q[2], 0, -0.57155, 0) * denavit_hartenberg(q[3], 0.17415, 0, h) *
           denavit_hartenberg(q[4], 0.11985, 0, -h) * denavit_hartenberg(q[5], 0.11655, 0, 0);
  };
  return {"offset_wrist_arm",
          {{"shoulder_pan_joint", 360, 120},
           {"shoulder_lift_joint", 360, 120},
           {"elbow_joint", 180, 180},
           {"wrist_1_joint", 360, 180},
           {"wrist_2_joint", 360, 180},
           {"wrist_3_joint", 360, 180}},
          flange,
          {{0, 0, 0, 0, 0, 0},
           {0, -90, 0, -90, 0, 0},
           {0, -90, 90, -90, -90, 0},
           {45, -60, -120, -90, 90, 30}},
          0.1,
          0.4};
}

/// KUKA LBR iiwa 14 R820: turns about the vertical and about the arm's side, one after another.
inline PublishedArm seven_axis_arm() {
  const auto flange = [](const Eigen::VectorXd& q) -> Eigen::Matrix4d {
    using kr5::turn;
    const auto up = [](double length) { return kr5::shift({0, 0, length}); };
    return up(0.36) * turn(2, q[0]) * turn(1, q[1]) * turn(2, q[2]) * up(0.42) * turn(1, -q[3]) *
           up(0.4) * turn(2, q[4]) * turn(1, q[5]) * turn(2, q[6]) * up(0.126);
  };
  return {"seven_axis_arm",
          {{"joint_a1", 170, 85},
           {"joint_a2", 120, 85},
           {"joint_a3", 170, 100},
           {"joint_a4", 120, 75},
           {"joint_a5", 170, 130},
           {"joint_a6", 120, 135},
           {"joint_a7", 175, 135}},
          flange,
          {{0, 0, 0, 0, 0, 0, 0}, {0, 30, 0, -60, 0, 90, 0}, {90, -45, 60, 100, -30, -70, 120}},
          0.001,
          0.02};
}

}  // namespace wristwise::test
