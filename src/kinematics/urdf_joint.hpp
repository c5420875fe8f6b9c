#pragma once

#include <urdf_model/types.h>
#include <urdf_world/types.h>

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

/// Where a joint that does not move is held: at zero, or at the limit nearest to zero; a mimic
/// joint where that puts it. @throws InvalidInput where it mimics no joint, or itself.
double frozen_position(const urdf::Joint& joint, const urdf::ModelInterface& model);

/// What the joint does to its child at a position (rad or m).
Pose motion_at(const urdf::Joint& joint, double position);

}  // namespace wristwise
