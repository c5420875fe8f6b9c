#pragma once

#include <urdf_world/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/srdf.hpp"

namespace wristwise {

/// The first and the last link of the chain that a group of an SRDF stands for.
/// @throws InvalidInput for an unknown group, unknown members, or a group that is no chain.
std::pair<std::string, std::string> chain_of_group(const Srdf& srdf, const std::string& group,
                                                   const urdf::ModelInterface& model,
                                                   const std::filesystem::path& file);

/// A line for each name that is nowhere in the URDF, with the nearest that is.
std::vector<std::string> srdf_warnings(const Srdf& srdf, const urdf::ModelInterface& model,
                                       const std::filesystem::path& file);

}  // namespace wristwise
