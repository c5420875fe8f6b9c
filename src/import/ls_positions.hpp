#pragma once

#include <map>
#include <string>

#include "import/program_move.hpp"
#include "import/tokens.hpp"

namespace wristwise {

/// A position of the /POS section: values of axes, or a pose in a user frame.
struct LsPosition {
  std::optional<AxisValues> axes;
  std::optional<Pose> pose;
  double frame = 0, tool = 0;  ///< numbers of user frame and tool
};

using LsPositions = std::map<int, LsPosition>;

/// P[1]{ ... }; P[2]... up to /END.
LsPositions read_ls_positions(TokenReader& reader, int j3_coupling);

}  // namespace wristwise
