#include "wristwise/mesh.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <exception>

#include "collision/mesh_pieces.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

void append(const aiMesh& mesh, const Eigen::Vector3d& scale, const std::string& where,
            TriangleSoup& soup) {
  const int offset = static_cast<int>(soup.vertices.size());
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    const Eigen::Vector3d vertex = scale.cwiseProduct(Eigen::Vector3d(p.x, p.y, p.z));
    if (!vertex.allFinite()) {
      throw InvalidInput(where, "a vertex is not finite", "coordinates that are numbers");
    }
    soup.vertices.push_back(vertex);
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;  // points and lines
    std::array<int, 3> triangle{};
    for (unsigned c = 0; c < 3; ++c) triangle[c] = offset + static_cast<int>(face.mIndices[c]);
    soup.triangles.push_back(triangle);
  }
}

TriangleSoup read_triangles(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                            const std::string& where) {
  Assimp::Importer importer;
  // As ROS reads COLLADA: a robot description states the orientation itself.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(
      file.string(), static_cast<unsigned>(aiProcess_Triangulate | aiProcess_PreTransformVertices));
  if (!scene) {
    throw InvalidInput(where, std::string("cannot be read: ") + importer.GetErrorString(),
                       "a mesh, for example STL, OBJ or DAE");
  }
  TriangleSoup soup;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(*scene->mMeshes[m], scale, where, soup);
  if (soup.triangles.empty()) throw InvalidInput(where, "no triangles", "a mesh with a volume");
  return soup;
}

std::vector<ConvexHull> hull_of_each(const std::vector<std::vector<Eigen::Vector3d>>& pieces,
                                     const std::string& where) {
  std::vector<ConvexHull> hulls;
  hulls.reserve(pieces.size());
  for (const auto& piece : pieces) hulls.push_back(convex_hull(piece, where));
  return hulls;
}

}  // namespace

MeshBody load_mesh(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                   const MeshOptions&) {
  const std::string where = file.string();
  if (!scale.allFinite() || (scale.array() == 0).any()) {
    throw InvalidInput(where, "a scale is zero or not finite", "a number for each axis");
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InvalidInput(where, "no such file", "a mesh file");
  }
  const TriangleSoup soup = read_triangles(file, scale, where);
  try {
    return {hull_of_each(connected_pieces(soup), where), 0, {}};
  } catch (const InvalidInput&) {
    // Loose triangles have no hull of their own, and must not be lost: one hull round everything.
    return {{convex_hull(soup.vertices, where)}, 0, {}};
  }
}

}  // namespace wristwise
