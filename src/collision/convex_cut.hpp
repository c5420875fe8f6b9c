#pragma once

#include <vector>

#include "collision/part.hpp"
#include "wristwise/geometry.hpp"

namespace wristwise {

struct ConvexCut {
  std::vector<ConvexHull> pieces;  ///< together they contain the part
  double error = 0;                ///< m, no point of a piece is farther from the part
};

/// Cuts a part into convex pieces until none reaches more than `error` (m) beyond it, or there are
/// `most_pieces`, or the work allowed is done (F40).
ConvexCut convex_cut(const Part& part, double error, std::size_t most_pieces);

/// The hull of a part, and how far it reaches beyond it to within half as much again.
ConvexCut hull_of(const Part& part, double enough);

}  // namespace wristwise
