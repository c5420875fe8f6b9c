#include "kinematics/srdf_group.hpp"

#include <urdf_model/joint.h>
#include <urdf_model/link.h>
#include <urdf_model/model.h>

#include <algorithm>
#include <set>

#include "kinematics/urdf_joint.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  names.reserve(map.size());
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

using LinkPtr = urdf::LinkConstSharedPtr;

/// By name: the order must not depend on where things lie in memory.
struct ByName {
  bool operator()(const LinkPtr& a, const LinkPtr& b) const { return a->name < b->name; }
};

/// The link itself, its parent, and so on up to the root.
std::vector<LinkPtr> lineage(LinkPtr link) {
  std::vector<LinkPtr> links;
  for (; link; link = link->getParent()) links.push_back(link);
  return links;
}

bool is_above(const LinkPtr& link, const LinkPtr& below) {
  const std::vector<LinkPtr> links = lineage(below);
  return std::find(links.begin(), links.end(), link) != links.end();
}

/// Gathers the links that a group's joints move, and the ends of its chains.
class GroupChain {
 public:
  GroupChain(const Srdf& srdf, const urdf::ModelInterface& model, std::string where)
      : srdf_(srdf), model_(model), where_(std::move(where)) {}

  std::pair<std::string, std::string> find(const std::string& name) {
    gather(name);
    if (moved_.empty()) refuse("it lists no joint that moves");
    const auto [first, last] = first_and_last_moved();
    std::string base = first->getParent()->name;
    for (const LinkPtr& candidate : bases_) {
      if (is_above(candidate, first->getParent())) base = candidate->name;
    }
    std::string tip = last->name;
    for (const LinkPtr& candidate : tips_) {
      if (is_above(last, candidate)) tip = candidate->name;
    }
    return {base, tip};
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw InvalidInput(where_, problem, "a group that is one chain");
  }

  std::pair<LinkPtr, LinkPtr> first_and_last_moved() const {
    const auto deeper = [](const LinkPtr& a, const LinkPtr& b) {
      return lineage(a).size() < lineage(b).size();
    };
    const LinkPtr last = *std::max_element(moved_.begin(), moved_.end(), deeper);
    for (const LinkPtr& link : moved_) {
      if (!is_above(link, last)) refuse("its joints lie on several branches");
    }
    return {*std::min_element(moved_.begin(), moved_.end(), deeper), last};
  }

  void gather(const std::string& name) {
    if (!open_.insert(name).second) return;
    const auto group = srdf_.groups.find(name);
    if (group == srdf_.groups.end()) {
      throw InvalidInput(where_, "there is no group '" + name + "'",
                         srdf_.groups.empty()
                             ? "a group of the SRDF, which has none"
                             : "a group such as " + similar_names(name, names_of(srdf_.groups)));
    }
    for (const auto& [base, tip] : group->second.chains) add_chain(base, tip);
    for (const std::string& joint : group->second.joints) add_joint(joint);
    for (const std::string& link : group->second.links) add_moved(require_link(link));
    for (const std::string& sub : group->second.groups) gather(sub);
  }

  LinkPtr require_link(const std::string& name) const {
    if (LinkPtr link = model_.getLink(name)) return link;
    throw InvalidInput(where_, "no link '" + name + "' in the URDF",
                       "one such as " + similar_names(name, names_of(model_.links_)));
  }

  void add_joint(const std::string& name) {
    const urdf::JointConstSharedPtr joint = model_.getJoint(name);
    if (!joint) {
      throw InvalidInput(where_, "no joint '" + name + "' in the URDF",
                         "one such as " + similar_names(name, names_of(model_.joints_)));
    }
    add_moved(model_.getLink(joint->child_link_name));
  }

  void add_chain(const std::string& base, const std::string& tip) {
    const LinkPtr first = require_link(base), last = require_link(tip);
    if (!is_above(first, last)) {
      refuse("no chain leads from '" + base + "' down to '" + tip + "'");
    }
    for (LinkPtr link = last; link != first; link = link->getParent()) add_moved(link);
    bases_.push_back(first);
    tips_.push_back(last);
  }

  void add_moved(const LinkPtr& link) {
    if (link && link->parent_joint && is_movable(*link->parent_joint)) moved_.insert(link);
  }

  const Srdf& srdf_;
  const urdf::ModelInterface& model_;
  std::string where_;
  std::set<std::string> open_;
  std::set<LinkPtr, ByName> moved_;
  std::vector<LinkPtr> bases_, tips_;
};

}  // namespace

std::pair<std::string, std::string> chain_of_group(const Srdf& srdf, const std::string& group,
                                                   const urdf::ModelInterface& model,
                                                   const std::filesystem::path& file) {
  return GroupChain(srdf, model, file.string() + ": group '" + group + "'").find(group);
}

std::vector<std::string> srdf_warnings(const Srdf& srdf, const urdf::ModelInterface& model,
                                       const std::filesystem::path& file) {
  std::set<std::string> unknown;
  const auto look_at = [&](const std::string& name) {
    if (model.links_.count(name) == 0) unknown.insert(name);
  };
  for (const auto* pairs : {&srdf.disabled, &srdf.enabled}) {
    for (const auto& [first, second] : *pairs) {
      look_at(first);
      look_at(second);
    }
  }
  for (const std::string& name : srdf.never_by_default) look_at(name);

  std::vector<std::string> warnings;
  warnings.reserve(unknown.size() + 1);
  const std::vector<std::string> links = names_of(model.links_);
  for (const std::string& name : unknown) {
    warnings.push_back(file.string() + " names '" + name +
                       "', which is no link of the robot; the nearest is " +
                       similar_names(name, links, 1));
  }
  if (!srdf.robot_name.empty() && srdf.robot_name != model.getName()) {
    warnings.push_back(file.string() + " is for the robot '" + srdf.robot_name +
                       "', the URDF is of '" + model.getName() + "'");
  }
  return warnings;
}

}  // namespace wristwise
