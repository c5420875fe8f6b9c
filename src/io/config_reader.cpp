#include "io/config_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

std::string shown(const ConfigNode& node) {
  switch (node.kind) {
    case ConfigNode::Kind::scalar:
      return "'" + node.text + "'";
    case ConfigNode::Kind::list:
      return fmt::format("a list of {}", node.items.size());
    case ConfigNode::Kind::map:
      return "a map";
    case ConfigNode::Kind::empty:
      break;
  }
  return "no value";
}

}  // namespace

std::string ConfigReader::where() const {
  const std::string place = fmt::format("{}:{}", file_.string(), node_->line);
  return path_.empty() ? place : place + ": " + path_;
}

void ConfigReader::fail(const std::string& problem, const std::string& expected) const {
  throw InvalidInput(where(), problem, expected);
}

bool ConfigReader::is_word(const std::string& word) const {
  return node_->kind == ConfigNode::Kind::scalar && node_->text == word;
}

void ConfigReader::expect_keys(const std::vector<std::string>& known) const {
  if (!is_map()) fail(shown(*node_), fmt::format("keys: {}", fmt::join(known, ", ")));
  for (const auto& [key, value] : node_->entries) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const ConfigReader unknown(*this, value, path_.empty() ? key : path_ + "." + key);
    unknown.fail(
        fmt::format("unknown key, the nearest known key is {}", similar_names(key, known, 1)),
        fmt::format("one of {}", fmt::join(known, ", ")));
  }
}

std::optional<ConfigReader> ConfigReader::find(const std::string& key) const {
  for (const auto& [name, value] : node_->entries)
    if (name == key) return ConfigReader(*this, value, path_.empty() ? key : path_ + "." + key);
  return std::nullopt;
}

ConfigReader ConfigReader::at(const std::string& key) const {
  if (auto found = find(key)) return *found;
  fail(fmt::format("the key '{}' is missing", key));
}

std::vector<ConfigReader> ConfigReader::items() const {
  if (!is_list()) fail(shown(*node_), "a list");
  std::vector<ConfigReader> readers;
  for (std::size_t i = 0; i < node_->items.size(); ++i)
    readers.push_back(ConfigReader(*this, node_->items[i], fmt::format("{}[{}]", path_, i)));
  return readers;
}

std::vector<ConfigReader> ConfigReader::items(std::size_t count,
                                              const std::string& expected) const {
  if (!is_list() || node_->items.size() != count) fail(shown(*node_), expected);
  return items();
}

std::string ConfigReader::text() const {
  if (node_->kind != ConfigNode::Kind::scalar || node_->text.empty()) fail(shown(*node_), "a text");
  return node_->text;
}

std::string ConfigReader::choice(const std::vector<std::string>& words) const {
  for (const std::string& word : words)
    if (is_word(word)) return word;
  fail(shown(*node_), fmt::format("{}", fmt::join(words, " or ")));
}

int ConfigReader::whole_number(int least) const {
  const double value = quantity(Quantity::number);
  if (value != std::floor(value) || value < least || value > 1e9)
    fail(shown(*node_), fmt::format("a whole number of at least {}", least));
  return static_cast<int>(value);
}

double ConfigReader::quantity(Quantity quantity) const {
  if (node_->kind != ConfigNode::Kind::scalar) fail(shown(*node_), wristwise::describe(quantity));
  return parse_quantity(node_->text, quantity, where());
}

double ConfigReader::positive(Quantity quantity) const {
  const double value = this->quantity(quantity);
  if (value <= 0)
    fail(fmt::format("'{}' is not above zero", node_->text), wristwise::describe(quantity));
  return value;
}

double ConfigReader::not_negative(Quantity quantity) const {
  const double value = this->quantity(quantity);
  if (value < 0) fail(fmt::format("'{}' is negative", node_->text), wristwise::describe(quantity));
  return value;
}

Eigen::Vector3d ConfigReader::vector(Quantity quantity) const {
  const std::vector<ConfigReader> parts =
      items(3, fmt::format("a list of three, each {}", wristwise::describe(quantity)));
  return {parts[0].quantity(quantity), parts[1].quantity(quantity), parts[2].quantity(quantity)};
}

std::filesystem::path ConfigReader::relative_path() const { return file_.parent_path() / text(); }

std::filesystem::path ConfigReader::existing_file() const {
  std::filesystem::path path = relative_path().lexically_normal();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) fail("no such file: " + path.string());
  if (std::filesystem::is_directory(path, error)) fail(path.string() + " is a folder", "a file");
  uses_file(path);
  return path;
}

}  // namespace wristwise
