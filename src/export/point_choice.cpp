#include "export/point_choice.hpp"

#include <algorithm>
#include <cmath>

#include "wristwise/kinematics.hpp"

namespace wristwise {

namespace {

struct Deviation {
  double position = 0, angle = 0;
};

/// A time at which the curve is looked at; `point` where a move may end there.
struct Sample {
  double time;
  bool point, kept;
  JointVector joints;
  Pose tcp;
};

double angle_between(const Pose& a, const Pose& b) {
  return Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear()));
}

class Samples {
 public:
  Samples(const Robot& robot, const Trajectory& curve, const std::vector<double>& keep, double step)
      : robot_(robot), curve_(curve) {
    std::vector<double> fixed = {curve.times().front()};
    for (const double t : keep)
      if (t > fixed.back() && t < curve.times().back()) fixed.push_back(t);
    fixed.push_back(curve.times().back());
    for (std::size_t i = 0; i + 1 < fixed.size(); ++i) add_stretch(fixed[i], fixed[i + 1], step);
    add(fixed.back(), true, true);
  }

  const std::vector<Sample>& all() const { return samples_; }

  /// Of the straight move from one sample to another.
  Deviation deviation(std::size_t from, std::size_t to) const {
    Deviation worst;
    const Sample &a = samples_[from], &b = samples_[to];
    for (std::size_t k = from + 1; k < to; ++k) {
      const double share = (samples_[k].time - a.time) / (b.time - a.time);
      const Pose tcp = tcp_pose(robot_, a.joints + share * (b.joints - a.joints));
      worst.position =
          std::max(worst.position, (tcp.translation() - samples_[k].tcp.translation()).norm());
      worst.angle = std::max(worst.angle, angle_between(tcp, samples_[k].tcp));
    }
    return worst;
  }

 private:
  /// Points every `step` or a little less, and a sample half-way between them.
  void add_stretch(double from, double to, double step) {
    const double count = std::max(1.0, std::ceil((to - from) / step - 1e-6));
    for (int k = 0; k < static_cast<int>(count); ++k) {
      add(from + (to - from) * k / count, true, k == 0);
      add(from + (to - from) * (k + 0.5) / count, false, false);
    }
  }

  void add(double t, bool point, bool kept) {
    const JointVector q = curve_.evaluate(t);
    samples_.push_back({t, point, kept, q, tcp_pose(robot_, q)});
  }

  const Robot& robot_;
  const Trajectory& curve_;
  std::vector<Sample> samples_;
};

/// The last point to which a move from `from` may go: doubled until it is too far, then halved.
std::size_t farthest(const Samples& samples, std::size_t from, const PointChoice& choice) {
  const auto& all = samples.all();
  std::size_t end = from + 1;
  while (!all[end].kept) ++end;
  const auto good = [&](std::size_t to) {
    const Deviation deviation = samples.deviation(from, to);
    return deviation.position <= choice.max_deviation &&
           deviation.angle <= choice.max_angle_deviation;
  };
  std::size_t reached = from + 2, step = 2;  // every second sample is a point
  while (reached < end && good(std::min(reached + step, end))) {
    reached = std::min(reached + step, end);
    step *= 2;
  }
  for (; step >= 2; step /= 2)
    if (reached + step <= end && good(reached + step)) reached += step;
  return reached;
}

}  // namespace

ChosenPoints choose_points(const Robot& robot, const Trajectory& curve,
                           const std::vector<double>& keep, const PointChoice& choice) {
  const Samples samples(robot, curve, keep, choice.period.value_or(choice.resolution));
  ChosenPoints chosen;
  chosen.times.push_back(samples.all().front().time);
  for (std::size_t at = 0; at + 1 < samples.all().size();) {
    const std::size_t next = choice.period ? at + 2 : farthest(samples, at, choice);
    const Deviation deviation = samples.deviation(at, next);
    chosen.deviation = std::max(chosen.deviation, deviation.position);
    chosen.angle_deviation = std::max(chosen.angle_deviation, deviation.angle);
    chosen.times.push_back(samples.all()[next].time);
    at = next;
  }
  return chosen;
}

}  // namespace wristwise
