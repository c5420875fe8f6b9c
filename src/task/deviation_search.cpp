#include "task/deviation_search.hpp"

#include <algorithm>
#include <cmath>

#include "task/deviation_enclosure.hpp"
#include "task/frame_taylor.hpp"

namespace wristwise {

namespace {

constexpr double kResolution = 1.02;  // bounds and what is found agree to this factor
constexpr int kDeepest = 40;          // halvings, of what can't be shown
constexpr std::size_t kMostSamples = 4096;
constexpr int kDeepestForBounds = 6;  // halvings, for tighter bounds alone

class Search {
 public:
  Search(const Robot& robot, const MotionPiece& motion, const Seam& seam, const ToleranceBox& box,
         DeviationGoal& goal)
      : robot_(robot), motion_(motion), seam_(seam), box_(box), goal_(goal) {}

  DeviationFinding run(double start, double end) {
    double t0 = start;
    for (const double t1 : seam_breaks(seam_, start, end)) {
      run_part(t0, t1);
      t0 = t1;
    }
    run_part(t0, end);
    return finding_;
  }

 private:
  void run_part(double t0, double t1) {
    if (seam_.piece_at(0.5 * (t0 + t1)).kind == SeamPiece::Kind::move) return;
    settle(t0, t1, 0);
  }

  void settle(double t0, double t1, int depth) {
    ++finding_.samples;
    const auto joints = motion_.over(t0, t1);
    const DeviationEnclosure enclosed(robot_, joints, seam_, t0, t1, box_);
    const bool shown = enclosed.inside(widened(box_, Vector6::Zero()));
    const double distance = wants_bounds() ? enclosed.distance() : 0;
    const double angle = wants_bounds() ? enclosed.angle() : 0;
    if (!shown || is_loose(distance, angle)) {
      sample(0.5 * (t0 + t1), joints.col(0));
      const bool settled = depth >= kDeepest || finding_.samples >= kMostSamples ||
                           (shown ? depth >= kDeepestForBounds || !is_loose(distance, angle)
                                  : is_no_worse(enclosed));
      if (!settled) {
        const double middle = 0.5 * (t0 + t1);
        settle(t0, middle, depth + 1);
        settle(middle, t1, depth + 1);
        return;
      }
    }
    if (!shown) add_not_shown(t0, t1);
    finding_.distance = std::max(finding_.distance, distance);
    finding_.angle = std::max(finding_.angle, angle);
  }

  bool wants_bounds() const { return std::isfinite(goal_.known_distance); }

  bool is_loose(double distance, double angle) const {
    return distance > kResolution * goal_.known_distance + goal_.position_epsilon ||
           angle > kResolution * goal_.known_angle + goal_.angle_epsilon;
  }

  /// The box, wider by epsilon or by an excess that is larger.
  ToleranceBox widened(const ToleranceBox& box, const Vector6& excess) const {
    ToleranceBox wider = box;
    for (int k = 0; k < 6; ++k) {
      const double more = std::max(excess[k], k < 3 ? goal_.position_epsilon : goal_.angle_epsilon);
      wider.lower[k] -= more;
      wider.upper[k] += more;
    }
    return wider;
  }

  /// Than what was found outside the box already.
  bool is_no_worse(const DeviationEnclosure& enclosed) const {
    return !finding_.excess.isZero(0) &&
           enclosed.inside(widened(box_, kResolution * finding_.excess));
  }

  void sample(double t, const JointVector& q) {
    const Pose frame = seam_.frame_at(t), tcp = tcp_pose(robot_, q);
    const Vector6 e = deviation(box_, frame, tcp), excess = box_excess(box_, e);
    for (int k = 0; k < 6; ++k) {
      if (excess[k] > finding_.excess[k]) {
        finding_.excess[k] = excess[k];
        finding_.time[static_cast<std::size_t>(k)] = t;
      }
      if (k >= 3 && !box_.is_free(k))
        goal_.known_angle = std::max(goal_.known_angle, std::abs(e[k]));
    }
    goal_.known_distance = std::max(goal_.known_distance, e.head<3>().norm());
  }

  void add_not_shown(double t0, double t1) {
    auto& ranges = finding_.not_shown;
    if (!ranges.empty() && ranges.back().second == t0) {
      ranges.back().second = t1;
    } else {
      ranges.push_back({t0, t1});
    }
  }

  const Robot& robot_;
  const MotionPiece& motion_;
  const Seam& seam_;
  const ToleranceBox& box_;
  DeviationGoal& goal_;
  DeviationFinding finding_;
};

}  // namespace

DeviationFinding search_deviation(const Robot& robot, const MotionPiece& motion, double t0,
                                  double t1, const Seam& seam, const ToleranceBox& box,
                                  DeviationGoal& goal) {
  return Search(robot, motion, seam, box, goal).run(t0, t1);
}

}  // namespace wristwise
