#include "graph/path_sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cancelled.hpp"
#include "graph/sample_cells.hpp"
#include "graph/sampling_grid.hpp"
#include "kinematics/singularity.hpp"
#include "parallel.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr double kLimitTolerance = 1e-12;
constexpr double kMostSamples = 1e6;  // of a waypoint

/// Eq. 9, and the same for positions (F17).
double deviation_cost(const CostOptions& cost, const Vector6& e) {
  return cost.euler_graph * (cost.euler_eta * std::abs(e[3]) + std::abs(e[4])) +
         cost.position_graph * e.head<3>().lpNorm<1>();
}

/// The grid of one tolerance box.
class SampleGrid {
 public:
  struct Sample {
    Vector6 deviation;
    Pose in_path_frame;  ///< of the TCP; where the box is in the path frame
    double cost;
  };

  SampleGrid(const ToleranceBox& box, const std::vector<Vector6>& grid, const CostOptions& cost)
      : box_(box), cells_(box, grid) {
    samples_.reserve(grid.size());
    for (const Vector6& e : grid) {
      samples_.push_back({e, pose_at_deviation(box, Pose::Identity(), e), deviation_cost(cost, e)});
    }
  }

  const std::vector<Sample>& samples() const { return samples_; }
  const SampleCells& cells() const { return cells_; }

  bool is_of(const ToleranceBox& box) const {
    return box_.frame == box.frame && box_.lower == box.lower && box_.upper == box.upper;
  }

  /// nullopt where the sample has other angles than those asked for: in the base frame the middle
  /// angle may leave +-90 deg.
  std::optional<Pose> pose(const Sample& sample, const Pose& path_frame) const {
    if (box_.frame == ToleranceFrame::path) return path_frame * sample.in_path_frame;
    const Pose tcp = pose_at_deviation(box_, path_frame, sample.deviation);
    const Vector6 measured = deviation(box_, path_frame, tcp);
    for (int k = 3; k < 6; ++k) {
      if (std::abs(wrap_angle(measured[k] - sample.deviation[k])) > 1e-9) return std::nullopt;
    }
    return tcp;
  }

 private:
  ToleranceBox box_;
  SampleCells cells_;
  std::vector<Sample> samples_;
};

/// Samples waypoints one after the other; one per thread.
class WaypointSampler {
 public:
  WaypointSampler(const SamplingInput& input, bool check_clearance)
      : input_(input),
        period_(turn_periods(input.robot, input.options.turns)),
        singularity_(input.robot, input.cost.singularity_measure) {
    if (check_clearance) checker_.emplace(input.clearance);
  }

  std::size_t queries() const { return checker_ ? checker_->queries() : 0; }

  Rung sample(const Waypoint& waypoint, SampleCounts& counts) {
    positions_.clear();
    costs_.clear();
    if (waypoint.joints) return joint_rung(*waypoint.joints, counts);
    const ToleranceBox& box = waypoint.sampled ? *waypoint.sampled : waypoint.tolerance;
    if (!grid_ || !grid_->is_of(box)) {
      const std::vector<Vector6> grid = waypoint_grid(box, input_.options);
      refuse_too_many(grid.size());
      grid_.emplace(box, grid, input_.cost);
    }
    return sample_grid(waypoint, *grid_, counts);
  }

  Rung sample(const Waypoint& waypoint, const std::vector<Vector6>& grid, SampleCounts& counts) {
    positions_.clear();
    costs_.clear();
    return sample_grid(waypoint, SampleGrid(waypoint.tolerance, grid, input_.cost), counts);
  }

 private:
  /// The samples of the tolerance alone are checked by waypoint_grid.
  void refuse_too_many(std::size_t of_tolerance) const {
    const std::size_t of_joints = input_.ik.samples();
    if (static_cast<double>(of_tolerance) * static_cast<double>(of_joints) <= kMostSamples) return;
    throw InvalidInput(
        "graph.samples",
        fmt::format("{} samples of the tolerance times {} of joints", of_tolerance, of_joints),
        "at most a million at a waypoint: larger steps");
  }

