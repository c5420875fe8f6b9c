#include "kinematics/urdf_collision.hpp"

#include <urdf_model/link.h>

#include <algorithm>
#include <cmath>

#include "kinematics/package_search.hpp"
#include "wristwise/error.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {
namespace {

std::vector<std::filesystem::path> files_in_package(const std::string& path,
                                                    const MeshFolders& folders) {
  const std::size_t slash = std::min(path.find('/'), path.size());
  const std::string rest = slash < path.size() ? path.substr(slash + 1) : std::string();
  std::vector<std::filesystem::path> files;
  for (const auto& folder : package_candidates(path.substr(0, slash), folders.packages)) {
    files.push_back(folder / rest);
  }
  return files;
}

std::vector<std::filesystem::path> mesh_candidates(const std::string& uri,
                                                   const MeshFolders& folders,
                                                   const std::string& where) {
  const std::size_t scheme_end = uri.find("://");
  if (scheme_end == std::string::npos) return {folders.urdf_folder / uri};
  const std::string scheme = uri.substr(0, scheme_end);
  const std::string path = uri.substr(scheme_end + 3);
  if (scheme == "file") return {folders.urdf_folder / path};
  if (scheme == "package") return files_in_package(path, folders);
  throw InvalidInput(where, "mesh '" + uri + "' has an unknown scheme",
                     "package://, file:// or a path relative to the URDF");
}

void require_positive(double value, const std::string& where, const std::string& what) {
  if (std::isfinite(value) && value > 0) return;
  throw InvalidInput(where, what + " is " + std::to_string(value), "a positive length in m");
}

Eigen::Vector3d vector_from_urdf(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Vector3d checked_size(const urdf::Vector3& size, const std::string& where,
                             const std::string& what) {
  Eigen::Vector3d v = vector_from_urdf(size);
  for (const double length : v) require_positive(length, where, what);
  return v;
}

/// Reads the geometries of one link.
class LinkGeometries {
 public:
  LinkGeometries(const MeshFolders& folders, const MeshOptions& meshes, std::string where,
                 std::vector<std::string>& warnings)
      : folders_(folders), meshes_(meshes), where_(std::move(where)), warnings_(warnings) {}

  std::vector<Geometry> read(const urdf::Geometry& geometry) const {
    switch (geometry.type) {
      case urdf::Geometry::BOX: {
        const auto& box = dynamic_cast<const urdf::Box&>(geometry);
        return {Box{checked_size(box.dim, where_, "box size")}};
      }
      case urdf::Geometry::SPHERE: {
        const auto& sphere = dynamic_cast<const urdf::Sphere&>(geometry);
        require_positive(sphere.radius, where_, "sphere radius");
        return {Sphere{sphere.radius}};
      }
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
        require_positive(cylinder.radius, where_, "cylinder radius");
        require_positive(cylinder.length, where_, "cylinder length");
        return {Cylinder{cylinder.radius, cylinder.length}};
      }
      case urdf::Geometry::MESH:
        return read_mesh(dynamic_cast<const urdf::Mesh&>(geometry));
    }
    throw InvalidInput(where_, "unknown collision geometry", "box, cylinder, sphere or mesh");
  }

 private:
  std::vector<Geometry> read_mesh(const urdf::Mesh& mesh) const {
    const Eigen::Vector3d scale = vector_from_urdf(mesh.scale);
    if (!scale.allFinite() || (scale.array() == 0).any()) {
      throw InvalidInput(where_, "mesh scale is zero or not finite", "three factors");
    }
    MeshBody body = load_mesh(resolve_mesh(mesh.filename, folders_, where_), scale, meshes_);
    for (std::string& warning : body.warnings) warnings_.push_back(std::move(warning));
    std::vector<Geometry> geometries;
    for (ConvexHull& piece : body.pieces) geometries.emplace_back(std::move(piece));
    return geometries;
  }

  const MeshFolders& folders_;
  const MeshOptions& meshes_;
  std::string where_;
  std::vector<std::string>& warnings_;
};

}  // namespace

std::filesystem::path resolve_mesh(const std::string& uri, const MeshFolders& folders,
                                   const std::string& where) {
  std::string searched;
  for (const std::filesystem::path& candidate : mesh_candidates(uri, folders, where)) {
    std::error_code error;
    if (std::filesystem::is_regular_file(candidate, error)) return candidate;
    searched += (searched.empty() ? "" : ", ") + candidate.string();
  }
  throw InvalidInput(where, "mesh '" + uri + "' is not found",
                     searched.empty() ? "its package among the packages or in ROS_PACKAGE_PATH"
                                      : "one of " + searched);
}

Pose pose_from_urdf(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  Pose result = Pose::Identity();
  result.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  result.translation() = vector_from_urdf(pose.position);
  return result;
}

std::vector<Shape> collision_shapes(const urdf::Link& link, const MeshFolders& folders,
                                    const MeshOptions& meshes, const std::string& where,
                                    std::vector<std::string>& warnings) {
  const std::string here = where + ": link '" + link.name + "'";
  const LinkGeometries geometries(folders, meshes, here, warnings);
  std::vector<Shape> shapes;
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    if (!collision || !collision->geometry) throw InvalidInput(here, "a collision has no geometry");
    const Pose pose = pose_from_urdf(collision->origin);
    for (Geometry& geometry : geometries.read(*collision->geometry)) {
      shapes.push_back({std::move(geometry), pose});
    }
  }
  return shapes;
}

}  // namespace wristwise
