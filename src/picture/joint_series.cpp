#include "picture/joint_series.hpp"

#include <algorithm>

namespace wristwise {

namespace {

constexpr int kJerk = 3;
constexpr double kBesideKnot = 1e-6;  // of a piece, where the jerk has the piece's own value

JointSeries series_of_curve(const Trajectory& curve, int derivative, std::size_t aim) {
  JointSeries series;
  const auto& times = curve.times();
  const std::size_t parts = std::max<std::size_t>(2, aim / (times.size() - 1) + 1);
  const auto add = [&](double t, double at) {
    series.times.push_back(t);
    series.values.push_back(curve.evaluate(at, derivative));
  };
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double length = times[i + 1] - times[i];
    add(times[i], derivative == kJerk ? times[i] + kBesideKnot * length : times[i]);
    for (std::size_t k = 1; k < parts; ++k) {
      const double t = times[i] + length * static_cast<double>(k) / static_cast<double>(parts);
      add(t, t);
    }
    if (derivative == kJerk) add(times[i + 1], times[i + 1] - kBesideKnot * length);
  }
  if (derivative != kJerk) add(times.back(), times.back());
  return series;
}

JointSeries series_of_points(const JointPath& path, int derivative) {
  if (derivative == 0) return {path.times, path.positions};
  JointSeries series;
  const auto order = static_cast<std::size_t>(derivative);
  if (path.size() <= order) return series;
  series.values = divided_differences(path, derivative);
  for (std::size_t i = 0; i < series.values.size(); ++i)
    series.times.push_back(0.5 * (path.times[i] + path.times[i + order]));
  return series;
}

}  // namespace

TimeSeries JointSeries::joint(int j, double factor) const {
  TimeSeries series{times, {}};
  for (const JointVector& value : values) series.values.push_back(factor * value[j]);
  return series;
}

JointSeries joint_series(const ShownMotion& motion, int derivative, std::size_t aim) {
  if (motion.trajectory.empty()) return series_of_points(motion.path, derivative);
  return series_of_curve(motion.trajectory, derivative, aim);
}

}  // namespace wristwise
