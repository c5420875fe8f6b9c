#pragma once

// Trees of links as a URDF has them. What a link's pose is comes from multiplying the joints from
// the root down, as they are written: it knows no chain.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "temporary_folder.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise::test {

/// A joint of a tree as a URDF has it; link i + 1 hangs on joint i.
struct TreeJoint {
  std::string name, type;
  int parent = 0;  // link
  Eigen::Vector3d xyz, rpy, axis;
};

inline std::string link_name(int link) { return fmt::format("l{}", link); }

inline std::string text(const Eigen::Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

inline Eigen::Matrix3d turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

struct Tree {
  std::vector<TreeJoint> joints;

  std::string urdf() const {
    std::string result = "<robot name=\"tree\">\n";
    for (int i = 0; i <= static_cast<int>(joints.size()); ++i) {
      result += fmt::format(
          "<link name=\"{}\"><collision><geometry><sphere radius=\"0.01\"/></geometry></collision>"
          "</link>\n",
          link_name(i));
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const TreeJoint& j = joints[i];
      result += fmt::format(
          "<joint name=\"{}\" type=\"{}\"><origin xyz=\"{}\" rpy=\"{}\"/><parent link=\"{}\"/>"
          "<child link=\"{}\"/><axis xyz=\"{}\"/>"
          "<limit lower=\"-1.5\" upper=\"2\" effort=\"0\" velocity=\"3\"/></joint>\n",
          j.name, j.type, text(j.xyz), text(j.rpy), link_name(j.parent),
          link_name(static_cast<int>(i) + 1), text(j.axis));
    }
    return result + "</robot>\n";
  }

  /// In the root, with the joints' values by name (0 where there is none).
  Pose link_pose(int link, const std::map<std::string, double>& values) const {
    if (link == 0) return Pose::Identity();
    const TreeJoint& joint = joints[static_cast<std::size_t>(link - 1)];
    Pose step = Pose::Identity();
    step.linear() = turn({0, 0, 1}, joint.rpy.z()) * turn({0, 1, 0}, joint.rpy.y()) *
                    turn({1, 0, 0}, joint.rpy.x());
    step.translation() = joint.xyz;
    const auto found = values.find(joint.name);
    const double value = found == values.end() ? 0 : found->second;
    if (joint.type == "prismatic") step.translate(value * joint.axis.normalized());
    if (joint.type == "revolute") step.rotate(turn(joint.axis, value));
    return link_pose(joint.parent, values) * step;
  }

  bool is_above(int ancestor, int link) const {
    for (; link != 0; link = joints[static_cast<std::size_t>(link - 1)].parent)
      if (link == ancestor) return true;
    return ancestor == 0;
  }
};

class Random {
 public:
  explicit Random(unsigned seed) : rng_(seed) {}
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng_);
  }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(rng_); }

  Tree tree(int count) {
    const char* const types[] = {"revolute", "revolute", "prismatic", "fixed"};
    Tree result;
    for (int i = 0; i < count; ++i) {
      const int parent = std::max(0, i - below(3));  // long branches
      result.joints.push_back(
          {fmt::format("j{}", i), types[below(4)], parent, vector(0.5), vector(3), vector(1)});
    }
    return result;
  }

 private:
  std::mt19937 rng_;
};

inline double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

inline std::map<std::string, double> named(const Robot& robot, const JointVector& q) {
  std::map<std::string, double> values;
  for (int j = 0; j < robot.joint_count(); ++j)
    values[robot.joints()[static_cast<std::size_t>(j)].name] = q[j];
  return values;
}

inline JointVector posture(const Robot& robot, Random& random) {
  JointVector q(robot.joint_count());
  for (double& value : q) value = random.uniform(-1.5, 2);
  return q;
}

/// world - (mount) - arm_base - (a) - arm - (b) - torch; world - (tilt) - frame - (turn) - table
inline Tree cell() {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), none(0, 0, 0);
  Tree tree;
  tree.joints = {{"mount", "fixed", 0, none, none, z},           // l1: arm's base
                 {"a", "revolute", 1, {0, 0, 0.4}, none, z},     // l2
                 {"b", "revolute", 2, {0.5, 0, 0}, none, y},     // l3: tip
                 {"tilt", "revolute", 0, {1, 0, 0.3}, none, x},  // l4
                 {"turn", "revolute", 4, {0, 0, 0.1}, none, z},  // l5: table
                 {"clamp", "fixed", 5, {0, 0, 0.05}, none, z}};  // l6
  return tree;
}

inline Robot load_cell(const TemporaryFolder& folder, const std::string& part,
                       const std::string& base = {}) {
  RobotSource source;
  source.urdf = folder.write("cell.urdf", cell().urdf());
  source.base_link = base;
  source.tip_link = "l3";
  source.part_link = part;
  return load_robot(source);
}

}  // namespace wristwise::test
