#include "kinematics/package_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace wristwise {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr std::size_t kMostFolders = 20000;  // of a search that is pointed at a whole disk

std::vector<fs::path> folders_of_variable(const char* name) {
  std::vector<fs::path> folders;
  const char* variable = std::getenv(name);
  if (variable == nullptr) return folders;
  const std::string text = variable;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(':', start), text.size());
    if (end > start) folders.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return folders;
}

/// The name that a package.xml gives; empty where there is none.
std::string declared_name(const fs::path& folder) {
  std::ifstream file(folder / "package.xml");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t open = text.find("<name>");
  const std::size_t close = text.find("</name>");
  if (open == std::string::npos || close == std::string::npos || close < open) return {};
  const std::string name = text.substr(open + 6, close - open - 6);
  const std::size_t first = name.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return name.substr(first, name.find_last_not_of(" \t\r\n") - first + 1);
}

/// Folders below, breadth first, in the order of their names.
std::vector<fs::path> folders_below(const fs::path& top) {
  std::vector<fs::path> level = {top}, all;
  for (int depth = 0; depth <= kDeepest && !level.empty(); ++depth) {
    std::vector<fs::path> next;
    for (const fs::path& folder : level) {
      all.push_back(folder);
      if (all.size() >= kMostFolders) return all;
      std::error_code error;
      for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
           entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_directory(ignored)) next.push_back(entry->path());
      }
    }
    std::sort(next.begin(), next.end());
    level = std::move(next);
  }
  return all;
}

}  // namespace

std::vector<fs::path> package_candidates(const std::string& package,
                                         const std::vector<fs::path>& searched) {
  std::vector<fs::path> tops = searched;
  for (const fs::path& folder : folders_of_variable("ROS_PACKAGE_PATH")) tops.push_back(folder);
  std::vector<fs::path> candidates;
  for (const fs::path& folder : tops) {
    candidates.push_back(folder / package);
    const fs::path normal = (folder / "").lexically_normal().parent_path();
    if (normal.filename() == package) candidates.push_back(normal);
  }
  for (const fs::path& prefix : folders_of_variable("AMENT_PREFIX_PATH")) {
    candidates.push_back(prefix / "share" / package);
  }
  const bool found = std::any_of(candidates.begin(), candidates.end(), [](const fs::path& folder) {
    std::error_code ignored;
    return fs::is_directory(folder, ignored);
  });
  if (found) return candidates;
  for (const fs::path& top : tops) {
    for (const fs::path& folder : folders_below(top)) {
      if (declared_name(folder) == package) candidates.push_back(folder);
    }
  }
  return candidates;
}

}  // namespace wristwise
