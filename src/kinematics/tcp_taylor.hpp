#pragma once

#include "task/motion_piece.hpp"
#include "task/taylor.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// A pose over an interval, enclosed: position (m) and the axes of the frame, in the base frame.
struct PoseTaylor {
  VectorTaylor position;
  std::array<VectorTaylor, 3> axes;  ///< only those that were asked for
};

/// The TCP while the joints follow the polynomials (F29).
PoseTaylor tcp_taylor(const Robot& robot, const MotionPiece::Polynomials& joints,
                      const std::array<bool, 3>& axes);

}  // namespace wristwise
