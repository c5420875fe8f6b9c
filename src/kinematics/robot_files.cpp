#include "kinematics/robot_files.hpp"

#include <urdf_model/link.h>
#include <urdf_model/model.h>

#include "kinematics/urdf_collision.hpp"
#include "kinematics/urdf_document.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

std::vector<std::filesystem::path> mesh_files(const RobotSource& source) {
  const UrdfDocument document = read_urdf(source);
  const MeshFolders folders{source.urdf.parent_path(), source.packages};
  std::vector<std::filesystem::path> files;
  for (const auto& [name, link] : document.model->links_)
    for (const urdf::CollisionSharedPtr& collision : link->collision_array) {
      if (!collision || !collision->geometry) continue;
      if (collision->geometry->type != urdf::Geometry::MESH) continue;
      const auto& mesh = static_cast<const urdf::Mesh&>(*collision->geometry);
      try {
        files.push_back(resolve_mesh(mesh.filename, folders, urdf_name(source)));
      } catch (const InvalidInput&) {
        continue;  // of a link outside the robot, or load_robot would have said so
      }
    }
  return files;
}

}  // namespace

std::vector<std::filesystem::path> robot_files(const RobotSource& source) {
  std::vector<std::filesystem::path> files;
  if (source.urdf_text.empty()) files.push_back(source.urdf);
  for (const std::filesystem::path& file : {source.limits, source.srdf})
    if (!file.empty()) files.push_back(file);
  if (!source.read_collision_shapes) return files;
  const std::vector<std::filesystem::path> meshes = mesh_files(source);
  files.insert(files.end(), meshes.begin(), meshes.end());
  return files;
}

}  // namespace wristwise
