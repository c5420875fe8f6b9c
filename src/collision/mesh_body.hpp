#pragma once

#include <string>

#include "collision/triangle_mesh.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {

/// The convex pieces of a mesh (m).
/// @param where the file, for warnings
MeshBody mesh_body(const TriangleMesh& mesh, const MeshOptions& options, const std::string& where);

}  // namespace wristwise
