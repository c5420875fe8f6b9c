#include "wristwise/seam_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "task/checked_description.hpp"
#include "task/corners.hpp"
#include "task/seam_legs.hpp"
#include "task/seam_pace.hpp"
#include "task/seam_runs.hpp"
#include "task/stretches.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kRunPosition = 1e-3;               // m, by which the box of a run is wider
constexpr double kRunAngle = 0.017453292519943295;  // rad, likewise
constexpr int kLeastOnRun = 4;                      // intervals

bool is_given_point_by_point(const Segment& segment) {
  return std::holds_alternative<PoseListSegment>(segment.shape) ||
         std::holds_alternative<JointListSegment>(segment.shape);
}

void check_description(const SeamDescription& description) {
  const auto& [segments, speed, spacing, waypoints, corners, run_in, run_out, where] = description;
  if (segments.empty()) throw InvalidInput(where, "no segments", "at least one");
  if (speed && !(*speed > 0 && std::isfinite(*speed)))
    throw InvalidInput(where, fmt::format("speed is {}", *speed), "a positive speed, m/s");
  if (spacing && !(*spacing > 0 && std::isfinite(*spacing)))
    throw InvalidInput(where, fmt::format("spacing is {}", *spacing), "a positive length, m");
  if (waypoints && *waypoints < 2)
    throw InvalidInput(where, fmt::format("{} waypoints", *waypoints), "at least two");
  if (spacing && waypoints)
    throw InvalidInput(where, "both `spacing` and `waypoints` are given", "one of them");
  if (!spacing && !waypoints &&
      !std::all_of(segments.begin(), segments.end(), is_given_point_by_point))
    throw InvalidInput(where, "neither `spacing` nor `waypoints` is given", "one of them");
}

void check_corners(const CornerOptions& corners, const std::string& where) {
  const auto check = [&where](const char* name, double value, bool is_valid) {
    if (!is_valid || !std::isfinite(value))
      throw InvalidInput(where, fmt::format("{} of a corner is {}", name, value), "a positive one");
  };
  check("ramp time", corners.ramp_time, corners.ramp_time > 0);
  check("turn rate", corners.turn_rate, corners.turn_rate > 0);
  if (corners.kind == CornerOptions::Kind::slow)
    check("speed ratio", corners.speed_ratio, corners.speed_ratio > 0 && corners.speed_ratio < 1);
  if (corners.kind == CornerOptions::Kind::blend)
    check("distance", corners.distance, corners.distance > 0);
}

/// Builds a task from stretches; one member for each thing that is added.
class TaskBuilder {
 public:
  TaskBuilder(const SeamDescription& description, Stretches layout)
      : description_(description), layout_(std::move(layout)) {}

  Task build() {
    plan_runs();
    treat_corners(description_, layout_.stretches);
    build_seam();
    add_weld();
    if (run_in_) add_run_in();
    if (run_out_) add_run_out();
    task_.rest_at_start = run_in_.has_value();
    task_.rest_at_end = run_out_.has_value();
    return std::move(task_);
  }

 private:
  const ToleranceBox& box_of(const Stretch& stretch) const {
    return description_.segments[stretch.segment].tolerance;
  }

  SeamEnd seam_end(const Stretch& stretch, double fraction, const std::string& where) const {
    if (stretch.piece.kind == SeamPiece::Kind::move)
      throw InvalidInput(where, "the seam has a joint waypoint there",
                         "a seam that begins and ends with a path");
    return {path_point(stretch.piece, fraction),
            stretch.piece.length() / nominal_duration(stretch, description_)};
  }

  /// Before the corners are treated: they leave the ends of the seam as they are.
  void plan_runs() {
    const auto& run_in = description_.run_in;
    const auto& run_out = description_.run_out;
    if (run_in)
      run_in_ = run_piece(RunCurve::Way::in, *run_in,
                          seam_end(layout_.stretches.front(), 0, run_in->where));
    if (run_out)
      run_out_ = run_piece(RunCurve::Way::out, *run_out,
                           seam_end(layout_.stretches.back(), 1, run_out->where));
  }

  void build_seam() {
    std::vector<SeamPiece> pieces;
    std::vector<double> ends;
    double time = layout_.start_time;
    if (run_in_) {
      pieces.push_back(run_in_->piece);
      pieces.back().start_time = time - run_in_->duration;
      pieces.back().end_time = time;
    }
    for (const Stretch& stretch : layout_.stretches) {
      pieces.push_back(stretch.piece);
      pieces.back().start_time = time;
      pieces.back().end_time = time += nominal_duration(stretch, description_);
      ends.push_back(time);
    }
    if (run_out_) {
      pieces.push_back(run_out_->piece);
      pieces.back().start_time = time;
      pieces.back().end_time = time + run_out_->duration;
    }
    task_.seam = Seam(std::move(pieces));
    retime(ends);
  }

