#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "wristwise/joints.hpp"

namespace wristwise {

/// What a step between two configurations costs (F17):
///   sum_j weight_j s_j   (eq. 4 of De Maeyer et al., ETFA 2017), or   sum_j weight_j s_j^2,
/// with s_j = |q_v,j - q_u,j| or, where joint j has a period, the shorter way round.
struct JointMetric {
  JointVector weight;  ///< >= 0
  JointVector period;  ///< rad; infinity: none. Values of such a joint lie in [-period/2, period/2]
  bool squared = false;

  int joints() const { return static_cast<int>(weight.size()); }

  double step(int joint, double from, double to) const {
    const double straight = std::abs(to - from);
    return std::min(straight, period[joint] - straight);
  }

  double cost(const double* from, const double* to) const {
    double sum = 0;
    for (int j = 0; j < joints(); ++j) {
      const double s = step(j, from[j], to[j]);
      sum += weight[j] * (squared ? s * s : s);
    }
    return sum;
  }
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace wristwise
