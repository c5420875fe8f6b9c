#pragma once

#include <array>
#include <utility>
#include <vector>

#include "task/motion_piece.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

struct DeviationGoal {
  double position_epsilon = 1e-6;  ///< m, beyond the box; what is smaller is not looked for
  double angle_epsilon = 1e-6;     ///< rad, likewise
  /// Errors (m, rad) that are known to occur: bounds are made tighter until they are within 2% of
  /// the largest that is known. Infinite: bounds are not needed.
  double known_distance = 0, known_angle = 0;
};

/// How a motion keeps to the seam and to a box over an interval of time.
struct DeviationFinding {
  using Range = std::pair<double, double>;

  std::vector<Range> not_shown;  ///< s; everywhere else the box holds to within epsilon, for all t
  Vector6 excess = Vector6::Zero();  ///< the largest beyond the box that was sampled, m and rad;
                                     ///< within 2%, or epsilon, of the largest there is
  std::array<double, 6> time{};      ///< s, of each
  double distance = 0;               ///< m: for all t the TCP is no farther from the nominal TCP
  double angle = 0;                  ///< rad, likewise of every angle that is not free
  std::size_t samples = 0;           ///< postures looked at
};

/// Shows for all t in [t0, t1] that a motion is inside a box about the seam, or finds where it is
/// not: by bisection, until the enclosure of an interval (F30) is inside. Moves between joint
/// waypoints, where no path is prescribed, are passed over.
/// @param goal its known errors are raised to what is found
DeviationFinding search_deviation(const Robot& robot, const MotionPiece& motion, double t0,
                                  double t1, const Seam& seam, const ToleranceBox& box,
                                  DeviationGoal& goal);

}  // namespace wristwise
