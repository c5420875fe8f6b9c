#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wristwise/geometry.hpp"

namespace wristwise {

/// Reads a mesh (STL, OBJ, DAE, ... whatever assimp reads) and returns the convex hull of each of
/// its connected components, scaled (m per unit of the file, per axis). The hulls contain the mesh,
/// so a colliding posture never looks clear; concave components are filled.
/// @throws InvalidInput naming the file where it is missing, unreadable, empty, flat or not finite.
std::vector<ConvexHull> load_mesh(const std::filesystem::path& file, const Eigen::Vector3d& scale);

/// The convex hull of points (m). @throws InvalidInput where they have no volume.
ConvexHull convex_hull(const std::vector<Eigen::Vector3d>& points, const std::string& where);

}  // namespace wristwise
