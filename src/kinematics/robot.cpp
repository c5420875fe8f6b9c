#include "wristwise/robot.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kRotationTolerance = 1e-9;

void require_rigid(const Pose& pose, const std::string& where) {
  if (!pose.matrix().allFinite()) throw InvalidInput(where, "a pose is not finite");
  const Eigen::Matrix3d rotation = pose.linear();
  const double error = (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm();
  if (error > kRotationTolerance || rotation.determinant() < 0) {
    throw InvalidInput(where, "the rotation of a pose is not orthonormal", "a rigid pose");
  }
}

void require_positive(double value, const std::string& where, const std::string& what) {
  if (!(value > 0)) {
    throw InvalidInput(where, what + " is " + std::to_string(value), "a positive number");
  }
}

void validate_limits(const Joint& joint, const std::string& where) {
  if (std::isnan(joint.lower) || std::isnan(joint.upper)) {
    throw InvalidInput(where, "a position limit is NaN");
  }
  if (joint.lower > joint.upper) {
    throw InvalidInput(where,
                       "lower limit " + std::to_string(joint.lower) + " exceeds upper limit " +
                           std::to_string(joint.upper),
                       "lower <= upper");
  }
  const bool unbounded = std::isinf(joint.lower) && std::isinf(joint.upper);
  const bool bounded = std::isfinite(joint.lower) && std::isfinite(joint.upper);
  if (joint.type == JointType::continuous ? !unbounded : !bounded) {
    throw InvalidInput(where, "the position limits do not suit the joint type",
                       "finite limits, or none for a continuous joint");
  }
  require_positive(joint.max_velocity, where, "max_velocity");
  require_positive(joint.max_acceleration, where, "max_acceleration");
  require_positive(joint.max_jerk, where, "max_jerk");
}

void validate_joint(Joint& joint, const std::string& where) {
  require_rigid(joint.origin, where);
  const double length = joint.axis.norm();
  if (!std::isfinite(length) || length < 1e-9) {
    throw InvalidInput(where, "the axis has no direction", "a vector that is not zero");
  }
  joint.axis /= length;
  validate_limits(joint, where);
}

void validate_links(const Robot::Parts& parts, const std::string& where) {
  const int joint_count = static_cast<int>(parts.joints.size());
  const int link_count = static_cast<int>(parts.links.size());
  std::set<std::string> names;
  for (const Link& link : parts.links) {
    const std::string here = where + ", link '" + link.name + "'";
    if (!names.insert(link.name).second) throw InvalidInput(here, "the name is given twice");
    if (link.joint < -1 || link.joint >= joint_count) {
      throw InvalidInput(here, "hangs on joint " + std::to_string(link.joint),
                         "an index from -1 to " + std::to_string(joint_count - 1));
    }
    require_rigid(link.pose, here);
    for (const Shape& shape : link.collision) require_rigid(shape.pose, here);
  }
  for (const auto& [a, b] : parts.adjacent_links) {
    if (a < 0 || b < 0 || a >= link_count || b >= link_count || a == b) {
      throw InvalidInput(where, "a pair of adjacent links names no two links");
    }
  }
}

template <typename Member>
JointVector gather(const std::vector<Joint>& joints, Member member) {
  JointVector values(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    values[static_cast<Eigen::Index>(j)] = joints[j].*member;
  }
  return values;
}

}  // namespace

Robot::Robot(Parts parts) : parts_(std::move(parts)) {
  const std::string where = "robot '" + parts_.name + "'";
  if (parts_.joints.empty() || parts_.joints.size() > static_cast<std::size_t>(kMaxJoints)) {
    throw InvalidInput(where, std::to_string(parts_.joints.size()) + " movable joints",
                       "1 to " + std::to_string(kMaxJoints));
  }
  std::set<std::string> names;
  for (Joint& joint : parts_.joints) {
    const std::string here = where + ", joint '" + joint.name + "'";
    if (!names.insert(joint.name).second) throw InvalidInput(here, "the name is given twice");
    validate_joint(joint, here);
  }
  validate_links(parts_, where);
  require_rigid(parts_.tcp, where + ", tool");
}

const Link* Robot::find_link(const std::string& name) const {
  const auto found = std::find_if(parts_.links.begin(), parts_.links.end(),
                                  [&](const Link& link) { return link.name == name; });
  return found == parts_.links.end() ? nullptr : &*found;
}

std::vector<std::string> Robot::joint_names() const {
  std::vector<std::string> names;
  for (const Joint& joint : joints()) names.push_back(joint.name);
  return names;
}

JointVector Robot::lower_limits() const { return gather(parts_.joints, &Joint::lower); }
JointVector Robot::upper_limits() const { return gather(parts_.joints, &Joint::upper); }
JointVector Robot::velocity_limits() const { return gather(parts_.joints, &Joint::max_velocity); }
JointVector Robot::acceleration_limits() const {
  return gather(parts_.joints, &Joint::max_acceleration);
}
JointVector Robot::jerk_limits() const { return gather(parts_.joints, &Joint::max_jerk); }

}  // namespace wristwise
