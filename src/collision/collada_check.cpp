#include "collision/collada_check.hpp"

#include <tinyxml.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr const char* kWhole = "0123456789- \t\r\n";
constexpr const char* kReal = "0123456789+-.eENnAaIiFf \t\r\n";
constexpr int kDeepest = 200;

/// The characters that may stand in an element of numbers.
const std::map<std::string, const char*> kNumbers = {
    {"p", kWhole},          {"vcount", kWhole}, {"v", kWhole},        {"h", kWhole},
    {"float_array", kReal}, {"matrix", kReal},  {"translate", kReal}, {"rotate", kReal},
    {"scale", kReal},       {"lookat", kReal},  {"skew", kReal}};

/// Attributes that must be there, by element.
const std::map<std::string, std::vector<const char*>> kAttributes = {
    {"float_array", {"id", "count"}},
    {"accessor", {"source", "count"}},
    {"source", {"id"}},
    {"input", {"semantic", "source"}},
    {"vertices", {"id"}},
    {"triangles", {"count"}},
    {"trifans", {"count"}},
    {"tristrips", {"count"}},
    {"polygons", {"count"}},
    {"polylist", {"count"}},
    {"lines", {"count"}},
    {"linestrips", {"count"}},
    {"instance_geometry", {"url"}},
    {"instance_node", {"url"}},
    {"instance_controller", {"url"}},
    {"instance_visual_scene", {"url"}}};

/// One file being looked through.
class Collada {
 public:
  explicit Collada(const std::filesystem::path& file) : file_(file) {}

  void check(const TiXmlElement& root) {
    check(root, 0);
    for (const TiXmlElement* accessor : accessors_) require_values(*accessor);
  }

 private:
  void check(const TiXmlElement& element, int depth) {
    const std::string tag = element.Value();
    require_numbers(element, tag);
    // A sampler's <source> and an effect's inputs are other things of the same name.
    if (element.FirstChildElement() != nullptr || tag != "source") require_attributes(element, tag);
    if (tag == "float_array") note_array(element);
    if (tag == "accessor") accessors_.push_back(&element);
    if (depth > kDeepest) fail(element, "elements are nested too deeply");
    for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      check(*child, depth + 1);
    }
  }

  [[noreturn]] void fail(const TiXmlElement& element, const std::string& problem) const {
    throw InvalidInput(file_.string() + ":" + std::to_string(element.Row()), problem,
                       "sound COLLADA");
  }

  void require_numbers(const TiXmlElement& element, const std::string& tag) const {
    const auto allowed = kNumbers.find(tag);
    if (allowed == kNumbers.end() || element.FirstChild() == nullptr) return;
    const char* text = element.GetText();
    if (text != nullptr &&
        std::string(text).find_first_not_of(allowed->second) == std::string::npos) {
      return;
    }
    fail(element, "<" + tag + "> holds something else than numbers");
  }

  void require_attributes(const TiXmlElement& element, const std::string& tag) const {
    const auto required = kAttributes.find(tag);
    if (required == kAttributes.end()) return;
    for (const char* name : required->second) {
      const char* value = element.Attribute(name);
      if (value == nullptr || *value == '\0') fail(element, "<" + tag + "> has no " + name);
    }
  }

  long whole_number(const TiXmlElement& element, const char* name, long missing) const {
    const char* text = element.Attribute(name);
    if (text == nullptr) return missing;
    const std::string digits = text;
    const bool sound = !digits.empty() && digits.size() < 10 &&
                       digits.find_first_not_of("0123456789") == std::string::npos;
    if (!sound) fail(element, "<" + element.ValueStr() + "> has no whole number as " + name);
    return std::stol(digits);
  }

  void note_array(const TiXmlElement& element) {
    const char* text = element.GetText();
    std::istringstream stream(text == nullptr ? "" : text);
    long numbers = 0;
    for (std::string number; stream >> number;) ++numbers;
    const long count = whole_number(element, "count", 0);
    if (numbers < count) fail(element, "<float_array> has fewer numbers than its count says");
    array_size_["#" + std::string(element.Attribute("id"))] = count;
  }

  /// That an accessor stays within its array.
  void require_values(const TiXmlElement& accessor) const {
    const auto array = array_size_.find(accessor.Attribute("source"));
    if (array == array_size_.end()) return;
    long parameters = 0;
    for (const TiXmlElement* parameter = accessor.FirstChildElement("param"); parameter != nullptr;
         parameter = parameter->NextSiblingElement("param")) {
      ++parameters;
    }
    const long stride = whole_number(accessor, "stride", 1);
    const long needed =
        whole_number(accessor, "offset", 0) + whole_number(accessor, "count", 0) * stride;
    if (parameters > stride || needed > array->second) {
      fail(accessor, "<accessor> wants more numbers than there are");
    }
  }

  const std::filesystem::path& file_;
  std::map<std::string, long> array_size_;
  std::vector<const TiXmlElement*> accessors_;
};

}  // namespace

void check_collada(const std::filesystem::path& file) {
  TiXmlDocument document;
  if (!document.LoadFile(file.string())) {
    throw InvalidInput(file.string() + ":" + std::to_string(document.ErrorRow()),
                       std::string("not valid XML: ") + document.ErrorDesc(), "sound COLLADA");
  }
  const TiXmlElement* root = document.RootElement();
  if (root == nullptr || root->ValueStr() != "COLLADA") {
    throw InvalidInput(file.string(), "no <COLLADA> element", "sound COLLADA");
  }
  Collada(file).check(*root);
}

}  // namespace wristwise
