#include <algorithm>

#include "import/program_move.hpp"
#include "io/path_section.hpp"
#include "wristwise/error.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {

namespace {

/// Makes segments of the moves of a program.
class SeamProgram {
 public:
  explicit SeamProgram(const SegmentContext& context)
      : context_(context), axes_(context.robot, context.exports.axes) {}

  std::vector<Segment> segments(const ProgramMoves& moves) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const ProgramMove& move = moves[i];
      const bool starts_lines = i + 1 < moves.size() && moves[i + 1].linear;
      if (move.linear)
        add_line(move);
      else if (starts_lines)
        start_lines(move);
      else if (move.axes)
        add_joints(move);
      else
        throw InvalidInput(move.where, "a joint move to a pose that no linear move follows",
                           "a linear move, or values of the axes");
    }
    end_lines();
    end_joints();
    return std::move(segments_);
  }

 private:
  /// Of the TCP, in the base frame.
  Pose pose_of(const ProgramMove& move) const {
    if (move.pose) return context_.part * *move.pose;
    return tcp_pose(context_.robot, axes_.joints(*move.axes, move.where));
  }

  void start_lines(const ProgramMove& move) {
    end_lines();
    end_joints();
    lines_.poses.push_back(pose_of(move));
    lines_.where.push_back(move.where);
    durations_.clear();
  }

  void add_line(const ProgramMove& move) {
    if (lines_.poses.empty())
      throw InvalidInput(move.where, "a linear move without a start", "a joint move before it");
    const Pose pose = pose_of(move);
    const double length = (pose.translation() - lines_.poses.back().translation()).norm();
    durations_.push_back(move.time    ? move.time
                         : move.speed ? std::optional<double>(length / *move.speed)
                                      : std::nullopt);
    lines_.poses.push_back(pose);
    lines_.where.push_back(move.where);
  }

  void add_joints(const ProgramMove& move) {
    end_lines();
    joints_.postures.emplace_back(axes_.joints(*move.axes, move.where));
    joints_.where.push_back(move.where);
  }

  void end_lines() {
    if (lines_.poses.empty()) return;
    set_times();
    const std::string where = lines_.where.front();
    add(std::move(lines_), where);
    lines_ = {};
  }

  /// By the speeds of the program, where the problem gives none and the program gives all.
  void set_times() {
    const bool timed = !context_.has_speed && std::all_of(durations_.begin(), durations_.end(),
                                                          [](const std::optional<double>& time) {
                                                            return time && *time > 0;
                                                          });
    if (!timed) return;
    lines_.times.push_back(0);
    for (const std::optional<double>& time : durations_)
      lines_.times.push_back(lines_.times.back() + *time);
  }

  void end_joints() {
    if (joints_.postures.empty()) return;
    const std::string where = joints_.where.front();
    add(std::move(joints_), where);
    joints_ = {};
  }

  template <typename Shape>
  void add(Shape shape, std::string where) {
    Segment& segment = segments_.emplace_back();
    segment.shape.template emplace<Shape>(std::move(shape));
    segment.tolerance = context_.tolerance;
    segment.where = std::move(where);
  }

  const SegmentContext& context_;
  ControllerAxes axes_;
  std::vector<Segment> segments_;
  PoseListSegment lines_;
  std::vector<std::optional<double>> durations_;
  JointListSegment joints_;
};

}  // namespace

std::vector<Segment> read_program_segments(const std::filesystem::path& file,
                                           const SegmentContext& context) {
  std::vector<Segment> segments =
      SeamProgram(context).segments(read_moves(file, context.exports.ls.j3_coupling));
  if (segments.empty()) throw InvalidInput(file.string(), "no moves", "at least one");
  return segments;
}

}  // namespace wristwise
