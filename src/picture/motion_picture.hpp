#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "picture/plot_panel.hpp"
#include "report/shown_motions.hpp"

namespace wristwise {

/// What the pictures of a motion have in common.
struct MotionPicture {
  std::string title;
  const Robot& robot;
  std::vector<ShownMotion> motions;  ///< the result, then what is behind it; not empty
  PlotRange time;                    ///< s, of the whole seam and all motions
  std::vector<PlotRange> runs;       ///< s, where the result does not weld

  /// The colour of a motion, the first of which is the result.
  static const char* colour(std::size_t motion) {
    return motion == 0 ? plot::kResult : plot::kBehind;
  }
};

/// Writes joints.svg, joint_positions.svg and tolerance.svg into the folder; those of an earlier
/// result are removed. Without a motion none is written.
/// @param graph_only what to put behind; null: as shown_motions()
/// @return their names
/// @throws std::runtime_error where that fails
std::vector<std::string> write_motion_pictures(const std::filesystem::path& folder,
                                               const Problem& problem, const PlanResult& result,
                                               const PlanResult* graph_only);

}  // namespace wristwise
