#include "wristwise/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/clearance_search.hpp"
#include "task/deviation_search.hpp"
#include "verify/checked_motion.hpp"
#include "verify/failure_text.hpp"
#include "verify/pace_check.hpp"
#include "verify/row_waypoints.hpp"
#include "wristwise/swept_clearance.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;   // s
constexpr double kRatioTolerance = 1e-9;  // of a limit
constexpr std::size_t kFirstLook = 8;     // waypoints, one of which is measured first
constexpr double kResolution = 0.2;       // of the least clearance, in epsilons

class Verifier {
 public:
  Verifier(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
           const CheckedMotion& motion, const VerificationOptions& options)
      : given_(task),
        rows_(row_waypoints(task, motion.times())),
        task_(rows_.task),
        checker_(clearance),
        robot_(clearance->robot()),
        motion_(motion),
        options_(options) {
    goal_.position_epsilon = options.position_tolerance;
    goal_.angle_epsilon = options.angle_tolerance;
    result_.run = true;
    result_.curve = motion.is_curve();
    result_.range = {motion.times().front(), motion.times().back()};
  }

  Verification run() {
    check_coverage();
    for (std::size_t i = 0; i < task_.waypoints.size(); ++i)
      if (!rows_.is_knot[i]) check_waypoint(i);
    for (std::size_t i = 0; i + 1 < task_.waypoints.size(); ++i) check_between(i);
    result_.deviation_shown = result_.deviation_not_shown.empty();
    check_given_waypoints();
    check_limits();
    if (!clearance_model().pairs().empty()) check_clearance();
    report_boxes();
    result_.passed = result_.failures.empty();
    return result_;
  }

 private:
  const ClearanceModel& clearance_model() const { return checker_.model(); }

  void fail(const std::string& line) { result_.failures.push_back(line); }

  void check_coverage() {
    const double start = given_.waypoints.front().time, end = given_.waypoints.back().time;
    const double first = motion_.times().front(), last = motion_.times().back();
    if (first > start + kTimeTolerance || last < end - kTimeTolerance) {
      fail(text::coverage(first, last, start, end));
    }
  }

  /// Of the TCP over the waypoint's box.
  Vector6 excess_at(const Waypoint& waypoint, const JointVector& q) {
    const ToleranceBox& box = waypoint.tolerance;
    const Vector6 e = deviation(box, waypoint.frame, tcp_pose(robot_, q));
    goal_.known_distance = std::max(goal_.known_distance, e.head<3>().norm());
    for (int k = 3; k < 6; ++k) {
      if (!box.is_free(k)) goal_.known_angle = std::max(goal_.known_angle, std::abs(e[k]));
    }
    return box_excess(box, e);
  }

  void check_waypoint(std::size_t i) {
    const Waypoint& waypoint = task_.waypoints[i];
    const JointVector q = motion_.posture(i, waypoint.time);
    ++result_.samples;
    if (waypoint.joints) {
      check_given_posture(i, waypoint, q);
      return;
    }
    const Vector6 excess = excess_at(waypoint, q);
    result_.position_error = std::max(result_.position_error, excess.head<3>().norm());
    for (int k = 0; k < 6; ++k) {
      if (excess[k] > result_.tolerance_excess[k]) {
        result_.tolerance_excess[k] = excess[k];
        worst_waypoint_[static_cast<std::size_t>(k)] = i;
      }
    }
  }

  /// How far beyond what is accepted each joint of a joint waypoint is; negative inside. A range is
  /// held like a joint limit; a single value, or the middle of a range narrower than that, to the
  /// angle tolerance.
  JointVector posture_excess(const JointBox& given, const JointVector& q) const {
    const JointVector off = (q - given.nominal()).cwiseAbs().array() - options_.angle_tolerance;
    const JointVector outside =
        (given.lower - q).cwiseMax(q - given.upper).array() - options_.joint_limit_tolerance;
    return off.cwiseMin(outside);
  }

