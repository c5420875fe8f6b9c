#include "kinematics/urdf_chain.hpp"

#include <urdf_model/joint.h>
#include <urdf_model/link.h>
#include <urdf_model/model.h>

#include <algorithm>

#include "kinematics/urdf_joint.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

using LinkPtr = urdf::LinkConstSharedPtr;

LinkPtr find_link(const urdf::ModelInterface& model, const std::string& name,
                  const std::string& where) {
  if (LinkPtr link = model.getLink(name)) return link;
  std::vector<std::string> names;
  for (const auto& entry : model.links_) names.push_back(entry.first);
  throw InvalidInput(where, "no link '" + name + "'",
                     "a link of the URDF such as " + similar_names(name, names));
}

/// Not a joint on which no chain can be planned.
bool is_passable(const urdf::Joint& joint) {
  const bool unusable = joint.type == urdf::Joint::PLANAR || joint.type == urdf::Joint::FLOATING;
  return !unusable && !joint.mimic;
}

/// The leaf below `base` with the most movable joints on its way; of those the one farthest down.
/// What hangs on a joint that is not passable does not count.
LinkPtr longest_chain_tip(const LinkPtr& base) {
  struct Reached {
    LinkPtr link;
    std::pair<int, int> length;  // movable joints, joints
  };
  Reached best{base, {0, 0}};
  std::vector<Reached> open = {best};
  while (!open.empty()) {
    const Reached at = open.back();
    open.pop_back();
    const auto& joints = at.link->child_joints;
    const bool leaf = std::none_of(joints.begin(), joints.end(),
                                   [](const auto& joint) { return is_passable(*joint); });
    if (leaf && (at.length > best.length ||
                 (at.length == best.length && at.link->name < best.link->name))) {
      best = at;
    }
    for (std::size_t i = 0; i < at.link->child_links.size(); ++i) {
      if (!is_passable(*joints[i])) continue;
      const int movable = is_movable(*joints[i]) ? 1 : 0;
      open.push_back({at.link->child_links[i], {at.length.first + movable, at.length.second + 1}});
    }
  }
  return best.link;
}

/// The link itself, its parent, and so on up to the root.
std::vector<LinkPtr> lineage(LinkPtr link) {
  std::vector<LinkPtr> links;
  for (; link; link = link->getParent()) links.push_back(link);
  return links;
}

bool contains(const std::vector<LinkPtr>& links, const LinkPtr& link) {
  return std::find(links.begin(), links.end(), link) != links.end();
}

/// The nearest link that is above both, or one of the two.
LinkPtr common_ancestor(const LinkPtr& a, const LinkPtr& b) {
  const std::vector<LinkPtr> above_b = lineage(b);
  LinkPtr link = a;
  while (!contains(above_b, link)) link = link->getParent();
  return link;
}

/// It would not move the one against the other.
void refuse_shared_joint(const LinkChain& chain, const std::string& where) {
  if (!contains(lineage(chain.top), chain.base)) return;
  for (LinkPtr link = chain.top; link != chain.base; link = link->getParent()) {
    if (!is_movable(*link->parent_joint)) continue;
    throw InvalidInput(where,
                       "joint '" + link->parent_joint->name + "' moves the part's link '" +
                           chain.part->name + "' and the tip '" + chain.tip->name + "' alike",
                       "a part_link beside the arm, or a base_link below that joint");
  }
}

}  // namespace

LinkChain find_chain(const urdf::ModelInterface& model, const RobotSource& source) {
  const std::string where = urdf_name(source);
  LinkChain chain;
  chain.base =
      source.base_link.empty() ? model.getRoot() : find_link(model, source.base_link, where);
  chain.tip = source.tip_link.empty() ? longest_chain_tip(chain.base)
                                      : find_link(model, source.tip_link, where);
  chain.part = source.part_link.empty() ? chain.base : find_link(model, source.part_link, where);
  if (!contains(lineage(chain.tip), chain.base)) {
    throw InvalidInput(
        where, "no chain leads from '" + chain.base->name + "' down to '" + chain.tip->name + "'",
        "a base_link above the tip_link in the tree");
  }
  chain.top = common_ancestor(chain.part, chain.tip);
  refuse_shared_joint(chain, where);

  for (LinkPtr link = chain.part; link != chain.top; link = link->getParent()) {
    chain.joints.push_back({link->parent_joint, link->getParent(), true, false});
  }
  const std::vector<LinkPtr> above_base = lineage(chain.base);
  std::vector<LinkPtr> down = lineage(chain.tip);
  down.erase(std::find(down.begin(), down.end(), chain.top), down.end());
  std::for_each(down.rbegin(), down.rend(), [&](const LinkPtr& link) {
    chain.joints.push_back({link->parent_joint, link, false, contains(above_base, link)});
  });
  return chain;
}

}  // namespace wristwise
