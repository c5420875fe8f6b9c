#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/config_node.hpp"
#include "io/quantity.hpp"

namespace wristwise {

/// A place in a configuration file that knows its dotted key, so that every complaint names file,
/// line and key. All members throw InvalidInput where the value is not what is asked for.
class ConfigReader {
 public:
  /// @param root must outlive the reader and all readers made from it
  ConfigReader(const ConfigNode& root, const std::filesystem::path& file)
      : node_(&root),
        file_(file),
        files_(std::make_shared<std::vector<std::filesystem::path>>(1, file)) {}

  /// "file:line: key"
  std::string where() const;
  [[noreturn]] void fail(const std::string& problem, const std::string& expected = {}) const;

  bool is_list() const { return node_->kind == ConfigNode::Kind::list; }
  bool is_map() const { return node_->kind == ConfigNode::Kind::map; }
  bool is_word(const std::string& word) const;

  /// Demands a map with no other keys; an unknown one is reported with the nearest known key.
  void expect_keys(const std::vector<std::string>& known) const;
  std::optional<ConfigReader> find(const std::string& key) const;
  ConfigReader at(const std::string& key) const;

  std::vector<ConfigReader> items() const;
  std::vector<ConfigReader> items(std::size_t count, const std::string& expected) const;

  std::string text() const;
  std::string choice(const std::vector<std::string>& words) const;
  int whole_number(int least) const;
  double quantity(Quantity quantity) const;
  double positive(Quantity quantity) const;
  double not_negative(Quantity quantity) const;
  Eigen::Vector3d vector(Quantity quantity) const;

  /// A path relative to the folder of the file; it must exist.
  std::filesystem::path existing_file() const;
  std::filesystem::path relative_path() const;

  /// The file itself and those that it names: existing_file() and uses_file() add to them.
  const std::vector<std::filesystem::path>& files() const { return *files_; }
  void uses_file(const std::filesystem::path& file) const { files_->push_back(file); }

 private:
  ConfigReader(const ConfigReader& above, const ConfigNode& node, std::string path)
      : node_(&node), file_(above.file_), path_(std::move(path)), files_(above.files_) {}

  const ConfigNode* node_;
  std::filesystem::path file_;
  std::string path_;
  std::shared_ptr<std::vector<std::filesystem::path>> files_;  ///< of all readers of the file
};

}  // namespace wristwise
