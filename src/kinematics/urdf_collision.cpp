#include "kinematics/urdf_collision.hpp"

#include <urdf_model/link.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "wristwise/error.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {
namespace {

std::vector<std::filesystem::path> ros_package_path() {
  std::vector<std::filesystem::path> folders;
  const char* variable = std::getenv("ROS_PACKAGE_PATH");
  if (variable == nullptr) return folders;
  const std::string text = variable;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(':', start), text.size());
    if (end > start) folders.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return folders;
}

/// A folder may contain the package's folder, or be it.
std::vector<std::filesystem::path> package_candidates(const std::string& path,
                                                      const MeshFolders& folders) {
  const std::size_t slash = std::min(path.find('/'), path.size());
  const std::string package = path.substr(0, slash);
  const std::string rest = slash < path.size() ? path.substr(slash + 1) : std::string();
  std::vector<std::filesystem::path> candidates;
  std::vector<std::filesystem::path> searched = folders.packages;
  for (const auto& folder : ros_package_path()) searched.push_back(folder);
  for (const std::filesystem::path& folder : searched) {
    candidates.push_back(folder / package / rest);
    const auto normal = (folder / "").lexically_normal().parent_path();
    if (normal.filename() == package) candidates.push_back(normal / rest);
  }
  return candidates;
}

std::vector<std::filesystem::path> mesh_candidates(const std::string& uri,
                                                   const MeshFolders& folders,
                                                   const std::string& where) {
  const std::size_t scheme_end = uri.find("://");
  if (scheme_end == std::string::npos) return {folders.urdf_folder / uri};
  const std::string scheme = uri.substr(0, scheme_end);
  const std::string path = uri.substr(scheme_end + 3);
  if (scheme == "file") return {folders.urdf_folder / path};
  if (scheme == "package") return package_candidates(path, folders);
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

std::vector<Geometry> mesh_geometries(const urdf::Mesh& mesh, const MeshFolders& folders,
                                      const std::string& where) {
  const Eigen::Vector3d scale = vector_from_urdf(mesh.scale);
  if (!scale.allFinite() || (scale.array() == 0).any()) {
    throw InvalidInput(where, "mesh scale is zero or not finite", "three factors");
  }
  std::vector<Geometry> geometries;
  for (ConvexHull& hull : load_mesh(resolve_mesh(mesh.filename, folders, where), scale)) {
    geometries.emplace_back(std::move(hull));
  }
  return geometries;
}

std::vector<Geometry> geometries_from_urdf(const urdf::Geometry& geometry,
                                           const MeshFolders& folders, const std::string& where) {
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const auto& box = dynamic_cast<const urdf::Box&>(geometry);
      return {Box{checked_size(box.dim, where, "box size")}};
    }
    case urdf::Geometry::SPHERE: {
      const auto& sphere = dynamic_cast<const urdf::Sphere&>(geometry);
      require_positive(sphere.radius, where, "sphere radius");
      return {Sphere{sphere.radius}};
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
      require_positive(cylinder.radius, where, "cylinder radius");
      require_positive(cylinder.length, where, "cylinder length");
      return {Cylinder{cylinder.radius, cylinder.length}};
    }
    case urdf::Geometry::MESH:
      return mesh_geometries(dynamic_cast<const urdf::Mesh&>(geometry), folders, where);
  }
  throw InvalidInput(where, "unknown collision geometry", "box, cylinder, sphere or mesh");
}

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
                                    const std::string& where) {
  std::vector<Shape> shapes;
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    const std::string here = where + ": link '" + link.name + "'";
    if (!collision || !collision->geometry) throw InvalidInput(here, "a collision has no geometry");
    const Pose pose = pose_from_urdf(collision->origin);
    for (Geometry& geometry : geometries_from_urdf(*collision->geometry, folders, here)) {
      shapes.push_back({std::move(geometry), pose});
    }
  }
  return shapes;
}

}  // namespace wristwise
