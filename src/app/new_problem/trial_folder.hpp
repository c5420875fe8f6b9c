#pragma once

#include <filesystem>

namespace wristwise::app {

/// A folder of its own under the system's temporary folder, removed at the end.
class TrialFolder {
 public:
  /// @throws std::runtime_error where none can be made
  TrialFolder();
  ~TrialFolder();
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace wristwise::app
