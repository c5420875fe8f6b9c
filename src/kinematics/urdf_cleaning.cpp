#include "kinematics/urdf_cleaning.hpp"

#include <tinyxml.h>

#include <algorithm>
#include <array>

namespace wristwise {
namespace {

constexpr std::array<const char*, 2> kOfRobot = {"link", "joint"};
constexpr std::array<const char*, 2> kOfLink = {"collision", "visual"};
constexpr std::array<const char*, 2> kOfShape = {"origin", "geometry"};
constexpr std::array<const char*, 6> kOfJoint = {"origin", "parent", "child",
                                                 "axis",   "limit",  "mimic"};

template <std::size_t N>
void keep_only(TiXmlElement& element, const std::array<const char*, N>& tags) {
  for (TiXmlNode* child = element.FirstChild(); child != nullptr;) {
    TiXmlNode* const next = child->NextSibling();
    const bool kept = child->ToElement() != nullptr &&
                      std::any_of(tags.begin(), tags.end(),
                                  [&](const char* tag) { return child->ValueStr() == tag; });
    if (!kept) element.RemoveChild(child);
    child = next;
  }
}

void remove_all(TiXmlElement& element, const char* tag) {
  while (TiXmlElement* child = element.FirstChildElement(tag)) element.RemoveChild(child);
}

/// Numbers may be separated by any white space; urdfdom knows blanks only.
void tidy_spaces(TiXmlElement& element) {
  for (TiXmlAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    std::string text = a->Value();
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    a->SetValue(text);
  }
  for (TiXmlElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    tidy_spaces(*child);
  }
}

/// @return whether it has visual elements but no collision element
bool clean_link(TiXmlElement& link, bool visual_as_collision) {
  keep_only(link, kOfLink);
  const bool only_visual =
      link.FirstChildElement("collision") == nullptr && link.FirstChildElement("visual") != nullptr;
  if (only_visual && visual_as_collision) {
    while (TiXmlElement* visual = link.FirstChildElement("visual")) visual->SetValue("collision");
  }
  remove_all(link, "visual");
  for (TiXmlElement* shape = link.FirstChildElement("collision"); shape != nullptr;
       shape = shape->NextSiblingElement("collision")) {
    keep_only(*shape, kOfShape);
  }
  return only_visual;
}

void clean_joint(TiXmlElement& joint) {
  keep_only(joint, kOfJoint);
  const char* type = joint.Attribute("type");
  if (type == nullptr || std::string(type) != "fixed") return;
  remove_all(joint, "limit");
  remove_all(joint, "mimic");
}

}  // namespace

std::vector<std::string> clean_urdf(TiXmlElement& robot, bool visual_as_collision) {
  keep_only(robot, kOfRobot);
  tidy_spaces(robot);
  std::vector<std::string> only_visual;
  for (TiXmlElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const char* name = link->Attribute("name");
    if (clean_link(*link, visual_as_collision) && name != nullptr) only_visual.emplace_back(name);
  }
  for (TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    clean_joint(*joint);
  }
  return only_visual;
}

}  // namespace wristwise
