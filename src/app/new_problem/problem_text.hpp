#pragma once

#include <optional>
#include <string>

#include "app/new_problem/seam_place.hpp"

namespace wristwise::app {

/// What the torch may do on the seam: tilt and spin, spin only, or nothing, for a chain that can
/// do no more.
enum class Freedom { tilt_and_spin, spin, none };

/// What a new problem file says; paths as they stand in the file.
struct NewProblem {
  std::string name;  ///< of the file, without its extension
  std::string urdf;
  std::string limits;  ///< empty: no such file
  std::string poses;   ///< CSV file of the seam; empty: the seam stands in the problem
  SeamShape shape = SeamShape::line;
  SeamPlace place;
  Freedom freedom = Freedom::tilt_and_spin;
  std::optional<double> plate_gap;  ///< m, of a plate below the seam; none: no plate
};

/// The problem file: template.yaml with the robot and the seam filled in.
std::string problem_text(const NewProblem& problem, const Robot& robot);

/// The CSV file of a seam of poses, in path.frame.
std::string poses_text(const SeamPlace& place);

}  // namespace wristwise::app