  Rung sample_grid(const Waypoint& waypoint, const SampleGrid& grid, SampleCounts& counts) {
    counts.samples += grid.samples().size();
    for (const SampleGrid::Sample& sample : grid.samples()) {
      if (!input_.ik.meets_every_pose()) {
        add_near(grid.cells().sample(waypoint.frame, sample.deviation), counts);
      } else if (const std::optional<Pose> tcp = grid.pose(sample, waypoint.frame)) {
        add_sample(*tcp, sample.cost, counts);
      }
    }
    return make_rung();
  }

  /// Copies by whole turns count where they are inside the ranges.
  Rung joint_rung(const JointBox& box, SampleCounts& counts) {
    for (const JointVector& q : joint_grid(box, input_.options.joint_step)) {
      ++counts.samples;
      add_joint_sample(q, counts);
    }
    Rung rung = make_rung();
    rung.lower = box.lower.cwiseMax(input_.robot.lower_limits());
    rung.upper = box.upper.cwiseMin(input_.robot.upper_limits());
    return rung;
  }

  void add_joint_sample(const JointVector& q, SampleCounts& counts) {
    for (int j = 0; j < input_.robot.joint_count(); ++j) {
      const Joint& joint = input_.robot.joints()[static_cast<std::size_t>(j)];
      if (q[j] < joint.lower || q[j] > joint.upper) {
        ++counts.joint_limit[j];
        return;
      }
    }
    if (is_clear(q, counts)) add(wrapped(q), 0);
  }

  void add_sample(const Pose& tcp, double cost, SampleCounts& counts) {
    input_.ik.solve(tcp, branches_);
    add_branches([cost](const JointVector&) { return cost; }, counts);
  }

  /// Of a chain that meets few poses: what it has in the part of the box about the sample.
  void add_near(const ToleranceSample& sample, SampleCounts& counts) {
    input_.ik.solve_near(sample, branches_);
    const auto cost = [&](const JointVector& q) {
      return deviation_cost(input_.cost,
                            deviation(sample.box, sample.path_frame, tcp_pose(input_.robot, q)));
    };
    add_branches(cost, counts);
  }

  template <class Cost>
  void add_branches(const Cost& cost, SampleCounts& counts) {
    if (branches_.empty()) ++counts.out_of_reach;
    for (JointVector& branch : branches_) {
      const int limiting = move_into_limits(branch);
      if (limiting >= 0) {
        ++counts.joint_limit[limiting];
      } else if (is_clear(branch, counts)) {
        add(branch, cost(branch));
      }
    }
  }

  /// A joint with copies goes to [-pi, pi], others to their place inside the limits.
  /// @return the first joint without one, or -1
  int move_into_limits(JointVector& q) const {
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      if (period_[j] == kTurn) {
        if (std::abs(q[j]) > kTurn / 2) q[j] = wrap_angle(q[j]);
        continue;
      }
      const Joint& joint = input_.robot.joints()[static_cast<std::size_t>(j)];
      const auto inside = [&joint](double value) {
        return value >= joint.lower - kLimitTolerance && value <= joint.upper + kLimitTolerance;
      };
      if (inside(q[j])) continue;
      if (joint.type == JointType::prismatic) return static_cast<int>(j);
      const double turns = input_.options.turns == Turns::all
                               ? std::ceil((joint.lower - kLimitTolerance - q[j]) / kTurn)
                               : std::round((wrap_angle(q[j]) - q[j]) / kTurn);
      q[j] += turns * kTurn;
      if (!inside(q[j])) return static_cast<int>(j);
    }
    return -1;
  }

  JointVector wrapped(JointVector q) const {
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      if (period_[j] == kTurn) q[j] = wrap_angle(q[j]);
    }
    return q;
  }

  bool is_clear(const JointVector& q, SampleCounts& counts) {
    if (!checker_) return true;
    checker_->set_posture(q);
    const auto hit = checker_->first_below(checker_->model().clearance());
    if (hit) ++counts.collision[checker_->model().names(hit->pair)];
    return !hit;
  }

  void add(const JointVector& q, double cost) {
    positions_.insert(positions_.end(), q.data(), q.data() + q.size());
    const double weight = input_.cost.singularity_graph;
    costs_.push_back(weight > 0 ? cost + weight * (1 - singularity_(q)) : cost);
  }

  Rung make_rung() const {
    using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto count = static_cast<Eigen::Index>(costs_.size());
    Rung rung;
    rung.positions = Eigen::Map<const Rows>(positions_.data(), count, input_.robot.joint_count());
    rung.cost = Eigen::Map<const Eigen::ArrayXd>(costs_.data(), count);
    return rung;
  }

  const SamplingInput& input_;
  JointVector period_;
  SingularityDistance singularity_;
  std::optional<ClearanceChecker> checker_;
  std::optional<SampleGrid> grid_;  ///< of the last waypoint
  std::vector<JointVector> branches_;
  std::vector<double> positions_, costs_;
};

}  // namespace