  void check_given_posture(std::size_t i, const Waypoint& waypoint, const JointVector& q) {
    const JointBox& given = *waypoint.joints;
    int joint = 0;
    const double beyond = posture_excess(given, q).maxCoeff(&joint);
    if (beyond <= 0) return;
    const std::string& name = robot_.joints()[static_cast<std::size_t>(joint)].name;
    const double lower = given.lower[joint], upper = given.upper[joint];
    fail(lower == upper
             ? text::posture(i, waypoint.time, name, std::abs(q[joint] - lower))
             : text::joint_range(i, waypoint.time, name,
                                 std::max(lower - q[joint], q[joint] - upper), lower, upper));
  }

  /// Stretch by stretch, as each has the tolerance of the given waypoint at its end.
  void check_between(std::size_t i) {
    const MotionPiece piece = motion_.piece(i);
    const auto& given = given_.waypoints;
    auto next = std::lower_bound(
        given.begin(), given.end() - 1, piece.start() + kTimeTolerance,
        [](const Waypoint& waypoint, double time) { return waypoint.time <= time; });
    double t0 = piece.start();
    for (; next->time < piece.end() - kTimeTolerance && next + 1 != given.end(); ++next) {
      check_stretch(piece, t0, next->time, next->tolerance);
      t0 = next->time;
    }
    check_stretch(piece, t0, piece.end(), next->tolerance);
  }

  void check_stretch(const MotionPiece& piece, double t0, double t1, const ToleranceBox& box) {
    const ToleranceBox wider = box.widened(given_.between_position, given_.between_angle);
    const DeviationFinding found =
        search_deviation(robot_, piece, t0, t1, task_.seam, wider, goal_);
    result_.samples += found.samples;
    result_.path_error = std::max(result_.path_error, found.distance);
    result_.angle_error = std::max(result_.angle_error, found.angle);
    for (const auto& [from, to] : found.not_shown)
      result_.deviation_not_shown.push_back({from, to});
    for (std::size_t k = 0; k < 6; ++k) {
      record_between(k, found.excess[static_cast<Eigen::Index>(k)], found.time[k]);
    }
    for (int k = 0; k < options_.samples_per_interval; ++k) {
      sample_between(piece, t0 + (k + 0.5) * (t1 - t0) / options_.samples_per_interval, wider);
    }
  }

  void sample_between(const MotionPiece& piece, double t, const ToleranceBox& box) {
    if (task_.seam.piece_at(t).kind == SeamPiece::Kind::move) return;
    ++result_.samples;
    const Pose tcp = tcp_pose(robot_, piece.posture(t));
    const Vector6 excess = box_excess(box, deviation(box, task_.seam.frame_at(t), tcp));
    for (std::size_t k = 0; k < 6; ++k) {
      record_between(k, excess[static_cast<Eigen::Index>(k)], t);
    }
  }

  void record_between(std::size_t coordinate, double excess, double time) {
    double& largest = result_.tolerance_excess_between[static_cast<Eigen::Index>(coordinate)];
    if (excess <= largest) return;
    largest = excess;
    worst_time_[coordinate] = time;
  }

  /// The task's own waypoints that are no waypoint of the motion: what holds between holds there.
  void check_given_waypoints() {
    for (std::size_t i = 0; i < given_.waypoints.size(); ++i) {
      const Waypoint& waypoint = given_.waypoints[i];
      const auto& times = motion_.times();
      const auto next =
          std::lower_bound(times.begin(), times.end(), waypoint.time - kTimeTolerance);
      if (next == times.end() || next == times.begin()) continue;
      if (*next <= waypoint.time + kTimeTolerance) continue;
      const auto interval = static_cast<std::size_t>(next - times.begin()) - 1;
      const JointVector q = motion_.posture(interval, waypoint.time);
      ++result_.samples;
      if (waypoint.joints) {
        check_given_posture(i, waypoint, q);
        continue;
      }
      Waypoint wider = waypoint;
      wider.tolerance = waypoint.tolerance.widened(given_.between_position, given_.between_angle);
      const Vector6 excess = excess_at(wider, q);
      for (int k = 0; k < 6; ++k) {
        if (excess[k] > tolerance(k)) fail(text::skipped_waypoint(i, waypoint.time, k, excess[k]));
      }
    }
  }

