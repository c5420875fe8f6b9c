#pragma once

#include "task/taylor.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// The path frame over an interval of time that lies on one piece of the seam, enclosed (F29).
/// Every piece turns about one fixed axis while it runs along a line or about a fixed center.
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
  Eigen::AngleAxisd turn_;  ///< of the whole piece, base frame
  TaylorTurn back_;
};

/// Times strictly inside (t0, t1) where the seam goes from one piece to the next, and its own ends.
std::vector<double> seam_breaks(const Seam& seam, double t0, double t1);

}  // namespace wristwise
