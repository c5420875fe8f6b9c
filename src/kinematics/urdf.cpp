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
#include "kinematics/urdf_chain.hpp"
#include "kinematics/urdf_collision.hpp"
#include "kinematics/urdf_document.hpp"
#include "kinematics/urdf_joint.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

/// Reads one serial chain out of the tree of links.
class ChainReader {
 public:
  explicit ChainReader(const RobotSource& source)
      : source_(source),
        where_(urdf_name(source)),
        document_(read_urdf(source)),
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
    chain_ = wristwise::find_chain(*document_.model, source_);
    parts_.name = document_.model->getName();
    parts_.base_link = chain_.base->name;
    parts_.part_link = chain_.part->name;
    parts_.tip_link = chain_.tip->name;
  }

  void read_joints() {
    Placement at;
    placements_[chain_.part->name] = at;
    for (const ChainJoint& passed : chain_.joints) {
      const bool moves = is_movable(*passed.joint) && !passed.held;
      at = moves ? beyond_movable(at, passed) : beyond_fixed(at, passed);
      placements_[passed.to->name] = at;
      if (moves) on_chain_.insert(passed.joint->name);
    }
    if (parts_.joints.empty()) {
      throw InvalidInput(
          where_,
          "no movable joint between '" + parts_.part_link + "' and '" + parts_.tip_link + "'",
          "a chain that moves");
    }
    parts_.tcp = at.pose * source_.tool;
  }

  // (F62) A joint with origin O and axis a takes its parent to its child by O M(a, q). Passed the
  // other way that is M(a, q)^-1 O^-1 = M(-a, q) O^-1: a joint without origin, and then O^-1.
  Placement beyond_movable(const Placement& at, const ChainJoint& passed) {
    Joint joint = read_joint(*passed.joint);
    Placement beyond;
    if (passed.reversed) {
      beyond.pose = joint.origin.inverse();
      joint.origin = at.pose;
      joint.axis = -joint.axis;
    } else {
      joint.origin = at.pose * joint.origin;
    }
    parts_.joints.push_back(std::move(joint));
    beyond.joint = static_cast<int>(parts_.joints.size()) - 1;
    return beyond;
  }

  Placement beyond_fixed(const Placement& at, const ChainJoint& passed) {
    const Pose step = frozen_transform(*passed.joint);
    return {at.joint, at.pose * (passed.reversed ? step.inverse() : step)};
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
    place_above(chain_.top);
    list_link(document_.model->getRoot());
    std::vector<bool> has_shapes;
    for (const Link& link : parts_.links) has_shapes.push_back(!link.collision.empty());
    parts_.adjacent_links = adjacent_link_pairs(has_shapes, connections_);
  }

  /// Everything above the chain goes with its top; its own joints are frozen.
  void place_above(const urdf::LinkConstSharedPtr& top) {
    urdf::LinkConstSharedPtr link = top;
    while (const urdf::LinkConstSharedPtr parent = link->getParent()) {
      const Placement child = placements_.at(link->name);
      placements_[parent->name] = {child.joint,
                                   child.pose * frozen_transform(*link->parent_joint).inverse()};
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
  LinkChain chain_;
  std::set<std::string> on_chain_;               // joint names
  std::map<std::string, Placement> placements_;  // by link name
  std::vector<LinkConnection> connections_;
  Robot::Parts parts_;
};

}  // namespace

Robot load_robot(const RobotSource& source) { return ChainReader(source).read(); }

}  // namespace wristwise
