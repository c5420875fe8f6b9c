#include "import/unit_quaternion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

Eigen::Quaterniond unit_quaternion(double w, double x, double y, double z,
                                   const std::string& where) {
  constexpr double kUnitTolerance = 1e-3;  // of the norm
  const Eigen::Quaterniond quaternion(w, x, y, z);
  if (!(std::abs(quaternion.norm() - 1) <= kUnitTolerance))
    throw InvalidInput(where, fmt::format("the quaternion has the norm {:.6g}", quaternion.norm()),
                       "1");
  return quaternion.normalized();
}

}  // namespace wristwise
