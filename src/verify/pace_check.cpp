#include "verify/pace_check.hpp"

#include <algorithm>

#include "verify/failure_text.hpp"

namespace wristwise {

namespace {

constexpr double kRateTolerance = 1e-6;  // of the weld speed
constexpr double kRunsBack = 1e-7;       // rate below zero, for round-off
constexpr double kTimeTolerance = 1e-9;  // s
constexpr double kRestTolerance = 1e-6;  // rad/s or m/s, and by s
constexpr int kSamples = 10;             // of the least rate, between two knots of the law

struct Worst {
  double excess = 0, time = 0, rate = 0;

  void raise(double new_excess, double at, double its_rate) {
    if (new_excess > excess) *this = {new_excess, at, its_rate};
  }
};

/// Exact: the largest rate of each piece.
Worst fastest(const Trajectory& law) {
  Worst worst;
  for (std::size_t i = 0; i + 1 < law.times().size(); ++i) {
    JointVector least, largest;
    law.extremes(i, 1, least, largest);
    worst.raise(largest[0] - 1, law.times()[i], largest[0]);
  }
  return worst;
}

/// How far above the prescribed rate where that is least: at the corners.
Worst fastest_at_corners(const Seam& prescribed, const Seam& run) {
  Worst worst;
  if (!prescribed.is_retimed()) return worst;
  const Trajectory& law = prescribed.seam_time();
  const auto rate_at = [&law](std::size_t knot) { return law.velocities()[knot][0]; };
  for (std::size_t i = 1; i + 1 < law.times().size(); ++i) {
    if (rate_at(i) >= 1 || rate_at(i) > std::min(rate_at(i - 1), rate_at(i + 1))) continue;
    const double t = run.real_time(law.positions()[i][0]);
    worst.raise(run.speed_ratio(t) - rate_at(i), t, run.speed_ratio(t));
  }
  return worst;
}

/// How far below the prescribed rate at the same place of the seam.
Worst slowest(const Task& prescribed, const Task& run) {
  Worst worst;
  const Seam& seam = run.seam;
  const std::vector<double>& times = seam.seam_time().times();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    for (int k = 0; k <= kSamples; ++k) {
      const double t = times[i] + k * (times[i + 1] - times[i]) / kSamples;
      if (t < run.weld_start() || t > run.weld_end()) continue;
      const double there = prescribed.seam.real_time(seam.nominal_time(t));
      const double rate = seam.speed_ratio(t);
      worst.raise(prescribed.seam.speed_ratio(there) - rate, t, rate);
    }
  }
  return worst;
}

}  // namespace

std::vector<std::string> law_failures(const Task& task, const Trajectory& seam_time) {
  const auto& pieces = task.seam.pieces();
  const double start = pieces.front().start_time, end = pieces.back().end_time;
  const double first = seam_time.positions().front()[0], last = seam_time.positions().back()[0];
  std::vector<std::string> failures;
  if (first > start + kTimeTolerance || last < end - kTimeTolerance)
    failures.push_back(text::seam_time_coverage(first, last, start, end));
  for (std::size_t i = 0; i + 1 < seam_time.times().size(); ++i) {
    JointVector least, largest;
    seam_time.extremes(i, 1, least, largest);
    if (least[0] >= -kRunsBack) continue;
    failures.push_back(text::seam_time_decreases(seam_time.times()[i], least[0]));
    break;
  }
  return failures;
}

std::vector<std::string> pace_failures(const Task& prescribed, const Task& run) {
  std::vector<std::string> failures;
  const Worst fast = fastest(run.seam.seam_time());
  if (fast.excess > kRateTolerance) failures.push_back(text::too_fast(fast.time, fast.rate));
  const Worst corner = fastest_at_corners(prescribed.seam, run.seam);
  if (corner.excess > kRateTolerance)
    failures.push_back(text::off_pace(corner.time, corner.rate, corner.rate - corner.excess));
  if (prescribed.speed_policy == SpeedPolicy::slow) return failures;
  const Worst slow = slowest(prescribed, run);
  if (slow.excess > kRateTolerance)
    failures.push_back(text::off_pace(slow.time, slow.rate, slow.rate + slow.excess));
  return failures;
}

std::vector<std::string> rest_failures(const Task& task, const Robot& robot,
                                       const Trajectory& trajectory) {
  std::vector<std::string> failures;
  const auto check = [&](double time) {
    for (int derivative = 1; derivative <= 2; ++derivative) {
      int joint = 0;
      const double rate = trajectory.evaluate(time, derivative).cwiseAbs().maxCoeff(&joint);
      if (rate > kRestTolerance)
        failures.push_back(text::not_at_rest(
            derivative, robot.joints()[static_cast<std::size_t>(joint)].name, time, rate));
    }
  };
  if (task.rest_at_start) check(trajectory.times().front());
  if (task.rest_at_end) check(trajectory.times().back());
  return failures;
}

}  // namespace wristwise