  double tolerance(int coordinate) const {
    return coordinate < 3 ? options_.position_tolerance : options_.angle_tolerance;
  }

  void report_boxes() {
    bool found_outside = false;
    for (int k = 0; k < 6; ++k) {
      const auto index = static_cast<std::size_t>(k);
      if (result_.tolerance_excess[k] > tolerance(k)) {
        const std::size_t i = worst_waypoint_[index];
        fail(text::waypoint_box(i, task_.waypoints[i].time, k, result_.tolerance_excess[k]));
      }
      if (result_.tolerance_excess_between[k] > tolerance(k)) {
        const std::string line =
            text::between_box(worst_time_[index], k, result_.tolerance_excess_between[k]);
        motion_.is_curve() ? fail(line) : result_.warnings.push_back(line);
        found_outside = true;
      }
    }
    if (result_.deviation_shown || found_outside) return;
    const TimeRange& first = result_.deviation_not_shown.front();
    const std::string line = text::between_not_shown(first.from, first.to);
    motion_.is_curve() ? fail(line) : result_.warnings.push_back(line);
  }

  void check_limits() {
    const JointVector lower = robot_.lower_limits(), upper = robot_.upper_limits();
    for (std::size_t i = 0; i + 1 < motion_.times().size(); ++i) {
      JointVector least, largest;
      motion_.extremes(i, least, largest);
      const JointVector excess = (lower - least).cwiseMax(largest - upper).cwiseMax(0.0);
      int joint = 0;
      const double worst = excess.maxCoeff(&joint);
      if (worst > result_.joint_limit_excess) {
        result_.joint_limit_excess = worst;
        limit_joint_ = joint;
        limit_time_ = motion_.times()[i];
      }
    }
    if (result_.joint_limit_excess > options_.joint_limit_tolerance) {
      fail(text::joint_limit(robot_.joints()[static_cast<std::size_t>(limit_joint_)].name,
                             limit_time_, result_.joint_limit_excess));
    }
    check_rate(1, robot_.velocity_limits(), result_.velocity_ratio, result_.velocity_joint, true);
    check_rate(2, robot_.acceleration_limits(), result_.acceleration_ratio,
               result_.acceleration_joint, motion_.is_curve());
    check_rate(3, robot_.jerk_limits(), result_.jerk_ratio, result_.jerk_joint, motion_.is_curve());
  }

  void check_rate(int derivative, const JointVector& limit, double& ratio, int& joint,
                  bool required) {
    const RatePeak peak = motion_.rate_peak(derivative, limit);
    ratio = peak.ratio;
    joint = peak.joint;
    if (derivative == 1) result_.velocity_time = peak.time;
    if (ratio <= 1 + kRatioTolerance) return;
    const std::string line = text::rate(
        derivative, robot_.joints()[static_cast<std::size_t>(joint)].name, peak.time, ratio);
    required ? fail(line) : result_.warnings.push_back(line);
  }

