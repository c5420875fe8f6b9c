#include "graph/path_sampling.hpp"

#include <cmath>

#include "cancelled.hpp"
#include "graph/sampling_grid.hpp"
#include "parallel.hpp"

namespace wristwise {

namespace {

/// Samples waypoints one after the other; one per thread.
class WaypointSampler {
 public:
  WaypointSampler(const Robot& robot, const InverseKinematics& ik,
                  const std::shared_ptr<const ClearanceModel>& clearance, const CostOptions& cost,
                  const GraphOptions& options)
      : robot_(robot), ik_(ik), checker_(clearance), cost_(cost), options_(options) {}

  std::size_t queries() const { return checker_.queries(); }

  Rung sample(const Waypoint& waypoint, SampleCounts& counts) {
    postures_.clear();
    costs_.clear();
    first_copies_.clear();
    turn_codes_.clear();
    if (waypoint.joints) {
      for (const JointVector& q : joint_grid(*waypoint.joints, options_.joint_step)) {
        ++counts.samples;
        add_joint_waypoint(q, counts);
      }
    } else {
      for (const Vector6& e : sampling_grid(waypoint.tolerance, options_.step)) {
        ++counts.samples;
        add_pose_sample(waypoint, e, counts);
      }
    }
    return make_rung();
  }

 private:
  void add_joint_waypoint(const JointVector& q, SampleCounts& counts) {
    for (int j = 0; j < robot_.joint_count(); ++j) {
      const Joint& joint = robot_.joints()[static_cast<std::size_t>(j)];
      if (q[j] < joint.lower || q[j] > joint.upper) {
        ++counts.joint_limit[j];
        return;
      }
    }
    if (!is_clear(q, counts)) return;
    copies_ = {q};
    add_copies(0);
  }

  void add_pose_sample(const Waypoint& waypoint, const Vector6& e, SampleCounts& counts) {
    const Pose tcp = pose_at_deviation(waypoint.tolerance, waypoint.frame, e);
    if (!is_measured_as(waypoint, e, tcp)) return;
    ik_.solve(tcp, branches_);
    if (branches_.empty()) ++counts.out_of_reach;
    const double cost =
        cost_.euler_graph * (cost_.euler_eta * std::abs(e[3]) + std::abs(e[4]));  // eq. 9
    for (const JointVector& branch : branches_) {
      int limiting_joint = -1;
      copies_.clear();
      if (append_turns(robot_, branch, options_.turns, copies_, &limiting_joint) == 0) {
        ++counts.joint_limit[limiting_joint];
        continue;
      }
      if (!is_clear(copies_.front(), counts)) continue;  // turns do not move the robot's bodies
      add_copies(cost);
    }
  }

  /// In the base frame the middle angle may leave +-90 deg; the pose then has other angles.
  static bool is_measured_as(const Waypoint& waypoint, const Vector6& e, const Pose& tcp) {
    if (waypoint.tolerance.frame == ToleranceFrame::path) return true;
    const Vector6 measured = deviation(waypoint.tolerance, waypoint.frame, tcp);
    for (int k = 3; k < 6; ++k) {
      if (std::abs(wrap_angle(measured[k] - e[k])) > 1e-9) return false;
    }
    return true;
  }

  bool is_clear(const JointVector& q, SampleCounts& counts) {
    checker_.set_posture(q);
    const auto hit = checker_.first_below(checker_.model().clearance());
    if (hit) ++counts.collision[checker_.model().names(hit->pair)];
    return !hit;
  }

  void add_copies(double cost) {
    const auto first = static_cast<Eigen::Index>(postures_.size());
    for (const JointVector& q : copies_) add(q, cost, first);
  }

  void add(const JointVector& q, double cost, Eigen::Index first_copy) {
    postures_.push_back(q);
    costs_.push_back(cost);
    first_copies_.push_back(first_copy);
    turn_codes_.push_back(turn_code(postures_[static_cast<std::size_t>(first_copy)], q));
  }

  /// The turns from one posture to another, a digit of base 64 for each joint.
  static std::int64_t turn_code(const JointVector& from, const JointVector& to) {
    constexpr double kTurn = 6.283185307179586;
    std::int64_t code = 0;
    for (Eigen::Index j = 0; j < from.size(); ++j) {
      code = 64 * code + static_cast<std::int64_t>(std::lround((to[j] - from[j]) / kTurn));
    }
    return code;
  }

  Rung make_rung() const {
    Rung rung;
    const auto count = static_cast<Eigen::Index>(postures_.size());
    rung.positions.resize(count, robot_.joint_count());
    for (Eigen::Index i = 0; i < count; ++i) {
      rung.positions.row(i) = postures_[static_cast<std::size_t>(i)].transpose().array();
    }
    rung.cost = Eigen::Map<const Eigen::ArrayXd>(costs_.data(), count);
    rung.first_copy = first_copies_;
    rung.turn_code = turn_codes_;
    return rung;
  }

  const Robot& robot_;
  const InverseKinematics& ik_;
  ClearanceChecker checker_;
  const CostOptions& cost_;
  const GraphOptions& options_;
  std::vector<JointVector> branches_, copies_, postures_;
  std::vector<double> costs_;
  std::vector<Eigen::Index> first_copies_;
  std::vector<std::int64_t> turn_codes_;
};

}  // namespace

SampledPath sample_path(const Robot& robot, const Task& task, const InverseKinematics& ik,
                        const std::shared_ptr<const ClearanceModel>& clearance,
                        const CostOptions& cost, const GraphOptions& options, int threads,
                        const Monitor& monitor) {
  const std::size_t count = task.waypoints.size();
  SampledPath result;
  result.rungs.resize(count);
  result.counts.resize(count);
  std::vector<WaypointSampler> samplers;
  samplers.reserve(static_cast<std::size_t>(threads));
  for (int i = 0; i < threads; ++i) samplers.emplace_back(robot, ik, clearance, cost, options);
  parallel_for(count, threads, [&](int worker, std::size_t i) {
    throw_if_cancelled(monitor);
    result.rungs[i] =
        samplers[static_cast<std::size_t>(worker)].sample(task.waypoints[i], result.counts[i]);
    if (worker == 0) {
      monitor.report("sampling", static_cast<double>(i + 1) / static_cast<double>(count));
    }
  });
  for (const WaypointSampler& sampler : samplers) result.collision_checks += sampler.queries();
  return result;
}

}  // namespace wristwise
