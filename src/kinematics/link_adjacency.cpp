#include "kinematics/link_adjacency.hpp"

#include <algorithm>
#include <set>

namespace wristwise {
namespace {

class LinkTree {
 public:
  LinkTree(const std::vector<bool>& has_shapes, const std::vector<LinkConnection>& joints)
      : has_shapes_(has_shapes), neighbours_(has_shapes.size()) {
    for (const LinkConnection& joint : joints) {
      neighbours_[index(joint.parent)].push_back({joint.child, joint.movable ? 1 : 0});
      neighbours_[index(joint.child)].push_back({joint.parent, joint.movable ? 1 : 0});
    }
  }

  /// Visits the links with shapes that lie beyond `at`, seen from `start`.
  void collect(int start, int from, int at, int movable,
               std::set<std::pair<int, int>>& pairs) const {
    for (const Neighbour& next : neighbours_[index(at)]) {
      const int total = movable + next.movable;
      if (next.link == from || total > 1) continue;
      if (has_shapes_[index(next.link)]) {
        pairs.insert(std::minmax(start, next.link));
      } else {
        collect(start, at, next.link, total, pairs);
      }
    }
  }

 private:
  struct Neighbour {
    int link;
    int movable;
  };
  static std::size_t index(int link) { return static_cast<std::size_t>(link); }

  const std::vector<bool>& has_shapes_;
  std::vector<std::vector<Neighbour>> neighbours_;
};

}  // namespace

std::vector<std::pair<int, int>> adjacent_link_pairs(const std::vector<bool>& has_shapes,
                                                     const std::vector<LinkConnection>& joints) {
  std::set<std::pair<int, int>> pairs;
  for (const LinkConnection& joint : joints) pairs.insert(std::minmax(joint.parent, joint.child));
  const LinkTree tree(has_shapes, joints);
  for (std::size_t link = 0; link < has_shapes.size(); ++link) {
    const int start = static_cast<int>(link);
    if (has_shapes[link]) tree.collect(start, -1, start, 0, pairs);
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace wristwise
