#pragma once

#include <urdf_model/types.h>
#include <urdf_world/types.h>

#include <string>
#include <vector>

#include "wristwise/urdf.hpp"

namespace wristwise {

/// A joint on the way from the part to the tip.
struct ChainJoint {
  urdf::JointConstSharedPtr joint;
  urdf::LinkConstSharedPtr to;  ///< the link that it leads to
  bool reversed = false;        ///< passed from child to parent
  bool held = false;            ///< above the base, so that it does not move
};

/// The way through the tree of links from the part up to the nearest link above both, and down to
/// the tip.
struct LinkChain {
  urdf::LinkConstSharedPtr base, part, top, tip;
  std::vector<ChainJoint> joints;
};

/// @throws InvalidInput where a link is unknown, the tip is not below the base, or a joint below
/// the base moves part and tip alike.
LinkChain find_chain(const urdf::ModelInterface& model, const RobotSource& source);

}  // namespace wristwise
