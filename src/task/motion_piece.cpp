#include "task/motion_piece.hpp"

#include <cmath>

#include "task/shifted_polynomial.hpp"

namespace wristwise {

MotionPiece::MotionPiece(double start, double end, const Polynomials& over_all)
    : start_(start), end_(end), over_all_(over_all) {}

MotionPiece::MotionPiece(double start, double end, const JointVector& from, const JointVector& to)
    : start_(start), end_(end), over_all_(Polynomials::Zero(from.size(), 6)) {
  over_all_.col(0) = 0.5 * (from + to);
  over_all_.col(1) = 0.5 * (to - from);
}

// p(m + w s): shifted to m, then w^k into the k-th coefficient.
MotionPiece::Polynomials MotionPiece::over(double t0, double t1) const {
  const double length = end_ - start_;
  const double middle = ((t0 - start_) + (t1 - end_)) / length;
  const double width = (t1 - t0) / length;
  Polynomials c = shifted(over_all_, middle);
  double power = 1;
  for (int k = 1; k < 6; ++k) c.col(k) *= power *= width;
  return c;
}

// The fourth Taylor coefficient at s is c_4 + 5 c_5 s.
Taylor polynomial_taylor(const MotionPiece::Polynomials& motion, int joint) {
  return {{motion(joint, 0), motion(joint, 1), motion(joint, 2), motion(joint, 3)},
          std::abs(motion(joint, 4)) + 5 * std::abs(motion(joint, 5))};
}

// (F10) |s| <= 1.
JointVector spread(const MotionPiece::Polynomials& motion) {
  return motion.rightCols<5>().cwiseAbs().rowwise().sum();
}

}  // namespace wristwise
