#include "wristwise/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/checked_motion.hpp"
#include "verify/failure_text.hpp"
#include "verify/pace_check.hpp"
#include "verify/row_waypoints.hpp"
#include "wristwise/swept_clearance.hpp"

namespace wristwise {

namespace {

constexpr double kTimeTolerance = 1e-6;   // s
constexpr double kRatioTolerance = 1e-9;  // of a limit
constexpr double kLongestTravel = 1e-3;   // m of seam between two samples of the deviation
constexpr int kMostSamples = 1000;

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
    result_.run = true;
    result_.curve = motion.is_curve();
  }

  Verification run() {
    check_coverage();
    for (std::size_t i = 0; i < task_.waypoints.size(); ++i)
      if (!rows_.is_knot[i]) check_waypoint(i);
    for (std::size_t i = 0; i + 1 < task_.waypoints.size(); ++i) check_between(i);
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
  Vector6 excess_at(const Waypoint& waypoint, const JointVector& q) const {
    return box_excess(waypoint.tolerance,
                      deviation(waypoint.tolerance, waypoint.frame, tcp_pose(robot_, q)));
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

  void check_between(std::size_t i) {
    const auto box = task_.tolerance_between(i);
    if (!box) return;
    const double t0 = task_.waypoints[i].time, t1 = task_.waypoints[i + 1].time;
    const double travel =
        (task_.waypoints[i + 1].frame.translation() - task_.waypoints[i].frame.translation())
            .norm();
    const int count = std::clamp(static_cast<int>(std::ceil(travel / kLongestTravel)),
                                 std::max(10, options_.samples_per_interval), kMostSamples);
    for (int k = 0; k < count; ++k) {
      const double t = t0 + (k + 0.5) * (t1 - t0) / count;
      record_between(i, t, *box);
    }
  }

  void record_between(std::size_t i, double t, const ToleranceBox& box) {
    ++result_.samples;
    const ToleranceBox wider = box.widened(given_.between_position, given_.between_angle);
    const Pose tcp = tcp_pose(robot_, motion_.posture(i, t));
    const Vector6 excess = box_excess(wider, deviation(wider, task_.seam.frame_at(t), tcp));
    for (int k = 0; k < 6; ++k) {
      if (excess[k] > result_.tolerance_excess_between[k]) {
        result_.tolerance_excess_between[k] = excess[k];
        worst_time_[static_cast<std::size_t>(k)] = t;
      }
    }
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
      }
    }
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
    measure_clearance();
    double bound = std::numeric_limits<double>::infinity();
    bool shown = true;
    for (std::size_t i = 0; i + 1 < motion_.times().size(); ++i) {
      const auto stretch = motion_.stretch(i);
      const SweptClearance swept = check_motion(checker_, *stretch, clearance_model().clearance(),
                                                options_.clearance_epsilon);
      result_.samples += swept.postures;
      bound = std::min(bound, swept.bound);
      if (swept.clear) continue;
      const double t0 = motion_.times()[i], t1 = motion_.times()[i + 1];
      record_clearance(swept.pair, swept.distance, t0 + swept.s * (t1 - t0));
      shown = false;
    }
    if (shown) result_.clearance_bound = bound;
    if (!shown ||
        !(*result_.clearance >= clearance_model().clearance() - options_.clearance_tolerance)) {
      fail(text::clearance(result_.clearance_pair, result_.clearance_time, *result_.clearance,
                           clearance_model().clearance()));
    }
  }

  void measure_clearance() {
    const int count = std::max(10, options_.samples_per_interval);
    for (std::size_t i = 0; i + 1 < motion_.times().size(); ++i) {
      const double t0 = motion_.times()[i], t1 = motion_.times()[i + 1];
      for (int k = 0; k <= count; ++k) {
        const double t = t0 + k * (t1 - t0) / count;
        checker_.set_posture(motion_.posture(i, t));
        const auto nearest =
            result_.clearance ? checker_.nearest(*result_.clearance) : checker_.nearest();
        if (nearest) record_clearance(nearest->pair, nearest->distance, t);
      }
    }
  }

  void record_clearance(int pair, double distance, double time) {
    if (result_.clearance && distance >= *result_.clearance) return;
    result_.clearance = distance;
    result_.clearance_pair = clearance_model().names(pair);
    result_.clearance_time = time;
  }

  const Task& given_;
  const RowWaypoints rows_;
  const Task& task_;  ///< with the motion's own times as waypoints
  ClearanceChecker checker_;
  const Robot& robot_;
  const CheckedMotion& motion_;
  const VerificationOptions& options_;
  Verification result_;
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
