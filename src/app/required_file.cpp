#include "app/required_file.hpp"

#include <vector>

#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise::app {

namespace {

namespace fs = std::filesystem;

/// Names that begin as the given one does, without its extension; all where none does.
std::vector<std::string> likely(const std::vector<std::string>& names, const fs::path& given) {
  const std::string start = (given.parent_path() / given.stem()).string();
  std::vector<std::string> chosen;
  for (const std::string& name : names)
    if (name.rfind(start, 0) == 0) chosen.push_back(name);
  return chosen.empty() ? names : chosen;
}

/// ", such as 'task_c.yaml'": the nearest name in a folder; empty where there is none.
std::string such_as(const fs::path& folder, const std::string& name, const fs::path& extension) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
       !error && entry != end; entry.increment(error)) {
    const fs::path file = entry->path();
    if (file.extension() == extension && entry->is_regular_file(error))
      names.push_back((folder / file.filename()).string());
  }
  const std::string nearest =
      similar_names((folder / name).string(), likely(names, folder / name), 1);
  return nearest.empty() ? nearest : ", such as " + nearest;
}

}  // namespace

void require_file(const fs::path& file, const std::string& what, const std::string& extension) {
  std::error_code error;
  if (fs::is_directory(file, error))
    throw InvalidInput(file.string(), "is a folder",
                       what + such_as(file.lexically_normal(), "", extension));
  if (!fs::exists(file, error))
    throw InvalidInput(file.string(), "no such file",
                       what + such_as(file.parent_path(), file.filename().string(), extension));
}

}  // namespace wristwise::app
