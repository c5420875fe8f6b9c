#pragma once

#include <urdf_model/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "wristwise/geometry.hpp"
#include "wristwise/mesh.hpp"

namespace urdf {
class Pose;
}

namespace wristwise {

/// Where a mesh that a URDF names may lie.
struct MeshFolders {
  std::filesystem::path urdf_folder;
  std::vector<std::filesystem::path> packages;  ///< before ROS_PACKAGE_PATH
};

/// @throws InvalidInput where the URI has another scheme, or no file is found.
std::filesystem::path resolve_mesh(const std::string& uri, const MeshFolders& folders,
                                   const std::string& where);

Pose pose_from_urdf(const urdf::Pose& pose);

/// The collision shapes of a link, in the link frame.
/// @param warnings what is to be said of its meshes is added
std::vector<Shape> collision_shapes(const urdf::Link& link, const MeshFolders& folders,
                                    const MeshOptions& meshes, const std::string& where,
                                    std::vector<std::string>& warnings);

}  // namespace wristwise
