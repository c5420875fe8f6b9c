#pragma once

#include <urdf_model/types.h>
#include <urdf_world/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

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

/// Reads a URDF with urdfdom. Joints may lack limits: `declared` tells.
/// @param visual_as_collision links without a collision element take their visual ones
/// @throws InvalidInput with the parser's own words.
UrdfDocument read_urdf(const std::filesystem::path& file, bool visual_as_collision = false);

}  // namespace wristwise
