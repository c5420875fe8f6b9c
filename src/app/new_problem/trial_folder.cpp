#include "app/new_problem/trial_folder.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace wristwise::app {

TrialFolder::TrialFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "wristwise_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no temporary folder can be made: " + name);
  path_ = name;
}

TrialFolder::~TrialFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace wristwise::app
