#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "wristwise/robot.hpp"
#include "wristwise/seam_description.hpp"

// Seams to build in tests.
namespace wristwise::test {

/// Three sliding axes: the TCP's position is the joint vector.
inline Robot sliding_robot() {
  Robot::Parts parts;
  parts.name = "gantry";
  parts.base_link = "base";
  parts.tip_link = "tip";
  for (int i = 0; i < 3; ++i) {
    Joint joint;
    joint.name = std::string(1, static_cast<char>('x' + i));
    joint.type = JointType::prismatic;
    joint.axis = Eigen::Vector3d::Unit(i);
    joint.lower = -2;
    joint.upper = 2;
    joint.max_velocity = 0.5 * (i + 1);
    joint.max_acceleration = joint.max_jerk = std::numeric_limits<double>::infinity();
    parts.joints.push_back(joint);
  }
  return Robot(parts);
}

inline Pose at(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() << x, y, z;
  return pose;
}

/// first, first + step, ... below last.
inline std::vector<double> steps(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step < last; ++i) values.push_back(first + i * step);
  return values;
}

/// Turned by `angle` (rad) about z.
inline Pose turned_at(double x, double y, double angle) {
  return at(x, y, 0) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
}

inline Segment line(const Pose& from, const Pose& to, const std::string& where = "line") {
  return {LineSegment{from, to}, {}, where};
}

/// 10 mm/s, a waypoint every 5 mm.
inline SeamDescription describe(std::vector<Segment> segments) {
  SeamDescription description;
  description.segments = std::move(segments);
  description.speed = 0.01;
  description.spacing = 0.005;
  description.where = "path";
  return description;
}

}  // namespace wristwise::test
