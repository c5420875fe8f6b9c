#pragma once

#include <urdf_model/types.h>

#include <string>
#include <vector>

#include "kinematics/joint_limits.hpp"
#include "kinematics/urdf_document.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

bool is_movable(const urdf::Joint& joint);

/// For messages: "revolute", "floating", ...
std::string type_name(const urdf::Joint& joint);

/// A movable joint of the chain, its origin still in the parent link. Limits of the file come
/// before those of the URDF.
/// @throws InvalidInput for another type, a mimic joint, or limits that are missing or senseless.
Joint joint_from_urdf(const urdf::Joint& joint, const DeclaredLimits& declared,
                      const JointLimits& file, bool require_velocity, const std::string& where,
                      std::vector<std::string>& warnings);

/// What a frozen joint does to its child: its motion at zero, or at the limit nearest to zero.
double frozen_position(const urdf::Joint& joint);
Pose frozen_motion(const urdf::Joint& joint);

}  // namespace wristwise
