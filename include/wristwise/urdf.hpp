#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "wristwise/mesh.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Which files describe a robot, and which of its links are the ends of the chain.
struct RobotSource {
  std::filesystem::path urdf;    ///< the description, xacro already expanded
  std::string base_link;         ///< stands still; empty: the root of the tree
  std::string tip_link;          ///< empty: the leaf with the longest chain of movable joints
  Pose tool = Pose::Identity();  ///< TCP in tip_link
  std::filesystem::path limits;  ///< MoveIt's joint_limits.yaml; empty: what the URDF says
  std::filesystem::path srdf;    ///< for `group` and warnings; empty: none
  std::string group;             ///< of the SRDF: gives base_link and tip_link
  std::vector<std::filesystem::path> packages;  ///< folders searched for package://, before
                                                ///< ROS_PACKAGE_PATH
  bool require_velocity_limits = true;          ///< false for a first look at a description
  bool read_collision_shapes = true;            ///< false: links have none, meshes may be missing
  std::string part_link;  ///< carries the part: the chain runs from it to the tip; empty: base_link
  bool visual_as_collision = false;  ///< links without collision shapes take their visual ones
  MeshOptions meshes;                ///< how the links' meshes are read
  /// The description itself, if not empty. `urdf` is then not read: it is the text's name in
  /// messages (empty: "urdf_text"), and mesh files are relative to its folder.
  std::string urdf_text = {};
};

/// Reads a serial chain from a URDF, see Robot. Joints above the base link and off the chain are
/// held at zero, their links carried along. A joint that is passed from child to parent keeps its
/// name, value and limits; its axis is turned round (F62).
/// @throws InvalidInput: missing or malformed file, no tree, no such link, group or chain, a joint
/// that moves both part and tip, a joint without limits, a joint type other than revolute,
/// continuous, prismatic or fixed on the chain, a mesh that cannot be read.
Robot load_robot(const RobotSource& source);

/// Two links of the robot, in the order of the SRDF.
using LinkNames = std::pair<std::string, std::string>;

/// The pairs of the robot's links that an SRDF says need no check: disable_collisions,
/// disable_default_collisions less enable_collisions.
/// @throws InvalidInput where the file is missing or no SRDF
std::vector<LinkNames> load_disabled_collisions(const std::filesystem::path& srdf,
                                                const Robot& robot);

}  // namespace wristwise
