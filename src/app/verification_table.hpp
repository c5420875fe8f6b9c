#pragma once

#include <string>

#include "wristwise/plan.hpp"

namespace wristwise::app {

/// What the independent check found, for people.
std::string verification_table(const Verification& verification, const Problem& problem);

/// "1.2e-7 m, 3e-8 rad": the largest excess of a position and of an angle.
std::string excess_text(const Vector6& excess);

}  // namespace wristwise::app
