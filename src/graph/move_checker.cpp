#include "graph/move_checker.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "wristwise/swept_clearance.hpp"

namespace wristwise {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 3> kStraySamples = {0.25, 0.5, 0.75};

}  // namespace

MoveChecker::MoveChecker(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
                         const Limits& limits, double epsilon, int threads)
    : robot_(clearance->robot()),
      limits_(limits),
      required_(clearance->clearance()),
      epsilon_(epsilon) {
  for (int i = 0; i < threads; ++i)
    workers_.push_back({ClearanceChecker(clearance), 0, {}, -1, 0.5});
  near_pairs_.assign(task.waypoints.size(), -1);
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    stretches_.push_back(stretch(task, i));
  }
}

bool MoveChecker::Limits::steps() const { return tcp_step < kInfinity || tcp_turn < kInfinity; }
bool MoveChecker::Limits::strays() const { return stray < kInfinity; }

MoveChecker::Stretch MoveChecker::stretch(const Task& task, std::size_t interval) {
  const auto tolerance = task.tolerance_between(interval);
  if (!tolerance) return {};
  Stretch stretch{*tolerance, {}};
  const double t0 = task.waypoints[interval].time, t1 = task.waypoints[interval + 1].time;
  for (const double s : kStraySamples) {
    stretch.frames.push_back(task.seam.frame_at(t0 + s * (t1 - t0)));
  }
  return stretch;
}

bool MoveChecker::is_clear(int worker, std::size_t interval, const JointVector& from,
                           const JointVector& to) {
  if (limits_.stray < kInfinity && stray(interval, from, to) > limits_.stray) return false;
  Worker& own = workers_[static_cast<std::size_t>(worker)];
  if (own.checker.model().pairs().empty()) return true;
  if (is_blocked_as_before(own, interval, from, to)) return false;
  const SweptClearance swept =
      check_motion(own.checker, StraightMove(from, to), required_, epsilon_);
  if (!swept.clear) {
    own.interval = interval;
    own.to = to;
    own.pair = swept.pair;
    own.s = swept.s;
  }
  return swept.clear;
}

bool MoveChecker::steps_too_far(const JointVector& from, const JointVector& to) const {
  if (limits_.tcp_step == kInfinity && limits_.tcp_turn == kInfinity) return false;
  const Pose step = tcp_pose(robot_, from).inverse() * tcp_pose(robot_, to);
  return step.translation().norm() > limits_.tcp_step ||
         Eigen::AngleAxisd(step.linear()).angle() > limits_.tcp_turn;
}

/// Postures that are too near are mostly so for the same pair.
bool MoveChecker::has_clearance(int worker, std::size_t waypoint, const JointVector& q) {
  Worker& own = workers_[static_cast<std::size_t>(worker)];
  if (own.checker.model().pairs().empty()) return true;
  own.checker.set_posture(q);
  int& pair = near_pairs_[waypoint];
  if (pair >= 0 && own.checker.lower_bound(pair) < required_ &&
      own.checker.distance(pair).distance < required_) {
    return false;
  }
  const auto hit = own.checker.first_below(required_);
  if (hit) pair = hit->pair;
  return !hit;
}

double MoveChecker::stray(std::size_t interval, const JointVector& from,
                          const JointVector& to) const {
  double largest = 0;
  const Stretch& stretch = stretches_[interval];
  for (std::size_t k = 0; k < stretch.frames.size(); ++k) {
    const Pose tcp = tcp_pose(robot_, from + kStraySamples[k] * (to - from));
    const Vector6 e = deviation(stretch.tolerance, stretch.frames[k], tcp);
    largest = std::max(largest, box_excess(stretch.tolerance, e).head<3>().norm());
  }
  return largest;
}

/// Moves to the same posture are mostly blocked by the same pair at about the same
/// place. A distance below required - epsilon rules out that check_motion could show the move to be
/// clear, so this is a short cut to the same answer.
bool MoveChecker::is_blocked_as_before(Worker& worker, std::size_t interval,
                                       const JointVector& from, const JointVector& to) const {
  if (worker.pair < 0 || worker.interval != interval || worker.to != to) return false;
  worker.checker.set_posture(from + worker.s * (to - from));
  const double limit = required_ - epsilon_;
  return worker.checker.lower_bound(worker.pair) < limit &&
         worker.checker.distance(worker.pair).distance < limit;
}

std::size_t MoveChecker::queries() const {
  std::size_t sum = 0;
  for (const Worker& worker : workers_) sum += worker.checker.queries();
  return sum;
}

}  // namespace wristwise