  void retime(const std::vector<double>& ends) {
    std::vector<PaceKnot> pace =
        pace_of(layout_.stretches, layout_.start_time, ends, description_.corners.ramp_time);
    if (pace.empty()) return;
    const double start = task_.seam.start_time(), end = task_.seam.end_time();
    if (run_in_) pace.insert(pace.begin(), PaceKnot{start, 1});
    if (run_out_) pace.push_back({end, 1});
    task_.seam = task_.seam.retimed(seam_time_of(pace));
  }

  void add_weld() {
    const std::size_t first = run_in_ ? 1 : 0;
    const std::vector<Leg> legs = cut_into_legs(description_, layout_.stretches, task_.seam, first);
    Waypoint first_waypoint;
    first_waypoint.time = task_.seam.real_time(layout_.start_time);
    first_waypoint.frame = layout_.start;
    first_waypoint.tolerance = description_.segments.front().tolerance;
    first_waypoint.joints = layout_.start_joints;
    task_.waypoints.push_back(std::move(first_waypoint));
    for (const Leg& leg : legs) {
      const Stretch& stretch = layout_.stretches[leg.stretch];
      cut(leg, task_.seam.pieces()[first + leg.stretch], box_of(stretch));
      if (leg.ends_stretch) task_.waypoints.back().joints = stretch.end_joints;
    }
    if (description_.spacing) {
      spacing_ = *description_.spacing;
    } else {
      double length = 0;
      for (const Stretch& stretch : layout_.stretches) length += stretch.piece.length();
      spacing_ = length / static_cast<double>(task_.waypoints.size() - 1);
    }
  }

  void cut(const Leg& leg, const SeamPiece& piece, const ToleranceBox& tolerance) {
    const double duration = piece.end_time - piece.start_time;
    const auto fraction_at = [&](double nominal) {
      return nominal == piece.end_time ? 1 : (nominal - piece.start_time) / duration;
    };
    const double first = fraction_at(leg.from), last = fraction_at(leg.to);
    for (int k = 1; k <= leg.intervals; ++k) {
      const double share = static_cast<double>(k) / leg.intervals;
      Waypoint waypoint;
      waypoint.time =
          k == leg.intervals ? leg.real_to : leg.real_from + share * (leg.real_to - leg.real_from);
      const bool is_linear = leg.is_even || k == leg.intervals;
      waypoint.frame =
          piece.frame_at(is_linear ? first + share * (last - first)
                                   : fraction_at(task_.seam.nominal_time(waypoint.time)));
      waypoint.tolerance = tolerance;
      task_.waypoints.push_back(std::move(waypoint));
    }
  }

  /// Waypoints of a run, from `first` up to but without `last`, in intervals equal in time.
  std::vector<Waypoint> run_waypoints(const SeamPiece& piece, const ToleranceBox& box, int first,
                                      int last, int intervals) const {
    std::vector<Waypoint> waypoints;
    for (int k = first; k < last; ++k) {
      const double fraction = static_cast<double>(k) / intervals;
      Waypoint waypoint;
      waypoint.time =
          task_.seam.real_time(piece.start_time + fraction * (piece.end_time - piece.start_time));
      waypoint.frame = piece.frame_at(fraction);
      waypoint.tolerance = box.widened(kRunPosition, kRunAngle);
      waypoint.sampled = box;
      waypoint.welding = false;
      waypoints.push_back(std::move(waypoint));
    }
    return waypoints;
  }

  /// The speed of a run peaks at about twice its mean.
  int run_intervals(const SeamPiece& piece) const {
    return std::max(kLeastOnRun, intervals_by_spacing(2 * piece.length(), spacing_));
  }

  void add_run_in() {
    const SeamPiece& piece = task_.seam.pieces().front();
    const int intervals = run_intervals(piece);
    const auto run =
        run_waypoints(piece, description_.segments.front().tolerance, 0, intervals, intervals);
    task_.waypoints.insert(task_.waypoints.begin(), run.begin(), run.end());
  }

  void add_run_out() {
    const SeamPiece& piece = task_.seam.pieces().back();
    const int intervals = run_intervals(piece);
    const auto run =
        run_waypoints(piece, description_.segments.back().tolerance, 1, intervals + 1, intervals);
    task_.waypoints.insert(task_.waypoints.end(), run.begin(), run.end());
  }

  const SeamDescription& description_;
  Stretches layout_;
  std::optional<RunPiece> run_in_, run_out_;
  double spacing_ = 0;  ///< m, of the waypoints of the weld
  Task task_;
};

}  // namespace

Task build_task(const Robot& robot, const SeamDescription& given) {
  const SeamDescription description = checked_description(given);
  check_description(description);
  check_corners(description.corners, description.where);
  Stretches layout = lay_out(robot, description.segments);
  if (layout.stretches.empty())
    throw InvalidInput(description.where, "the seam has only one waypoint", "at least two");
  return TaskBuilder(description, std::move(layout)).build();
}

}  // namespace wristwise
