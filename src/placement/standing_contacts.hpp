#pragma once

#include <vector>

#include "wristwise/placement.hpp"

namespace wristwise {

/// How far things that stand still would stand in each other.
struct StandingContact {
  double depth = 0;   ///< m, what is missing of the distances, summed; 0 where nothing is
  Scene::Names pair;  ///< with most missing
};

/// What moves with the part against everything that does not: other objects, and the links that
/// are fixed to the base. No plan notices these, as nothing of it moves against the base. Objects
/// may touch, links need the scene's clearance; where a pair is nearer as it is given (a part on
/// its table), it may be as near anywhere. Pairs count as in the scene: all, or none.
class StandingContacts {
 public:
  explicit StandingContacts(const PlacementRequest& request);

  /// @param motion of what moves, in the base frame
  StandingContact at(const Pose& motion) const;

 private:
  struct Body {
    std::string name;
    std::vector<Shape> shapes;  ///< poses in base
    double required = 0;        ///< m
  };
  struct Pair {
    std::size_t moving = 0, standing = 0;
    double required = 0;  ///< m
  };

  std::vector<Body> moving_, standing_;
  std::vector<Pair> pairs_;
};

}  // namespace wristwise
