#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "io/config_node.hpp"
#include "io/text_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr int kDeepest = 64;
constexpr int kMostNodes = 2'000'000;

/// Copies the tree; aliases are followed, so depth and size are bounded.
class Converter {
 public:
  explicit Converter(std::string file) : file_(std::move(file)) {}

  ConfigNode convert(const YAML::Node& yaml, int depth = 0) {
    ConfigNode node;
    node.line = yaml.Mark().line + 1;
    if (depth > kDeepest || ++nodes_ > kMostNodes)
      throw InvalidInput(place(node.line), "nested too deeply or too large");
    if (yaml.IsScalar()) {
      node.kind = ConfigNode::Kind::scalar;
      node.text = yaml.Scalar();
    } else if (yaml.IsSequence()) {
      node.kind = ConfigNode::Kind::list;
      for (const YAML::Node& item : yaml) node.items.push_back(convert(item, depth + 1));
    } else if (yaml.IsMap()) {
      node.kind = ConfigNode::Kind::map;
      for (const auto& entry : yaml) add_entry(entry.first, entry.second, depth, node);
    }
    return node;
  }

  std::string place(int line) const { return file_ + ":" + std::to_string(line); }

 private:
  void add_entry(const YAML::Node& key, const YAML::Node& value, int depth, ConfigNode& node) {
    const int line = key.Mark().line + 1;
    if (!key.IsScalar()) throw InvalidInput(place(line), "a key that is no word");
    const std::string& name = key.Scalar();
    const bool given = std::any_of(node.entries.begin(), node.entries.end(),
                                   [&](const auto& entry) { return entry.first == name; });
    if (given) throw InvalidInput(place(line), "the key '" + name + "' is given twice");
    node.entries.emplace_back(name, convert(value, depth + 1));
    node.entries.back().second.line = line;
  }

  std::string file_;
  int nodes_ = 0;
};

int height(const ConfigNode& node) {
  int below = -1;
  for (const ConfigNode& item : node.items) below = std::max(below, height(item));
  for (const auto& [key, value] : node.entries) below = std::max(below, height(value));
  return below + 1;
}

/// A leaf, or a list of leaves, or what holds little more than that.
bool is_short(const ConfigNode& node, int depth) {
  return height(node) <= (depth < 2 ? 1 : 2) && (depth > 0 || node.entries.empty());
}

void emit(const ConfigNode& node, int depth, YAML::Emitter& out) {
  switch (node.kind) {
    case ConfigNode::Kind::empty:
      out << YAML::Null;
      return;
    case ConfigNode::Kind::scalar:
      out << node.text;
      return;
    case ConfigNode::Kind::list:
      out << (is_short(node, depth) ? YAML::Flow : YAML::Block) << YAML::BeginSeq;
      for (const ConfigNode& item : node.items) emit(item, depth + 1, out);
      out << YAML::EndSeq;
      return;
    case ConfigNode::Kind::map:
      out << (is_short(node, depth) ? YAML::Flow : YAML::Block) << YAML::BeginMap;
      for (const auto& [key, value] : node.entries) {
        out << YAML::Key << key << YAML::Value;
        emit(value, depth + 1, out);
      }
      out << YAML::EndMap;
      return;
  }
}

}  // namespace

std::string yaml_text(const ConfigNode& root) {
  YAML::Emitter out;
  emit(root, 0, out);
  return std::string(out.c_str()) + "\n";
}

ConfigNode read_yaml(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  Converter converter(file.string());
  try {
    std::vector<YAML::Node> documents = YAML::LoadAll(text);
    while (documents.size() > 1 && documents.back().IsNull()) documents.pop_back();
    if (documents.size() != 1)
      throw InvalidInput(file.string(), documents.empty() ? "empty" : "several YAML documents",
                         "one YAML document");
    ConfigNode root = converter.convert(documents.front());
    if (root.kind != ConfigNode::Kind::map)
      throw InvalidInput(converter.place(1), "not a list of keys and values", "a YAML map");
    return root;
  } catch (const YAML::Exception& error) {
    const std::string column = std::to_string(std::max(0, error.mark.column) + 1);
    throw InvalidInput(converter.place(std::max(0, error.mark.line) + 1) + ":" + column,
                       "not valid YAML: " + error.msg);
  }
}

}  // namespace wristwise
