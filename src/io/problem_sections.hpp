#pragma once

#include <memory>

#include "io/config_reader.hpp"
#include "io/path_section.hpp"
#include "wristwise/export_options.hpp"
#include "wristwise/inverse_kinematics.hpp"
#include "wristwise/mesh.hpp"
#include "wristwise/options.hpp"
#include "wristwise/placement.hpp"
#include "wristwise/robot.hpp"
#include "wristwise/scene.hpp"

// The sections of a problem file (docs/problem-file.md). Each throws InvalidInput with file, line
// and key.
namespace wristwise {

/// Folders that are searched for package://, before ROS_PACKAGE_PATH.
using Packages = std::vector<std::filesystem::path>;

/// A file that exists, relative to the problem file or package://.
std::filesystem::path find_file(const ConfigReader& reader, const Packages& packages);

/// Keys xyz and rpy, each optional unless `xyz_required`.
Pose read_pose(const ConfigReader& reader, bool xyz_required = false);
Eigen::Vector3d read_rpy(const ConfigReader& reader);

struct RobotSection {
  std::shared_ptr<const Robot> robot;
  std::shared_ptr<const InverseKinematics> inverse_kinematics;  ///< null: not given
  Packages packages;
  std::optional<std::vector<Scene::Names>> disabled;  ///< given where there is an SRDF
};
/// @param part_link carries the part; empty: the base link
/// @param mesh_cache folder; empty: none
RobotSection read_robot(const ConfigReader& reader, const std::string& part_link,
                        const std::filesystem::path& mesh_cache);

/// How far the pieces of a concave mesh may reach beyond it; nullopt for `off`.
std::optional<double> read_convex_error(const ConfigReader& reader);

/// Of the values of a joint, by its index.
Quantity joint_quantity(const Robot& robot, std::size_t joint);

/// @param reader empty where the file has no scene
Scene read_scene(const std::optional<ConfigReader>& reader, const Robot& robot,
                 const Packages& packages, const std::filesystem::path& mesh_cache);

CostOptions read_cost(const ConfigReader& reader, const Robot& robot);
GraphOptions read_graph(const ConfigReader& reader, const Robot& robot);
RefineOptions read_refine(const ConfigReader& reader);
PlacementOptions read_placement(const ConfigReader& reader, const Scene& scene);

/// All sections but `placement`; that has been looked at too where it is given.
struct ProblemSections {
  Problem problem;
  PathSection path;
  std::optional<PlacementOptions> placement;
};
ProblemSections read_problem(const std::filesystem::path& file, const LoadOptions& options);

ExportOptions read_export(const ConfigReader& reader, const Robot& robot);

}  // namespace wristwise
