#pragma once

#include <string>

#include "app/paint.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::app {

/// What the independent check found, for people.
std::string verification_table(const Verification& verification, const Problem& problem,
                               const Paint& paint);

/// "passed", "FAILED" or "not run".
std::string checked_text(const Verification& verification, const Paint& paint);

}  // namespace wristwise::app
