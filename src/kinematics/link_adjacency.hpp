#pragma once

#include <utility>
#include <vector>

namespace wristwise {

/// A joint of the tree, between two links given by index.
struct LinkConnection {
  int parent = 0;
  int child = 0;
  bool movable = false;
};

/// The pairs of links that a joint connects, and those with shapes that are connected through links
/// without shapes and at most one movable joint. Sorted, first < second.
std::vector<std::pair<int, int>> adjacent_link_pairs(const std::vector<bool>& has_shapes,
                                                     const std::vector<LinkConnection>& joints);

}  // namespace wristwise
