#include "kinematics/urdf_joint.hpp"

#include <urdf_model/joint.h>
#include <urdf_model/model.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "kinematics/urdf_collision.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

JointType type_from_urdf(const urdf::Joint& joint, const std::string& where) {
  if (joint.mimic) {
    throw InvalidInput(where, "mimics joint '" + joint.mimic->joint_name + "'",
                       "a joint of its own on the chain");
  }
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return JointType::revolute;
    case urdf::Joint::CONTINUOUS:
      return JointType::continuous;
    case urdf::Joint::PRISMATIC:
      return JointType::prismatic;
    default:
      throw InvalidInput(where, "is " + type_name(joint),
                         "revolute, continuous, prismatic or fixed on the chain");
  }
}

Eigen::Vector3d axis_from_urdf(const urdf::Joint& joint, const std::string& where) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  const double length = axis.norm();
  if (!std::isfinite(length) || length < 1e-9) {
    throw InvalidInput(where, "the axis has no direction", "a vector that is not zero");
  }
  return axis / length;
}

void set_position_limits(Joint& joint, const urdf::Joint& source, bool declared,
                         const JointLimits& file, const std::string& where,
                         std::vector<std::string>& warnings) {
  const bool continuous = joint.type == JointType::continuous;
  const bool in_urdf = declared && !continuous;
  if (file.position) {
    std::tie(joint.lower, joint.upper) = *file.position;
    if (continuous) joint.type = JointType::revolute;
    if (in_urdf && (joint.lower < source.limits->lower || joint.upper > source.limits->upper)) {
      warnings.push_back("joint '" + joint.name +
                         "': the limits file allows more than the URDF's position limits");
    }
  } else if (continuous) {
    joint.lower = -kInfinity;
    joint.upper = kInfinity;
  } else if (in_urdf) {
    joint.lower = source.limits->lower;
    joint.upper = source.limits->upper;
  } else {
    throw InvalidInput(where, "has no position limits",
                       "<limit lower= upper=> or has_position_limits in the limits file");
  }
  if (joint.lower > joint.upper) {
    throw InvalidInput(where, "its lower position limit exceeds its upper one", "lower <= upper");
  }
}

void set_velocity_limit(Joint& joint, const urdf::Joint& source, bool declared,
                        const JointLimits& file, bool required, const std::string& where) {
  const double in_urdf = declared ? source.limits->velocity : 0.0;
  if (!std::isfinite(in_urdf) || in_urdf < 0) {
    throw InvalidInput(where, "velocity limit is " + std::to_string(in_urdf), "a positive number");
  }
  joint.max_velocity = file.velocity.value_or(in_urdf > 0 ? in_urdf : kInfinity);
  if (required && std::isinf(joint.max_velocity)) {
    throw InvalidInput(where, "has no velocity limit",
                       "<limit velocity=> or max_velocity in the limits file");
  }
}

double nearest_to_zero(const urdf::Joint& joint) {
  const bool bounded = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::PRISMATIC;
  if (!bounded || !joint.limits || !(joint.limits->lower <= joint.limits->upper)) return 0;
  return std::clamp(0.0, joint.limits->lower, joint.limits->upper);
}

}  // namespace

bool is_movable(const urdf::Joint& joint) { return joint.type != urdf::Joint::FIXED; }

std::string type_name(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
      return "revolute";
    case urdf::Joint::CONTINUOUS:
      return "continuous";
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    case urdf::Joint::FIXED:
      return "fixed";
    default:
      return "of unknown type";
  }
}

Joint joint_from_urdf(const urdf::Joint& source, const DeclaredLimits& declared,
                      const JointLimits& file, bool require_velocity, const std::string& where,
                      std::vector<std::string>& warnings) {
  const std::string here = where + ": joint '" + source.name + "'";
  Joint joint;
  joint.name = source.name;
  joint.type = type_from_urdf(source, here);
  joint.origin = pose_from_urdf(source.parent_to_joint_origin_transform);
  joint.axis = axis_from_urdf(source, here);
  set_position_limits(joint, source, declared.position, file, here, warnings);
  set_velocity_limit(joint, source, declared.velocity, file, require_velocity, here);
  joint.max_acceleration = file.acceleration.value_or(kInfinity);
  joint.max_jerk = file.jerk.value_or(kInfinity);
  return joint;
}

double frozen_position(const urdf::Joint& joint, const urdf::ModelInterface& model) {
  double factor = 1, sum = 0;
  const urdf::Joint* at = &joint;
  for (std::size_t passed = 0; at->mimic; ++passed) {
    const std::string here = "joint '" + joint.name + "'";
    sum += factor * at->mimic->offset;
    factor *= at->mimic->multiplier;
    const urdf::JointConstSharedPtr followed = model.getJoint(at->mimic->joint_name);
    if (!followed) {
      throw InvalidInput(here, "mimics '" + at->mimic->joint_name + "', which is no joint",
                         "a joint of the URDF");
    }
    if (passed > model.joints_.size()) {
      throw InvalidInput(here, "mimics itself, by way of others", "a joint that moves by itself");
    }
    at = followed.get();
  }
  return sum + factor * nearest_to_zero(*at);
}

Pose motion_at(const urdf::Joint& joint, double position) {
  Pose motion = Pose::Identity();
  if (position == 0) return motion;
  const Eigen::Vector3d axis = axis_from_urdf(joint, "joint '" + joint.name + "'");
  if (joint.type == urdf::Joint::PRISMATIC) {
    motion.translation() = position * axis;
  } else {
    motion.linear() = Eigen::AngleAxisd(position, axis).toRotationMatrix();
  }
  return motion;
}

}  // namespace wristwise
