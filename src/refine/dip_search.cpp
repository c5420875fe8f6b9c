#include "refine/dip_search.hpp"

#include <algorithm>

#include "collision/clearance_search.hpp"
#include "task/deviation_search.hpp"

namespace wristwise {

namespace {

constexpr double kEpsilon = 5e-7;  // m and rad, half of what the verification grants

/// What the pieces of a motion do between two waypoints.
class Interval {
 public:
  Interval(const Task& task, std::size_t index) : task_(task), index_(index) {
    const auto box = task.tolerance_between(index);
    if (box) box_ = box->widened(task.between_position, task.between_angle);
    goal_.position_epsilon = goal_.angle_epsilon = kEpsilon;
    goal_.known_distance = goal_.known_angle = ToleranceBox::kFree;
  }

  double start() const { return task_.waypoints[index_].time; }
  double end() const { return task_.waypoints[index_ + 1].time; }

  /// The worst of the box, where it does not hold.
  void look_along(const Robot& robot, const MotionPiece& piece, std::optional<Dip>& worst) {
    if (!box_) return;
    const DeviationFinding found =
        search_deviation(robot, piece, piece.start(), piece.end(), task_.seam, *box_, goal_);
    if (found.not_shown.empty()) return;
    int coordinate = 0;
    const double depth = found.excess.maxCoeff(&coordinate);
    if (worst && depth <= worst->depth) return;
    const auto [from, to] = found.not_shown.front();
    const double time =
        depth > 0 ? found.time[static_cast<std::size_t>(coordinate)] : 0.5 * (from + to);
    worst = Dip{index_, time, depth};
  }

 private:
  const Task& task_;
  std::size_t index_;
  std::optional<ToleranceBox> box_;
  DeviationGoal goal_;
};

}  // namespace

std::vector<Dip> find_dips(const Task& task, const Spline& spline, ClearanceChecker& checker,
                           double required, double resolution) {
  const Trajectory curve = spline.sampled_at(spline.basis.breakpoints());
  const std::vector<double>& times = curve.times();
  ClearanceSearch search(checker, resolution);
  std::vector<Dip> dips;
  std::size_t piece = 0;
  for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
    Interval interval(task, i);
    std::optional<Dip> off_the_box;
    ClearanceFinding nearest;
    nearest.least = required;
    for (double t = interval.start(); t < interval.end();) {
      while (piece + 2 < times.size() && times[piece + 1] <= t) ++piece;
      const bool is_last = piece + 2 == times.size();
      const double end = is_last ? interval.end() : std::min(interval.end(), times[piece + 1]);
      const MotionPiece whole(times[piece], times[piece + 1], curve.polynomials(piece));
      const MotionPiece part(t, end, whole.over(t, end));
      interval.look_along(checker.model().robot(), part, off_the_box);
      search.look_along(part, nearest);
      t = end;
    }
    if (off_the_box) dips.push_back(*off_the_box);
    if (nearest.pair >= 0) dips.push_back({i, nearest.time, required - nearest.least});
  }
  return dips;
}

}  // namespace wristwise
