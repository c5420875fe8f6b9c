#include "wristwise/urdf.hpp"

#include <urdf_model/joint.h>
#include <urdf_model/link.h>
#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "kinematics/joint_limits.hpp"
#include "kinematics/link_adjacency.hpp"
#include "kinematics/srdf_group.hpp"
#include "kinematics/urdf_collision.hpp"
#include "kinematics/urdf_document.hpp"
#include "kinematics/urdf_joint.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

urdf::LinkConstSharedPtr find_link(const urdf::ModelInterface& model, const std::string& name,
                                   const std::string& where) {
  if (urdf::LinkConstSharedPtr link = model.getLink(name)) return link;
  std::vector<std::string> names;
  for (const auto& entry : model.links_) names.push_back(entry.first);
  throw InvalidInput(where, "no link '" + name + "'",
                     "a link of the URDF such as " + similar_names(name, names));
}

/// The leaf below `base` with the most movable joints on its way; of those the one farthest down.
urdf::LinkConstSharedPtr longest_chain_tip(const urdf::LinkConstSharedPtr& base) {
  struct Reached {
    urdf::LinkConstSharedPtr link;
    std::pair<int, int> length;  // movable joints, joints
  };
  Reached best{base, {0, 0}};
  std::vector<Reached> open = {best};
  while (!open.empty()) {
    const Reached at = open.back();
    open.pop_back();
    const bool leaf = at.link->child_joints.empty();
    if (leaf && (at.length > best.length ||
                 (at.length == best.length && at.link->name < best.link->name))) {
      best = at;
    }
    for (std::size_t i = 0; i < at.link->child_links.size(); ++i) {
      const int movable = is_movable(*at.link->child_joints[i]) ? 1 : 0;
      open.push_back({at.link->child_links[i], {at.length.first + movable, at.length.second + 1}});
    }
  }
  return best.link;
}

/// Reads one serial chain out of the tree of links.
class ChainReader {
 public:
  explicit ChainReader(const RobotSource& source)
      : source_(source),
        where_(source.urdf.string()),
        document_(read_urdf(source.urdf, source.visual_as_collision)),
        mesh_folders_{source.urdf.parent_path(), source.packages} {
    parts_.warnings = document_.warnings;
    if (!source.srdf.empty()) read_semantics();
    if (source.limits.empty()) return;
    limits_ = read_joint_limits(source.limits);
    warn_of_strange_limits();
  }

  Robot read() {
    find_chain();
    read_joints();
    place_links();
    warn_of_oddities();
    return Robot(std::move(parts_));
  }

 private:
  struct Placement {
    int joint = -1;
    Pose pose = Pose::Identity();
  };

  /// A group gives the ends of the chain that the source does not give.
  void read_semantics() {
    const Srdf srdf = read_srdf(source_.srdf);
    for (std::string& warning : srdf_warnings(srdf, *document_.model, source_.srdf)) {
      parts_.warnings.push_back(std::move(warning));
    }
    if (source_.group.empty()) return;
    const auto [base, tip] = chain_of_group(srdf, source_.group, *document_.model, source_.srdf);
    if (source_.base_link.empty()) source_.base_link = base;
    if (source_.tip_link.empty()) source_.tip_link = tip;
  }

  /// A misspelt joint would otherwise go without its limits unnoticed.
  void warn_of_strange_limits() {
    std::vector<std::string> names;
    for (const auto& entry : document_.model->joints_) names.push_back(entry.first);
    for (const auto& entry : limits_) {
      if (document_.model->joints_.count(entry.first) > 0) continue;
      parts_.warnings.push_back(source_.limits.string() + " gives limits of '" + entry.first +
                                "', which is no joint of the robot; the nearest is " +
                                similar_names(entry.first, names, 1));
    }
  }

  void find_chain() {
    const urdf::ModelInterface& model = *document_.model;
    const urdf::LinkConstSharedPtr base =
        source_.base_link.empty() ? model.getRoot() : find_link(model, source_.base_link, where_);
    const urdf::LinkConstSharedPtr tip = source_.tip_link.empty()
                                             ? longest_chain_tip(base)
                                             : find_link(model, source_.tip_link, where_);
    parts_.name = model.getName();
    parts_.base_link = base->name;
    parts_.tip_link = tip->name;
    for (urdf::LinkConstSharedPtr link = tip; link != base; link = link->getParent()) {
      if (!link) {
        throw InvalidInput(where_,
                           "no chain leads from '" + base->name + "' down to '" + tip->name + "'",
                           "a base_link above the tip_link in the tree");
      }
      chain_.push_back(link);
    }
    chain_.push_back(base);
    std::reverse(chain_.begin(), chain_.end());
  }

  void read_joints() {
    Placement at;
    placements_[chain_.front()->name] = at;
    for (std::size_t i = 1; i < chain_.size(); ++i) {
      const urdf::Joint& source = *chain_[i]->parent_joint;
      if (is_movable(source)) {
        Joint joint = read_joint(source);
        joint.origin = at.pose * joint.origin;
        parts_.joints.push_back(std::move(joint));
        at = {static_cast<int>(parts_.joints.size()) - 1, Pose::Identity()};
      } else {
        at.pose = at.pose * pose_from_urdf(source.parent_to_joint_origin_transform);
      }
      placements_[chain_[i]->name] = at;
      on_chain_.insert(source.name);
    }
    if (parts_.joints.empty()) {
      throw InvalidInput(
          where_,
          "no movable joint between '" + parts_.base_link + "' and '" + parts_.tip_link + "'",
          "a chain that moves");
    }
    parts_.tcp = at.pose * source_.tool;
  }

