#pragma once

#include <vector>

#include "task/enclosed_curve.hpp"
#include "task/taylor.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// The path frame over an interval of time that lies on one piece of the seam and between two knots
/// of its time law, enclosed (F29).
class FrameTaylor {
 public:
  FrameTaylor(const Seam& seam, double t0, double t1);

  VectorTaylor position() const;                          ///< of the frame, base frame, m
  VectorTaylor axis(int k) const;                         ///< x, y, z axis of the frame, base frame
  VectorTaylor point(const VectorTaylor& in_base) const;  ///< as seen from the frame
  VectorTaylor direction(const VectorTaylor& in_base) const;

 private:
  const SeamPiece& piece_;
  Taylor fraction_;
  EnclosedOrientation orientation_;
  TaylorTurn back_;                     ///< against orientation_.before
  std::vector<TaylorTurn> back_after_;  ///< against orientation_.after
};

/// Times strictly inside (t0, t1) where the seam goes from one piece to the next, its own ends, and
/// the knots of its time law.
std::vector<double> seam_breaks(const Seam& seam, double t0, double t1);

}  // namespace wristwise
