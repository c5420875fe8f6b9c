#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace wristwise {

/// A point of the unit cube: coordinates from 0 to 1.
using CubePoint = std::vector<double>;

/// May throw, which ends the search.
using CubeFunction = std::function<double(const CubePoint&)>;

struct CubeMinimum {
  CubePoint point;
  double value = 0;
};

/// The least value that NLopt's controlled random search with local mutation (GN_CRS2_LM: Kaelo,
/// Ali, J. Optim. Theory Appl. 130(2), 2006) comes upon, which needs no derivative and only
/// compares values: they may jump.
/// @param start one of the points looked at
CubeMinimum search_globally(const CubeFunction& function, const CubePoint& start,
                            std::uint32_t seed, int evaluations);

/// The least value that NLopt's Sbplx (LN_SBPLX: Rowan, 1990), a simplex search in subspaces, comes
/// upon. Not above that at the start.
CubeMinimum search_locally(const CubeFunction& function, const CubeMinimum& start, int evaluations);

}  // namespace wristwise
