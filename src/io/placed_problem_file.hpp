#pragma once

#include <filesystem>
#include <string>

#include "wristwise/placement.hpp"

namespace wristwise {

/// The problem file with the frame of the part and the poses of the objects that moved replaced,
/// for a file in `folder`: paths that are relative to the problem file lead to the same place from
/// there. Comments and the section `placement` are left out.
std::string placed_problem_text(const std::filesystem::path& problem_file,
                                const PlacedProblem& placed, const std::filesystem::path& folder);

}  // namespace wristwise