JointVector turn_periods(const Robot& robot, Turns turns) {
  JointVector period =
      JointVector::Constant(robot.joint_count(), std::numeric_limits<double>::infinity());
  if (turns == Turns::principal) return period;
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const bool turns_round = joint.upper - joint.lower >= kTurn - kLimitTolerance;
    if (joint.type != JointType::prismatic && turns_round) period[j] = kTurn;
  }
  return period;
}

double posture_cost(const SamplingInput& input, const Waypoint& waypoint, const JointVector& q) {
  const CostOptions& cost = input.cost;
  double sum = 0;
  if (!waypoint.joints && (cost.euler_graph > 0 || cost.position_graph > 0)) {
    const Pose tcp = tcp_pose(input.robot, q);
    sum += deviation_cost(cost, deviation(waypoint.tolerance, waypoint.frame, tcp));
  }
  if (cost.singularity_graph > 0) {
    const SingularityDistance distance(input.robot, cost.singularity_measure);
    sum += cost.singularity_graph * (1 - distance(q));
  }
  return sum;
}

SampledPath sample_path(const SamplingInput& input, const Task& task, int threads,
                        const Monitor& monitor) {
  const std::size_t count = task.waypoints.size();
  SampledPath result;
  result.rungs.resize(count);
  result.counts.resize(count);
  const bool eager = input.options.collision_checks == CollisionChecks::eager;
  std::vector<WaypointSampler> samplers;
  samplers.reserve(static_cast<std::size_t>(threads));
  for (int i = 0; i < threads; ++i) samplers.emplace_back(input, eager);
  throw_if_cancelled(monitor);
  monitor.report("sampling", 0);
  parallel_for(count, threads, [&](int worker, std::size_t i) {
    throw_if_cancelled(monitor);
    result.rungs[i] =
        samplers[static_cast<std::size_t>(worker)].sample(task.waypoints[i], result.counts[i]);
    if (worker == 0) {
      monitor.report("sampling", static_cast<double>(i + 1) / static_cast<double>(count));
    }
  });
  monitor.report("sampling", 1);
  for (const WaypointSampler& sampler : samplers) result.collision_checks += sampler.queries();
  for (const Rung& rung : result.rungs) result.postures += static_cast<std::size_t>(rung.size());
  return result;
}

Rung sample_waypoint(const SamplingInput& input, const Waypoint& waypoint, SampleCounts& counts) {
  return WaypointSampler(input, true).sample(waypoint, counts);
}

std::vector<Rung> sample_grids(const SamplingInput& input, const Task& task,
                               const std::vector<std::vector<Vector6>>& grids, int threads) {
  std::vector<Rung> rungs(task.waypoints.size());
  std::vector<WaypointSampler> samplers;
  samplers.reserve(static_cast<std::size_t>(threads));
  for (int i = 0; i < threads; ++i) samplers.emplace_back(input, false);
  parallel_for(rungs.size(), threads, [&](int worker, std::size_t i) {
    WaypointSampler& sampler = samplers[static_cast<std::size_t>(worker)];
    SampleCounts counts;
    rungs[i] = task.waypoints[i].joints ? sampler.sample(task.waypoints[i], counts)
                                        : sampler.sample(task.waypoints[i], grids[i], counts);
  });
  return rungs;
}

}  // namespace wristwise
