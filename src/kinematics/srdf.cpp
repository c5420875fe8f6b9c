#include <tinyxml.h>

#include "wristwise/error.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise {
namespace {

std::string link_attribute(const TiXmlElement& element, const char* name,
                           const std::filesystem::path& file) {
  const char* value = element.Attribute(name);
  if (value != nullptr && *value != '\0') return value;
  throw InvalidInput(file.string() + ":" + std::to_string(element.Row()),
                     std::string("disable_collisions has no ") + name, "the name of a link");
}

}  // namespace

std::vector<LinkNames> load_disabled_collisions(const std::filesystem::path& srdf) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(srdf, error)) {
    throw InvalidInput(srdf.string(), "no such file", "an SRDF file");
  }
  TiXmlDocument document;
  if (!document.LoadFile(srdf.string())) {
    throw InvalidInput(srdf.string() + ":" + std::to_string(document.ErrorRow()),
                       std::string("not valid XML: ") + document.ErrorDesc(), "an SRDF file");
  }
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) throw InvalidInput(srdf.string(), "no <robot> element", "an SRDF file");

  std::vector<LinkNames> pairs;
  for (const TiXmlElement* element = robot->FirstChildElement("disable_collisions");
       element != nullptr; element = element->NextSiblingElement("disable_collisions")) {
    pairs.emplace_back(link_attribute(*element, "link1", srdf),
                       link_attribute(*element, "link2", srdf));
  }
  return pairs;
}

}  // namespace wristwise
