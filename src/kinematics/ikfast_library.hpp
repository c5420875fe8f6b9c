#pragma once

#include <filesystem>
#include <memory>

#include "wristwise/ikfast_inverse_kinematics.hpp"

namespace wristwise {

struct IkFastLibrary {
  IkFastFunctions functions;
  std::shared_ptr<void> handle;
};

/// @throws InvalidInput where the file is missing, can't be loaded, or lacks a function
IkFastLibrary open_ikfast_library(const std::filesystem::path& file);

}  // namespace wristwise
