#include "io/problem_sections.hpp"

namespace wristwise {

Eigen::Vector3d read_rpy(const ConfigReader& reader) { return reader.vector(Quantity::angle); }

Pose read_pose(const ConfigReader& reader, bool xyz_required) {
  reader.expect_keys({"xyz", "rpy"});
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  if (xyz_required || reader.find("xyz")) xyz = reader.at("xyz").vector(Quantity::length);
  if (const auto given = reader.find("rpy")) rpy = read_rpy(*given);
  return pose_from_xyz_rpy(xyz, rpy);
}

}  // namespace wristwise
