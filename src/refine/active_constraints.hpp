#pragma once

#include <vector>

#include "refine/limit_constraint.hpp"
#include "refine/point_constraint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// Which constraints hold the optimum back, where, and what widening them would bring, from the
/// multipliers (F33). The most costly first.
/// @param objective J (F14) of the solution that the multipliers belong to
std::vector<ActiveConstraint> active_constraints(const ClearanceModel& clearance,
                                                 const Spline& spline,
                                                 std::vector<PointConstraint> points,
                                                 const std::vector<LimitConstraint>& limits,
                                                 double objective);

}  // namespace wristwise
