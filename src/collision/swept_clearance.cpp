#include "wristwise/swept_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "wristwise/error.hpp"

namespace wristwise {

JointVector StraightMove::posture(double s) const { return from_ + s * (to_ - from_); }

JointVector StraightMove::spread(double s0, double s1) const {
  return std::abs(s1 - s0) / 2 * (to_ - from_).cwiseAbs();
}

namespace {

constexpr double kMeasuringError = 1e-6;  // m, granted to a measured distance
constexpr std::size_t kMaxPostures = std::size_t{1} << 22;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A part of the motion with the pairs that are not settled on it, a range of a list of pairs.
struct Interval {
  double s0, s1;
  std::size_t first_open, end_open;
};

// (F10) Over [s0, s1] a pair keeps to
//   d(q(s)) >= d(q(mid)) - sum_j r_j |q_j(s) - q_j(mid)| >= d(q(mid)) - sum_j r_j spread_j,
// r from (F9). Where that is not enough the interval is halved, for the pairs still open. As the
// distance at a sample is >= required - 1e-6, an interval is settled at the latest when its spread
// amounts to epsilon - 1e-6, so that the bisection ends.
class MotionCheck {
 public:
  MotionCheck(ClearanceChecker& checker, const Motion& motion, double required, double epsilon)
      : checker_(checker), motion_(motion), required_(required), epsilon_(epsilon) {
    result_.bound = kInfinity;
  }

  SweptClearance run() {
    if (!end_is_clear(0) || !end_is_clear(1)) return result_;
    std::vector<int> open(checker_.model().pairs().size());
    std::iota(open.begin(), open.end(), 0);
    std::vector<Interval> intervals{{0, 1, 0, open.size()}};
    while (!intervals.empty()) {
      std::vector<Interval> halves;
      std::vector<int> still_open;
      for (const Interval& interval : intervals) {
        const std::size_t first = still_open.size();
        if (!settle(interval, open, still_open)) return result_;
        if (still_open.size() == first) continue;
        const double middle = (interval.s0 + interval.s1) / 2;
        halves.push_back({interval.s0, middle, first, still_open.size()});
        halves.push_back({middle, interval.s1, first, still_open.size()});
      }
      intervals.swap(halves);
      open.swap(still_open);
    }
    result_.clear = true;
    return result_;
  }

 private:
  bool end_is_clear(double s) {
    sample(s);
    if (!checker_.first_below(required_ - kMeasuringError)) return true;
    report_nearest(s);
    return false;
  }

  void sample(double s) {
    if (++result_.postures > kMaxPostures) {
      throw InvalidInput("motion",
                         "not settled after " + std::to_string(kMaxPostures) + " postures",
                         "a spread that tends to zero with the interval, or a larger epsilon");
    }
    checker_.set_posture(motion_.posture(s));
  }

  /// False where a pair is too near at the middle of the interval; the result then says so.
  bool settle(const Interval& interval, const std::vector<int>& open,
              std::vector<int>& still_open) {
    const double middle = (interval.s0 + interval.s1) / 2;
    const JointVector spread = motion_.spread(interval.s0, interval.s1);
    if (spread.size() != checker_.model().robot().joint_count() || !spread.allFinite()) {
      throw InvalidInput("motion", "unusable spread", "a finite bound for each joint");
    }
    sample(middle);
    for (std::size_t i = interval.first_open; i < interval.end_open; ++i) {
      const int pair = open[i];
      const double stray = checker_.model().motion_radius(pair).dot(spread);
      const double enough = std::max(required_ - epsilon_ + stray, required_ - kMeasuringError);
      double distance = checker_.lower_bound(pair);
      if (!(distance >= enough)) distance = checker_.distance(pair).distance;
      if (!(distance >= required_ - kMeasuringError)) {
        report_nearest(middle);
        return false;
      }
      if (distance >= enough) {
        result_.bound = std::min(result_.bound, distance - stray);
      } else {
        still_open.push_back(pair);
      }
    }
    return true;
  }

  void report_nearest(double s) {
    const PairDistance nearest = checker_.nearest().value_or(PairDistance{});
    result_.pair = nearest.pair;
    result_.distance = nearest.distance;
    result_.s = s;
    result_.bound = -kInfinity;
  }

  ClearanceChecker& checker_;
  const Motion& motion_;
  double required_;
  double epsilon_;
  SweptClearance result_;
};

}  // namespace

SweptClearance check_motion(ClearanceChecker& checker, const Motion& motion, double required,
                            double epsilon) {
  if (!std::isfinite(required)) {
    throw InvalidInput("required clearance", "it is " + std::to_string(required),
                       "a finite length in m");
  }
  if (!(epsilon > kMeasuringError) || !std::isfinite(epsilon)) {
    throw InvalidInput("epsilon of the swept clearance", "it is " + std::to_string(epsilon),
                       "a length above 1e-6 m");
  }
  return MotionCheck(checker, motion, required, epsilon).run();
}

}  // namespace wristwise
