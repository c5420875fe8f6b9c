#include "collision/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>

#include "collision/collada_check.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr std::uintmax_t kMostBytes = 1ULL << 31;

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::uintmax_t require_file(const std::filesystem::path& file) {
  const std::string where = file.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InvalidInput(where, "no such file", "a mesh file");
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size == 0) throw InvalidInput(where, "the file is empty", "a mesh file");
  if (size > kMostBytes) throw InvalidInput(where, "more than 2 GB", "a coarser mesh");
  return size;
}

/// A binary STL says how many triangles of 50 bytes follow its 84 bytes.
void refuse_cut_stl(const std::filesystem::path& file, std::uintmax_t size) {
  std::array<char, 84> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), head.size());
  const auto read = static_cast<std::size_t>(stream.gcount());
  const bool text = std::string(head.data(), std::min<std::size_t>(read, 5)) == "solid";
  const bool cut_head = read < head.size();
  std::uint32_t count = 0;
  std::memcpy(&count, head.data() + 80, sizeof count);
  const std::uintmax_t expected = 84 + 50 * static_cast<std::uintmax_t>(count);
  if (text || (!cut_head && size == expected)) return;
  throw InvalidInput(file.string(),
                     cut_head ? std::string("cut off in the header of a binary STL")
                              : "a binary STL of " + std::to_string(count) + " triangles has " +
                                    std::to_string(size) + " bytes",
                     cut_head ? std::string("a whole file") : std::to_string(expected) + " bytes");
}

void append(const aiMesh& mesh, const std::string& where, TriangleMesh& read) {
  const int offset = static_cast<int>(read.vertices.size());
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    const Eigen::Vector3d vertex(p.x, p.y, p.z);
    if (!vertex.allFinite()) {
      throw InvalidInput(where, "a vertex is not finite", "coordinates that are numbers");
    }
    read.vertices.push_back(vertex);
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;  // points and lines
    std::array<int, 3> triangle{};
    for (unsigned c = 0; c < 3; ++c) {
      if (face.mIndices[c] >= mesh.mNumVertices) {
        throw InvalidInput(where, "a triangle has a corner that is no vertex", "a sound mesh");
      }
      triangle[c] = offset + static_cast<int>(face.mIndices[c]);
    }
    read.triangles.push_back(triangle);
  }
}

}  // namespace

TriangleMesh read_mesh_file(const std::filesystem::path& file, bool turn_up_axis) {
  const std::string where = file.string();
  const std::string extension = lower_extension(file);
  const std::uintmax_t size = require_file(file);
  if (extension == ".stl") refuse_cut_stl(file, size);
  if (extension == ".dae") check_collada(file);

  const bool turn = extension == ".dae" && turn_up_axis;
  Assimp::Importer importer;
  // Left alone, assimp turns the up axis to y; ROS goes by the numbers.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, !turn);
  const aiScene* scene = importer.ReadFile(
      where, static_cast<unsigned>(aiProcess_Triangulate | aiProcess_PreTransformVertices));
  if (!scene) {
    throw InvalidInput(where, std::string("cannot be read: ") + importer.GetErrorString(),
                       "a mesh, for example STL, OBJ or DAE");
  }
  TriangleMesh read;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(*scene->mMeshes[m], where, read);
  if (read.triangles.empty()) throw InvalidInput(where, "no triangles", "a mesh with a surface");
  if (turn) {
    for (Eigen::Vector3d& v : read.vertices) v = Eigen::Vector3d(v.x(), -v.z(), v.y());
  }
  return read;
}

}  // namespace wristwise
