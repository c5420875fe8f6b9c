#include "task/stretches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "task/pose_difference.hpp"
#include "wristwise/error.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {

namespace {

constexpr double kJoinTolerance = 1e-6;  // m
constexpr double kLeastLength = 1e-9;    // m, of a stretch
constexpr double kLeastTime = 1e-9;      // s, of a move
constexpr double kLeastTurn = 1e-9;      // rad, of a stretch that turns on the spot in a given time

[[noreturn]] void fail_repeated(const std::string& where, const std::string& expected) {
  throw InvalidInput(where, "repeated waypoint", expected);
}

class Layout {
 public:
  explicit Layout(const Robot& robot) : robot_(robot) {}

  void begin_segment(const Segment& segment) {
    segment_where_ = segment.where;
    ++segments_;
  }

  void operator()(const LineSegment& line) {
    arrive(line.from, segment_where_);
    if ((line.to.translation() - line.from.translation()).norm() < kLeastLength)
      fail_repeated(segment_where_, "`from` and `to` at different places");
    add_line(line.to, std::nullopt, segment_where_);
  }

  void operator()(const ArcSegment& arc) {
    arrive(arc.from, segment_where_);
    if (arc.axis.norm() < kLeastLength)
      throw InvalidInput(segment_where_, "axis is zero", "a direction");
    Stretch stretch = next_stretch(SeamPiece::Kind::arc, segment_where_);
    SeamPiece& piece = stretch.piece;
    piece.center = arc.center;
    piece.axis = arc.axis.normalized();
    piece.angle = arc.angle;
    const Eigen::AngleAxisd turn(arc.angle, piece.axis);
    piece.to =
        Eigen::Translation3d(arc.center) * turn * Eigen::Translation3d(-arc.center) * arc.from;
    if (piece.axis.cross(arc.from.translation() - arc.center).norm() < kLeastLength)
      throw InvalidInput(segment_where_, "the radius is zero",
                         "`from` at a distance from the axis through `center`");
    if (piece.length() < kLeastLength) fail_repeated(segment_where_, "an angle other than zero");
    add(std::move(stretch));
  }

  void operator()(const PoseListSegment& list) {
    const bool timed = !list.times.empty();
    if (list.poses.empty()) throw InvalidInput(segment_where_, "no poses", "at least one");
    if (timed && !started_) result_.start_time = list.times.front();
    arrive(list.poses.front(), list.where.front());
    for (std::size_t i = 1; i < list.poses.size(); ++i) {
      const Pose& from = list.poses[i - 1];
      const Pose& to = list.poses[i];
      const bool moves = (to.translation() - from.translation()).norm() >= kLeastLength;
      const bool turns = timed && turn_between(from, to) >= kLeastTurn;
      if (!moves && !turns)
        fail_repeated(list.where[i], timed ? "a pose other than the one before"
                                           : "another position, or a time column for a turn on "
                                             "the spot");
      if (timed && list.times[i] <= list.times[i - 1])
        throw InvalidInput(list.where[i], "time does not increase");
      std::optional<double> duration;
      if (timed) duration = list.times[i] - list.times[i - 1];
      add_line(to, duration, list.where[i]);
    }
  }

  void operator()(const JointListSegment& list) {
    if (list.postures.empty())
      throw InvalidInput(segment_where_, "no joint waypoints", "at least one");
    for (std::size_t i = 0; i < list.postures.size(); ++i) {
      arrive_at_posture(cut_to_limits(robot_, list.postures[i], list.where[i]), list.where[i]);
    }
  }

  Stretches take() { return std::move(result_); }

 private:
  /// The path comes to the first pose of a segment.
  void arrive(const Pose& pose, const std::string& where) {
    if (!started_) {
      result_.start = pose;
    } else if (joints_) {
      move_to(pose, std::nullopt, where);
    } else {
      const double gap = (pose.translation() - pose_.translation()).norm();
      if (gap > kJoinTolerance)
        throw InvalidInput(where,
                           fmt::format("starts {:.6g} m from the end of the segment before", gap),
                           "segments that join");
    }
    started_ = true;
    pose_ = pose;
    joints_.reset();
  }

  void arrive_at_posture(const JointBox& posture, const std::string& where) {
    const Pose pose = tcp_pose(robot_, posture.nominal());
    if (started_) {
      move_to(pose, posture, where);
    } else {
      result_.start = pose;
      result_.start_joints = posture;
    }
    started_ = true;
    pose_ = pose;
    joints_ = posture;
  }

  void move_to(const Pose& pose, const std::optional<JointBox>& posture, const std::string& where) {
    Stretch stretch = next_stretch(SeamPiece::Kind::move, where);
    stretch.piece.to = pose;
    stretch.end_joints = posture;
    if (joints_ && posture)
      stretch.least_duration = ((posture->nominal() - joints_->nominal()).array().abs() /
                                robot_.velocity_limits().array())
                                   .maxCoeff();
    if (stretch.piece.length() < kLeastLength && stretch.least_duration < kLeastTime)
      fail_repeated(where,
                    "a joint waypoint away from the one before, so that the move takes time");
    add(std::move(stretch));
  }

  void add_line(const Pose& to, std::optional<double> duration, const std::string& where) {
    Stretch stretch = next_stretch(SeamPiece::Kind::line, where);
    stretch.piece.to = to;
    stretch.duration = duration;
    add(std::move(stretch));
  }

  Stretch next_stretch(SeamPiece::Kind kind, const std::string& where) const {
    Stretch stretch;
    stretch.piece.kind = kind;
    stretch.piece.from = pose_;
    stretch.segment = segments_ - 1;
    stretch.where = where;
    return stretch;
  }

  void add(Stretch stretch) {
    pose_ = stretch.piece.to;
    result_.stretches.push_back(std::move(stretch));
  }

  const Robot& robot_;
  Stretches result_;
  std::string segment_where_;
  std::size_t segments_ = 0;  // begun so far
  bool started_ = false;
  Pose pose_ = Pose::Identity();    // where the path has come to
  std::optional<JointBox> joints_;  // and in which posture, where it is given
};

}  // namespace

Stretches lay_out(const Robot& robot, const std::vector<Segment>& segments) {
  Layout layout(robot);
  for (const Segment& segment : segments) {
    layout.begin_segment(segment);
    std::visit(layout, segment.shape);
  }
  return layout.take();
}

double nominal_duration(const Stretch& stretch, const SeamDescription& description) {
  if (stretch.duration) return *stretch.duration;
  if (!description.speed)
    throw InvalidInput(description.where, "missing key 'speed'",
                       "a speed, m/s, or times for every pose");
  return std::max(stretch.piece.length() / *description.speed, stretch.least_duration);
}

}  // namespace wristwise
