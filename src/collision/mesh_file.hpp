#pragma once

#include <filesystem>

#include "collision/triangle_mesh.hpp"

namespace wristwise {

/// The triangles of a mesh file in its own unit; of COLLADA in m.
/// @param turn_up_axis COLLADA: turn the file's up axis to z
/// @throws InvalidInput naming the file where it is missing, unreadable, has no triangle or a
/// vertex that is not finite.
TriangleMesh read_mesh_file(const std::filesystem::path& file, bool turn_up_axis);

}  // namespace wristwise
