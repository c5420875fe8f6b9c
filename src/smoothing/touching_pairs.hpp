#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wristwise/clearance.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// The pairs of links that touch at a point of the path: there is nothing to keep clear then. Adds
/// a warning for each.
std::vector<Scene::Names> touching_pairs(const std::shared_ptr<const Robot>& robot,
                                         const JointPath& path, std::vector<std::string>& warnings);

}  // namespace wristwise
