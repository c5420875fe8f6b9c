#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wristwise/geometry.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

struct SceneObject {
  std::string name;
  std::vector<Shape> shapes;  ///< poses in the frame of `link`
  std::string link = {};      ///< of the robot, to which it is fixed; empty: the base link
  /// Of a mesh cut into convex pieces: m, no point of a shape is farther from the object.
  std::optional<double> convex_error = {};
};

enum class CollisionScope {
  all,    ///< robot against objects and against itself
  off,    ///< no distance is measured
  pairs,  ///< only the pairs listed
};

/// What the robot must keep clear of. An immutable value.
struct Scene {
  using Names = std::pair<std::string, std::string>;

  std::vector<SceneObject> objects;
  CollisionScope scope = CollisionScope::all;
  std::vector<Names> pairs;     ///< of links or objects; used with CollisionScope::pairs
  std::vector<Names> disabled;  ///< never measured (SRDF's disable_collisions)
  /// Find the pairs that are in contact at every sampled posture, and leave them out by name.
  bool find_permanent_contacts = true;
  double clearance = 0;               ///< m, the least signed distance that is accepted
  std::vector<std::string> warnings;  ///< what the reader of the scene should know
};

}  // namespace wristwise
