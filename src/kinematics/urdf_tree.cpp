#include <fmt/format.h>
#include <tinyxml.h>

#include <map>
#include <set>

#include "kinematics/urdf_cleaning.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

// Far above any robot; what follows may then recurse.
constexpr std::size_t kMostInARow = 1000;

struct ParentJoint {
  std::string joint, parent;
};

std::string text_of(const TiXmlElement* element, const char* attribute) {
  const char* value = element == nullptr ? nullptr : element->Attribute(attribute);
  return value == nullptr ? std::string() : value;
}

std::string at(const std::string& where, const TiXmlElement& element) {
  return where + ":" + std::to_string(element.Row());
}

bool has_xacro(const TiXmlElement& element) {
  if (element.ValueStr().rfind("xacro:", 0) == 0) return true;
  for (const TiXmlAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (std::string(a->Value()).find("${") != std::string::npos) return true;
  }
  return false;
}

/// @param depth of the elements that are still looked at
void refuse_xacro(const TiXmlElement& element, const std::string& where, int depth) {
  if (has_xacro(element)) {
    throw InvalidInput(at(where, element), "this is xacro, not yet expanded",
                       "the output of `xacro FILE`");
  }
  if (depth == 0) return;
  for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    refuse_xacro(*child, where, depth - 1);
  }
}

std::map<std::string, ParentJoint> parent_joints(const TiXmlElement& robot,
                                                 const std::string& where) {
  std::map<std::string, ParentJoint> above;
  for (const TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const std::string name = text_of(joint, "name");
    const std::string child = text_of(joint->FirstChildElement("child"), "link");
    const std::string parent = text_of(joint->FirstChildElement("parent"), "link");
    if (child.empty()) continue;  // urdfdom says what is missing
    const auto [entry, is_new] = above.emplace(child, ParentJoint{name, parent});
    if (is_new) continue;
    throw InvalidInput(
        at(where, *joint),
        fmt::format("link '{}' hangs on joint '{}' and on '{}'", child, entry->second.joint, name),
        "a tree: a closed loop of links has to be cut open, one joint left out");
  }
  return above;
}

}  // namespace

void require_expanded_tree(const TiXmlElement& robot, const std::string& where) {
  refuse_xacro(robot, where, 5);
  const std::map<std::string, ParentJoint> above = parent_joints(robot, where);
  for (const auto& start : above) {
    std::set<std::string> passed;
    for (auto link = above.find(start.first); link != above.end();
         link = above.find(link->second.parent)) {
      if (!passed.insert(link->first).second) {
        throw InvalidInput(where, "joint '" + link->second.joint + "' is part of a loop of joints",
                           "a tree: one joint of the loop left out");
      }
      if (passed.size() > kMostInARow) {
        throw InvalidInput(
            where, "more than " + std::to_string(kMostInARow) + " joints follow one another",
            "a robot");
      }
    }
  }
}

}  // namespace wristwise
