#include "verify/checked_motion.hpp"

namespace wristwise {

namespace {

void raise(RatePeak& peak, const JointVector& magnitude, const JointVector& limit, double time) {
  for (int j = 0; j < magnitude.size(); ++j) {
    const double ratio = magnitude[j] / limit[j];
    if (ratio > peak.ratio) peak = {ratio, j, time};
  }
}

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

MotionPiece PointMotion::piece(std::size_t i) const {
  return {path_.times[i], path_.times[i + 1], path_.positions[i], path_.positions[i + 1]};
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

MotionPiece CurveMotion::piece(std::size_t i) const {
  return {times()[i], times()[i + 1], trajectory_.polynomials(i)};
}

}  // namespace wristwise
