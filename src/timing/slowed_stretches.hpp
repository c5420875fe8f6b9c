#pragma once

#include <vector>

#include "timing/motion_rates.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// Where a law (one joint, a time over the real time) runs slower than 0.999, and the joint that
/// the motion in real time drives nearest to its limits there.
std::vector<SlowedStretch> slowed_stretches(const Trajectory& law, const Trajectory& motion,
                                            const Rates& limits);

}  // namespace wristwise