  void check_clearance() {
    const double required = clearance_model().clearance();
    const double floor = required - options_.clearance_epsilon;
    ClearanceSearch search(checker_, kResolution * options_.clearance_epsilon);
    ClearanceFinding found = least_at_waypoints(search, kFirstLook);
    std::vector<MotionPiece> pieces;
    for (std::size_t i = 0; i + 1 < motion_.times().size(); ++i) pieces.push_back(motion_.piece(i));
    for (const MotionPiece& piece : pieces) search.look_along(piece, found);
    for (const MotionPiece& piece : pieces) sample_clearance(piece, search, found);
    const bool holds_at_waypoints = clears_waypoints(search, found);
    result_.clearance = found.least;
    result_.clearance_pair = clearance_model().names(found.pair);
    result_.clearance_time = found.time;
    if (found.bound >= floor) {
      result_.clearance_bound = found.bound;
    } else {
      list_unshown(pieces, floor, search);
    }
    result_.samples += search.postures();
    result_.distance_queries = checker_.queries();
    if (!holds_at_waypoints || !(found.least >= floor)) {
      fail(text::clearance(result_.clearance_pair, found.time, found.least, required));
    } else if (!result_.clearance_bound) {
      for (const auto& [range, pair] : result_.clearance_not_shown) {
        fail(text::clearance_not_shown(pair, range.from, range.to, floor));
      }
    }
  }

  /// They are measured only where something is too near somewhere.
  bool clears_waypoints(ClearanceSearch& search, ClearanceFinding& found) const {
    const double accepted = clearance_model().clearance() - options_.clearance_tolerance;
    if (found.least >= accepted) return true;
    const ClearanceFinding at_waypoints = least_at_waypoints(search, 1);
    if (at_waypoints.least < found.least) {
      found.least = at_waypoints.least;
      found.pair = at_waypoints.pair;
      found.time = at_waypoints.time;
    }
    return at_waypoints.least >= accepted;
  }

  /// At every `step`-th waypoint, the first and the last among them.
  ClearanceFinding least_at_waypoints(ClearanceSearch& search, std::size_t step) const {
    ClearanceFinding found;
    const auto& times = motion_.times();
    for (std::size_t i = 0; i < times.size(); i += step) {
      search.look_at(times[i], motion_.posture(i, times[i]), found);
    }
    search.look_at(times.back(), motion_.posture(times.size() - 1, times.back()), found);
    return found;
  }

  void sample_clearance(const MotionPiece& piece, ClearanceSearch& search,
                        ClearanceFinding& found) const {
    const int count = options_.samples_per_interval;
    for (int k = 0; k < count; ++k) {
      const double t = piece.start() + (k + 0.5) * (piece.end() - piece.start()) / count;
      search.look_at(t, piece.posture(t), found);
    }
  }

  void list_unshown(const std::vector<MotionPiece>& pieces, double floor, ClearanceSearch& search) {
    for (const MotionPiece& piece : pieces) {
      for (const auto& [pair, range] : search.not_shown(piece, floor)) {
        result_.clearance_not_shown.push_back(
            {{range.first, range.second}, clearance_model().names(pair)});
      }
    }
  }

  const Task& given_;
  const RowWaypoints rows_;
  const Task& task_;  ///< with the motion's own times as waypoints
  ClearanceChecker checker_;
  const Robot& robot_;
  const CheckedMotion& motion_;
  const VerificationOptions& options_;
  Verification result_;
  DeviationGoal goal_;
  std::array<std::size_t, 6> worst_waypoint_{};
  std::array<double, 6> worst_time_{};
  int limit_joint_ = 0;
  double limit_time_ = 0;
};

}  // namespace

Verification verify(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
                    const JointPath& path, const VerificationOptions& options) {
  validate(path, clearance->robot().joint_count(), "path");
  validate_joint_waypoints(task, clearance->robot());
  return Verifier(task, clearance, PointMotion(path), options).run();
}

Verification verify(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
                    const Trajectory& trajectory, const VerificationOptions& options) {
  validate(trajectory.waypoints(), clearance->robot().joint_count(), "trajectory");
  validate_joint_waypoints(task, clearance->robot());
  Verification result = Verifier(task, clearance, CurveMotion(trajectory), options).run();
  for (const std::string& line : rest_failures(task, clearance->robot(), trajectory))
    result.failures.push_back(line);
  result.passed = result.failures.empty();
  return result;
}

}  // namespace wristwise
