#pragma once

#include <vector>

#include "task/motion_piece.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise {

/// The largest |q^(k)| / limit of a motion.
struct RatePeak {
  double ratio = 0;
  int joint = -1;
  double time = 0;  ///< s
};

/// What the verification asks of a motion, whichever form it has.
class CheckedMotion {
 public:
  virtual ~CheckedMotion() = default;
  virtual bool is_curve() const = 0;
  virtual const std::vector<double>& times() const = 0;
  /// At time t of the interval between times()[i] and times()[i + 1].
  virtual JointVector posture(std::size_t i, double t) const = 0;
  virtual void extremes(std::size_t i, JointVector& least, JointVector& largest) const = 0;
  virtual RatePeak rate_peak(int derivative, const JointVector& limit) const = 0;
  /// The motion over interval i.
  virtual MotionPiece piece(std::size_t i) const = 0;
};

/// Points joined by straight joint-space moves; rates are divided differences.
class PointMotion final : public CheckedMotion {
 public:
  explicit PointMotion(const JointPath& path) : path_(path) {}
  bool is_curve() const override { return false; }
  const std::vector<double>& times() const override { return path_.times; }
  JointVector posture(std::size_t i, double t) const override;
  void extremes(std::size_t i, JointVector& least, JointVector& largest) const override;
  RatePeak rate_peak(int derivative, const JointVector& limit) const override;
  MotionPiece piece(std::size_t i) const override;

 private:
  const JointPath& path_;
};

/// A piecewise quintic; rates are its exact extremes.
class CurveMotion final : public CheckedMotion {
 public:
  explicit CurveMotion(const Trajectory& trajectory) : trajectory_(trajectory) {}
  bool is_curve() const override { return true; }
  const std::vector<double>& times() const override { return trajectory_.times(); }
  JointVector posture(std::size_t, double t) const override { return trajectory_.evaluate(t); }
  void extremes(std::size_t i, JointVector& least, JointVector& largest) const override;
  RatePeak rate_peak(int derivative, const JointVector& limit) const override;
  MotionPiece piece(std::size_t i) const override;

 private:
  const Trajectory& trajectory_;
};

}  // namespace wristwise
