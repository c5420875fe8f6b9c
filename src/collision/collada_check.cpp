#include "collision/collada_check.hpp"

#include <tinyxml.h>

#include <map>
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

  void check(const TiXmlElement& element, int depth) const {
    const std::string tag = element.Value();
    require_numbers(element, tag);
    // A sampler's <source> and an effect's inputs are other things of the same name.
    if (element.FirstChildElement() != nullptr || tag != "source") require_attributes(element, tag);
    if (depth > kDeepest) fail(element, "elements are nested too deeply");
    for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      check(*child, depth + 1);
    }
  }

 private:
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

  const std::filesystem::path& file_;
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
  Collada(file).check(*root, 0);
}

}  // namespace wristwise
