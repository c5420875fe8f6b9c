#include "verify/checked_motion.hpp"

#include <algorithm>
#include <cmath>

namespace wristwise {

namespace {

void raise(RatePeak& peak, const JointVector& magnitude, const JointVector& limit, double time) {
  for (int j = 0; j < magnitude.size(); ++j) {
    const double ratio = magnitude[j] / limit[j];
    if (ratio > peak.ratio) peak = {ratio, j, time};
  }
}

/// One piece of a curve, over s in [0, 1].
class CurvePiece final : public Motion {
 public:
  CurvePiece(const Trajectory& trajectory, std::size_t piece)
      : trajectory_(trajectory), piece_(piece) {}
  JointVector posture(double s) const override { return trajectory_.evaluate(time(s)); }
  JointVector spread(double s0, double s1) const override {
    return trajectory_.spread(piece_, time(s0), time(s1));
  }

 private:
  double time(double s) const {
    const auto& times = trajectory_.times();
    return times[piece_] + s * (times[piece_ + 1] - times[piece_]);
  }
  const Trajectory& trajectory_;
  std::size_t piece_;
};

}  // namespace

JointVector PointMotion::posture(std::size_t i, double t) const {
  if (i + 1 >= path_.size()) return path_.positions[i];
  const double s = (t - path_.times[i]) / (path_.times[i + 1] - path_.times[i]);
  return (1 - s) * path_.positions[i] + s * path_.positions[i + 1];
}

void PointMotion::extremes(std::size_t i, JointVector& least, JointVector& largest) const {
  least = path_.positions[i].cwiseMin(path_.positions[i + 1]);
  largest = path_.positions[i].cwiseMax(path_.positions[i + 1]);
}

RatePeak PointMotion::rate_peak(int derivative, const JointVector& limit) const {
  RatePeak peak;
  const auto differences = divided_differences(path_, derivative);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    raise(peak, differences[i].cwiseAbs(), limit,
          0.5 * (path_.times[i] + path_.times[i + static_cast<std::size_t>(derivative)]));
  }
  return peak;
}

std::unique_ptr<Motion> PointMotion::stretch(std::size_t i) const {
  return std::make_unique<StraightMove>(path_.positions[i], path_.positions[i + 1]);
}

void CurveMotion::extremes(std::size_t i, JointVector& least, JointVector& largest) const {
  trajectory_.extremes(i, 0, least, largest);
}

RatePeak CurveMotion::rate_peak(int derivative, const JointVector& limit) const {
  RatePeak peak;
  for (std::size_t i = 0; i + 1 < times().size(); ++i) {
    JointVector least, largest;
    trajectory_.extremes(i, derivative, least, largest);
    raise(peak, largest.cwiseMax(-least), limit, 0.5 * (times()[i] + times()[i + 1]));
  }
  return peak;
}

std::unique_ptr<Motion> CurveMotion::stretch(std::size_t i) const {
  return std::make_unique<CurvePiece>(trajectory_, i);
}

}  // namespace wristwise
