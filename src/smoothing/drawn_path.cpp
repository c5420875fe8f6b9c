#include "smoothing/drawn_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "smoothing/chord_bound.hpp"
#include "task/pose_difference.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kMostLines = 4e6;
constexpr double kShortestStep = 1e-3;  ///< s between points that are added
/// In tolerances: the longest travel between points, so that the curve may have a knot as often as
/// it takes to round a corner.
constexpr double kTravel = 20;

class Drawing {
 public:
  Drawing(const Robot& robot, const JointPath& given, double position, double angle)
      : robot_(robot), given_(given), bound_(robot, given), position_(position), angle_(angle) {}

  DrawnPath draw() {
    add_point(given_.times.front(), given_.positions.front(),
              tcp_pose(robot_, given_.positions.front()));
    for (std::size_t i = 0; i + 1 < given_.size(); ++i) draw_move(i);
    result_.seam = Seam(std::move(lines_));
    return std::move(result_);
  }

 private:
  void add_point(double time, const JointVector& q, const Pose& pose) {
    result_.path.times.push_back(time);
    result_.path.positions.push_back(q);
    result_.poses.push_back(pose);
  }

  void add_line(double end_time, const Pose& from, const Pose& to) {
    SeamPiece line;
    line.from = from;
    line.to = to;
    line.start_time = lines_.empty() ? given_.times.front() : lines_.back().end_time;
    line.end_time = end_time;
    lines_.push_back(line);
  }

  /// A move is cut into lines of equal duration, and these are shared out among the points.
  void draw_move(std::size_t i) {
    const double t0 = given_.times[i], duration = given_.times[i + 1] - t0;
    const JointVector step = given_.positions[i + 1] - given_.positions[i];
    Pose from = result_.poses.back();
    const Pose end = tcp_pose(robot_, given_.positions[i + 1]);
    const double needed = bound_.pieces(step, kChordShare * position_, kChordShare * angle_);
    const double travelled = std::max((end.translation() - from.translation()).norm() / position_,
                                      turn_between(from, end) / angle_);
    const double points = std::clamp(std::ceil(std::max(needed, travelled / kTravel)), 1.0,
                                     std::max(1.0, std::floor(duration / kShortestStep)));
    const double lines_per_point = std::ceil(needed / points);
    check_count(points * lines_per_point, i);
    const auto count = static_cast<std::size_t>(points * lines_per_point);
    for (std::size_t k = 1; k <= count; ++k) {
      const bool last = k == count;
      const double fraction = static_cast<double>(k) / static_cast<double>(count);
      const double t = last ? given_.times[i + 1] : t0 + fraction * duration;
      const JointVector q = last ? given_.positions[i + 1] : given_.positions[i] + fraction * step;
      const Pose to = last ? end : tcp_pose(robot_, q);
      add_line(t, from, to);
      if (k % static_cast<std::size_t>(lines_per_point) == 0) add_point(t, q, to);
      from = to;
    }
  }

  void check_count(double more, std::size_t i) const {
    if (static_cast<double>(lines_.size()) + more <= kMostLines) return;
    throw InvalidInput(fmt::format("joint path, point {}", i),
                       "the path is too long to be kept that closely", "a larger tolerance");
  }

  const Robot& robot_;
  const JointPath& given_;
  const ChordBound bound_;
  const double position_, angle_;
  DrawnPath result_;
  std::vector<SeamPiece> lines_;
};

}  // namespace

DrawnPath draw_path(const Robot& robot, const JointPath& path, double position, double angle) {
  return Drawing(robot, path, position, angle).draw();
}

}  // namespace wristwise
