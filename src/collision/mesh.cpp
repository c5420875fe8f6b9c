#include "wristwise/mesh.hpp"

#include "collision/mesh_file.hpp"
#include "collision/mesh_pieces.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

std::vector<ConvexHull> hull_of_each(const std::vector<std::vector<Eigen::Vector3d>>& pieces,
                                     const std::string& where) {
  std::vector<ConvexHull> hulls;
  hulls.reserve(pieces.size());
  for (const auto& piece : pieces) hulls.push_back(convex_hull(piece, where));
  return hulls;
}

}  // namespace

MeshBody load_mesh(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                   const MeshOptions& options) {
  const std::string where = file.string();
  if (!scale.allFinite() || (scale.array() == 0).any()) {
    throw InvalidInput(where, "a scale is zero or not finite", "a number for each axis");
  }
  TriangleSoup soup = read_mesh_file(file, options.turn_up_axis);
  for (Eigen::Vector3d& vertex : soup.vertices) vertex = vertex.cwiseProduct(scale);
  try {
    return {hull_of_each(connected_pieces(soup), where), 0, {}};
  } catch (const InvalidInput&) {
    // Loose triangles have no hull of their own, and must not be lost: one hull round everything.
    return {{convex_hull(soup.vertices, where)}, 0, {}};
  }
}

}  // namespace wristwise