  Joint read_joint(const urdf::Joint& source) {
    const auto declared = document_.declared.find(source.name);
    const auto limits = limits_.find(source.name);
    return joint_from_urdf(
        source, declared == document_.declared.end() ? DeclaredLimits{} : declared->second,
        limits == limits_.end() ? JointLimits{} : limits->second, source_.require_velocity_limits,
        where_, parts_.warnings);
  }

  void place_links() {
    place_above(chain_.front());
    list_link(document_.model->getRoot());
    std::vector<bool> has_shapes;
    for (const Link& link : parts_.links) has_shapes.push_back(!link.collision.empty());
    parts_.adjacent_links = adjacent_link_pairs(has_shapes, connections_);
  }

  /// Everything above the base stands still; its own joints are frozen.
  void place_above(const urdf::LinkConstSharedPtr& base) {
    urdf::LinkConstSharedPtr link = base;
    while (const urdf::LinkConstSharedPtr parent = link->getParent()) {
      const Pose child = placements_.at(link->name).pose;
      placements_[parent->name] = {-1, child * frozen_transform(*link->parent_joint).inverse()};
      link = parent;
    }
  }

  Pose frozen_transform(const urdf::Joint& joint) {
    const double position = frozen_position(joint, *document_.model);
    warn_of_frozen(joint, position);
    return pose_from_urdf(joint.parent_to_joint_origin_transform) * motion_at(joint, position);
  }

  /// Lists the link, then all below it; returns its index.
  int list_link(const urdf::LinkConstSharedPtr& link) {
    const Placement placement = placements_.at(link->name);
    const int index = static_cast<int>(parts_.links.size());
    std::vector<Shape> shapes;
    if (source_.read_collision_shapes) {
      shapes = collision_shapes(*link, mesh_folders_, source_.meshes, where_, parts_.warnings);
    }
    parts_.links.push_back({link->name, placement.joint, placement.pose, std::move(shapes)});
    for (std::size_t i = 0; i < link->child_links.size(); ++i) {
      const urdf::Joint& joint = *link->child_joints[i];
      const urdf::LinkConstSharedPtr child = link->child_links[i];
      if (placements_.count(child->name) == 0) {
        placements_[child->name] = {placement.joint, placement.pose * frozen_transform(joint)};
      }
      const bool moves = is_movable(joint) && on_chain_.count(joint.name) > 0;
      const int child_index = list_link(child);
      connections_.push_back({index, child_index, moves});
    }
    return index;
  }

  void warn_of_frozen(const urdf::Joint& joint, double position) {
    if (!is_movable(joint)) return;
    char text[64];
    std::snprintf(text, sizeof text, "%.6g", position);
    const std::string named = "joint '" + joint.name + "' (" + type_name(joint) + ")";
    parts_.warnings.push_back(
        follows_the_chain(joint)
            ? named + " mimics '" + joint.mimic->joint_name +
                  "', which moves: the links beyond are not moved along, but held at " + text
            : named + " is not on the chain and is held at " + text);
  }

  bool follows_the_chain(const urdf::Joint& joint) const {
    urdf::JointConstSharedPtr followed;
    for (const urdf::Joint* at = &joint; at->mimic; at = followed.get()) {
      followed = document_.model->getJoint(at->mimic->joint_name);
      if (on_chain_.count(followed->name) > 0) return true;
    }
    return false;
  }

  void warn_of_oddities() {
    for (const Joint& joint : parts_.joints) {
      if (joint.lower == joint.upper) {
        parts_.warnings.push_back("joint '" + joint.name +
                                  "' cannot move: its lower limit equals its upper one");
      }
    }
    const bool shapes = std::any_of(parts_.links.begin(), parts_.links.end(),
                                    [](const Link& link) { return !link.collision.empty(); });
    if (!shapes) parts_.warnings.emplace_back("no link has a collision shape");
    if (source_.read_collision_shapes) warn_of_visuals();
  }

  void warn_of_visuals() {
    const std::vector<std::string>& names = document_.only_visual;
    if (names.empty()) return;
    constexpr std::size_t kMostNamed = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) {
      text += (i == 0 ? "'" : ", '") + names[i] + "'";
    }
    if (names.size() > kMostNamed) {
      text += " and " + std::to_string(names.size() - kMostNamed) + " more";
    }
    parts_.warnings.push_back("links without collision shapes: " + text +
                              (source_.visual_as_collision
                                   ? "; their visual ones are used"
                                   : "; collision_from: visual would use their visual ones"));
  }

  RobotSource source_;
  std::string where_;
  UrdfDocument document_;
  MeshFolders mesh_folders_;
  std::map<std::string, JointLimits> limits_;
  std::vector<urdf::LinkConstSharedPtr> chain_;  // base to tip
  std::set<std::string> on_chain_;               // joint names
  std::map<std::string, Placement> placements_;  // by link name
  std::vector<LinkConnection> connections_;
  Robot::Parts parts_;
};

}  // namespace

Robot load_robot(const RobotSource& source) { return ChainReader(source).read(); }

}  // namespace wristwise
