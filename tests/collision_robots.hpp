#pragma once

#include <memory>

#include "collision_samples.hpp"
#include "wristwise/clearance.hpp"

namespace wristwise::test {

inline Pose at(double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); }

inline Joint revolute(const std::string& name, const Pose& origin, const Eigen::Vector3d& axis,
                      double limit = 2.5) {
  return {name, JointType::revolute, origin, axis, -limit, limit, 1, 1, 1};
}

/// Six turning joints after a rail, one of them continuous, with every kind of shape. The torch is
/// a capsule.
inline Robot::Parts arm_parts() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  Robot::Parts parts;
  parts.name = "arm";
  parts.base_link = "base";
  parts.tip_link = "torch";
  Joint rail{"rail", JointType::prismatic, at(0, 0, 0.1), y, -0.5, 0.7, 1, 1, 1};
  Joint turning{"j4", JointType::continuous, at(0.3, 0, 0.05), x, -HUGE_VAL, HUGE_VAL, 1, 1, 1};
  Pose tilted = at(0.1, 0.02, 0.3);
  tilted.linear() = Eigen::AngleAxisd(0.2, x).toRotationMatrix();
  parts.joints = {rail,
                  revolute("j1", tilted, z),
                  revolute("j2", at(0.1, 0, 0.1), y),
                  revolute("j3", at(0, 0, 0.5), y),
                  turning,
                  revolute("j5", at(0.25, 0, 0), y, 2),
                  revolute("j6", at(0.05, 0, 0), x)};
  Pose lying = Pose::Identity();
  lying.linear() = Eigen::AngleAxisd(kPi / 2, y).toRotationMatrix();
  std::mt19937 random(7);
  const Pose torch = at(0.1, 0, 0) * lying;
  parts.links = {
      {"base", -1, Pose::Identity(), {{Box{{0.4, 1.6, 0.1}}}}},
      {"carriage", 0, at(0, 0, 0.08), {{Box{{0.3, 0.3, 0.12}}}}},
      {"shoulder", 1, Pose::Identity(), {{Cylinder{0.1, 0.2}}}},
      {"upper", 2, at(0, 0, 0.25), {{Box{{0.1, 0.12, 0.5}}}, {Sphere{0.09}, at(0, 0, 0.25)}}},
      {"elbow", 3, Pose::Identity(), {{random_hull(random), at(0.1, 0, 0)}}},
      {"fore", 4, lying, {{Cylinder{0.05, 0.3}, at(0, 0, 0.08)}}},
      {"wrist", 5, Pose::Identity(), {{Sphere{0.06}}}},
      {"torch",
       6,
       torch,
       {{Cylinder{0.02, 0.2}}, {Sphere{0.02}, at(0, 0, 0.1)}, {Sphere{0.02}, at(0, 0, -0.1)}}}};
  parts.tcp = at(0.2, 0, 0);
  parts.adjacent_links = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}};
  return parts;
}

inline std::shared_ptr<const Robot> arm() { return std::make_shared<const Robot>(arm_parts()); }

inline Scene workshop() {
  Scene scene;
  scene.objects = {{"table", {{Box{{0.6, 1.2, 0.04}}, at(0.9, 0, 0.3)}}},
                   {"post", {{Cylinder{0.04, 1}, at(0.5, -0.6, 0.5)}}},
                   {"ball", {{Sphere{0.1}, at(0.6, 0.4, 0.9)}}}};
  scene.find_permanent_contacts = false;
  return scene;
}

inline JointVector random_posture(const Robot& robot, std::mt19937& random) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const bool bounded = std::isfinite(joint.lower);
    q[j] = uniform(random, bounded ? joint.lower : -kPi, bounded ? joint.upper : kPi);
  }
  return q;
}

}  // namespace wristwise::test
