#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wristwise/geometry.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Something that the robot must keep clear of: a part, a clamp, a table.
struct SceneObject {
  std::string name;           ///< unlike that of every other object and link
  std::vector<Shape> shapes;  ///< poses in the frame of `link`
  std::string link = {};      ///< of the robot, to which it is fixed; empty: the base link
  /// Of a mesh cut into convex pieces: m, no point of a shape is farther from the object.
  std::optional<double> convex_error = {};
};

/// Which pairs of bodies count.
enum class CollisionScope {
  all,    ///< robot against objects and against itself
  off,    ///< no distance is measured
  pairs,  ///< only the pairs listed
};

/// What the robot must keep clear of. An immutable value.
struct Scene {
  /// Two links, or a link and an object, in any order.
  using Names = std::pair<std::string, std::string>;

  std::vector<SceneObject> objects;            ///< beside the robot's own links
  CollisionScope scope = CollisionScope::all;  ///< which pairs count
  std::vector<Names> pairs;     ///< of links or objects; used with CollisionScope::pairs
  std::vector<Names> disabled;  ///< never measured (SRDF's disable_collisions)
  /// Find the pairs that are in contact at every sampled posture, and leave them out by name.
  bool find_permanent_contacts = true;
  double clearance = 0;               ///< m, the least signed distance that is accepted
  std::vector<std::string> warnings;  ///< what the reader of the scene should know
};

}  // namespace wristwise
