#include "kinematics/srdf.hpp"

#include <tinyxml.h>

#include "wristwise/error.hpp"

namespace wristwise {
namespace {

/// The SRDF being read, for the place of a fault.
class SrdfReader {
 public:
  explicit SrdfReader(const std::filesystem::path& file) : file_(file) {}

  Srdf read(const TiXmlElement& robot) const {
    Srdf srdf;
    if (const char* name = robot.Attribute("name")) srdf.robot_name = name;
    for (const TiXmlElement* child = robot.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string tag = child->Value();
      if (tag == "group") read_group(*child, srdf);
      if (tag == "disable_collisions") srdf.disabled.push_back(pair(*child, "link1", "link2"));
      if (tag == "enable_collisions") srdf.enabled.push_back(pair(*child, "link1", "link2"));
      if (tag == "disable_default_collisions") {
        srdf.never_by_default.push_back(attribute(*child, "link"));
      }
    }
    return srdf;
  }

 private:
  std::string where(const TiXmlElement& element) const {
    return file_.string() + ":" + std::to_string(element.Row());
  }

  std::string attribute(const TiXmlElement& element, const char* name) const {
    const char* value = element.Attribute(name);
    if (value != nullptr && *value != '\0') return value;
    throw InvalidInput(where(element), std::string(element.Value()) + " has no " + name, "a name");
  }

  Srdf::Names pair(const TiXmlElement& element, const char* first, const char* second) const {
    return {attribute(element, first), attribute(element, second)};
  }

  void read_group(const TiXmlElement& element, Srdf& srdf) const {
    const std::string name = attribute(element, "name");
    Srdf::Group group;
    for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string tag = child->Value();
      if (tag == "chain") group.chains.push_back(pair(*child, "base_link", "tip_link"));
      if (tag == "joint") group.joints.push_back(attribute(*child, "name"));
      if (tag == "link") group.links.push_back(attribute(*child, "name"));
      if (tag == "group") group.groups.push_back(attribute(*child, "name"));
    }
    if (!srdf.groups.emplace(name, std::move(group)).second) {
      throw InvalidInput(where(element), "group '" + name + "' is given twice");
    }
  }

  const std::filesystem::path& file_;
};

}  // namespace

Srdf read_srdf(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InvalidInput(file.string(), "no such file", "an SRDF file");
  }
  TiXmlDocument document;
  if (!document.LoadFile(file.string())) {
    throw InvalidInput(file.string() + ":" + std::to_string(document.ErrorRow()),
                       std::string("not valid XML: ") + document.ErrorDesc(), "an SRDF file");
  }
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) throw InvalidInput(file.string(), "no <robot> element", "an SRDF file");
  return SrdfReader(file).read(*robot);
}

}  // namespace wristwise
