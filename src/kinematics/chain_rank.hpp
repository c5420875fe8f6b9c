#pragma once

#include "wristwise/robot.hpp"

namespace wristwise {

/// Number of singular values of rows of a Jacobian above 1e-6 of the largest.
int rank_of(const Jacobian& rows);

/// In how many directions the chain can move its TCP away from singular postures, 1 to 6.
int chain_rank(const Robot& robot);

}  // namespace wristwise
