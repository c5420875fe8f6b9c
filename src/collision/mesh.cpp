#include "wristwise/mesh.hpp"

#include <cmath>

#include "collision/mesh_body.hpp"
#include "collision/mesh_cache.hpp"
#include "collision/mesh_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void require_sense(const Eigen::Vector3d& scale, const MeshOptions& options,
                   const std::string& where) {
  if (!scale.allFinite() || (scale.array() == 0).any()) {
    throw InvalidInput(where, "a scale is zero or not finite", "a number for each axis");
  }
  const double error = options.convex_error.value_or(1);
  if (!std::isfinite(error) || error <= 0) {
    throw InvalidInput(where, "convex_error is " + std::to_string(error), "a length above zero");
  }
}

}  // namespace

MeshBody load_mesh(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                   const MeshOptions& options) {
  const std::string where = file.string();
  require_sense(scale, options, where);
  const MeshCache cache(file, scale, options);
  if (auto known = cache.find()) return std::move(*known);
  TriangleMesh mesh = read_mesh_file(file, options.turn_up_axis);
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = vertex.cwiseProduct(scale);
    if (!vertex.allFinite()) throw InvalidInput(where, "a vertex is not finite", "a lesser scale");
  }
  MeshBody body = mesh_body(mesh, options, where);
  cache.keep(body);
  return body;
}

}  // namespace wristwise
