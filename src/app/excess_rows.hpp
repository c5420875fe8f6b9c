#pragma once

#include <vector>

#include "app/text_table.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// How far two trajectories are outside the tolerance, side by side: positions and angles, at the
/// waypoints and between them.
void append_excess_rows(const Verification& first, const Verification& second,
                        std::vector<TableRow>& rows);

}  // namespace wristwise::app
