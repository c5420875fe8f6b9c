#pragma once

#include <urdf_model/types.h>
#include <urdf_world/types.h>

#include <map>
#include <string>
#include <vector>

#include "wristwise/urdf.hpp"

namespace wristwise {

/// Which limits of a joint the file itself gives; urdfdom replaces missing ones by zeros.
struct DeclaredLimits {
  bool position = false;
  bool velocity = false;
};

struct UrdfDocument {
  urdf::ModelInterfaceSharedPtr model;
  std::map<std::string, DeclaredLimits> declared;  ///< by joint name
  std::vector<std::string> only_visual;  ///< links with visual but without collision elements
  std::vector<std::string> warnings;     ///< of the parser
};

/// What the description is called in messages.
std::string urdf_name(const RobotSource& source);

/// Reads a URDF, from its file or its text, with urdfdom. Joints may lack limits: `declared` tells.
/// @throws InvalidInput with the parser's own words.
UrdfDocument read_urdf(const RobotSource& source);

}  // namespace wristwise
