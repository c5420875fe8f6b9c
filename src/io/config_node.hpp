#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace wristwise {

/// A value of a configuration file with the line it stands on.
struct ConfigNode {
  enum class Kind { empty, scalar, list, map };
  Kind kind = Kind::empty;
  int line = 0;                                             ///< from 1
  std::string text;                                         ///< of a scalar
  std::vector<ConfigNode> items;                            ///< of a list
  std::vector<std::pair<std::string, ConfigNode>> entries;  ///< of a map, in the file's order
};

/// @throws InvalidInput with file and line: missing, no YAML, a key given twice, no map at the top.
ConfigNode read_yaml(const std::filesystem::path& file);

/// The tree as YAML, without comments; deep parts on one line each.
std::string yaml_text(const ConfigNode& root);

}  // namespace wristwise
