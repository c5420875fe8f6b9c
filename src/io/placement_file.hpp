#pragma once

#include <filesystem>
#include <string>

#include "wristwise/placement.hpp"

namespace wristwise {

/// placement.json.
std::string placement_json(const PlacementRequest& request, const PlacementResult& result);

/// map.csv: the six coordinates (m, rad) and what was measured there; empty where there is no map.
std::string placement_map_csv(const PlacementResult& result);

/// Makes the folder and writes placement.json, map.csv, map.svg and, where a placement was found,
/// problem_placed.yaml and the plan there in plan/. Those of an earlier result are removed.
/// @param problem_file that the request was read from
/// @throws std::runtime_error where that fails
void write_placement(const std::filesystem::path& folder, const PlacementRequest& request,
                     const PlacementResult& result, const std::filesystem::path& problem_file);

}  // namespace wristwise
