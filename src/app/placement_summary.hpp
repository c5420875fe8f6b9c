#pragma once

#include <filesystem>
#include <string>

#include "app/paint.hpp"
#include "wristwise/placement.hpp"

namespace wristwise::app {

/// For people: the given placement beside the one found, and what to put into the problem file.
std::string placement_summary(const PlacementRequest& request, const PlacementResult& result,
                              const std::filesystem::path& folder, const Paint& paint);

}  // namespace wristwise::app
