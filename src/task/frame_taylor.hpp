#pragma once

#include <vector>

#include "task/taylor.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// The path frame over an interval of real time that no seam_breaks cut, enclosed (F29). Lines and
/// arcs turn about one fixed axis while they run along a line or about a fixed center. The course
/// of a curve is known at single times only: it is taken from samples.
class FrameTaylor {
 public:
  FrameTaylor(const Seam& seam, double t0, double t1);

  const VectorTaylor& position() const { return position_; }  ///< of the frame, base frame, m
  VectorTaylor axis(int k) const;                             ///< x, y, z axis, base frame
  VectorTaylor point(const VectorTaylor& in_base) const;      ///< as seen from the frame
  VectorTaylor direction(const VectorTaylor& in_base) const;

 private:
  void sample(const Seam& seam, double t0, double t1);

  const SeamPiece& piece_;
  Taylor fraction_;
  Eigen::AngleAxisd turn_;  ///< of the whole piece, base frame
  TaylorTurn back_;
  VectorTaylor position_;
  std::array<VectorTaylor, 3> sampled_axes_;  ///< of a curve
};

/// Times strictly inside (t0, t1) where the seam goes from one piece to the next, where its time
/// law has a knot, and its own ends; in increasing order.
std::vector<double> seam_breaks(const Seam& seam, double t0, double t1);

}  // namespace wristwise
