#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace wristwise {

/// What an SRDF says of links and joints, by name.
struct Srdf {
  using Names = std::pair<std::string, std::string>;

  /// The union of what it lists.
  struct Group {
    std::vector<Names> chains;  ///< base_link, tip_link
    std::vector<std::string> joints;
    std::vector<std::string> links;
    std::vector<std::string> groups;
  };

  std::string robot_name;
  std::map<std::string, Group> groups;
  std::vector<Names> disabled;                ///< disable_collisions
  std::vector<std::string> never_by_default;  ///< disable_default_collisions
  std::vector<Names> enabled;                 ///< enable_collisions
};

/// @throws InvalidInput with file and line.
Srdf read_srdf(const std::filesystem::path& file);

}  // namespace wristwise
