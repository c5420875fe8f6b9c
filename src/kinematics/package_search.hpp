#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wristwise {

/// Where a ROS package may lie, the likeliest first: a folder of `searched`, then of
/// ROS_PACKAGE_PATH, that contains or is the package's folder; `share/` in those of
/// AMENT_PREFIX_PATH; then a folder up to three levels further down with the package's package.xml.
std::vector<std::filesystem::path> package_candidates(
    const std::string& package, const std::vector<std::filesystem::path>& searched);

}  // namespace wristwise
