#pragma once

#include <memory>

#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {

/// As find_inverse_kinematics, but a closed form or nothing: null, with what is in the way.
InverseKinematicsFound find_closed_form(const std::shared_ptr<const Robot>& robot,
                                        double misfit = 1e-3);

}  // namespace wristwise
