#include "graph/grid_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "graph/sampling_grid.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise {

// (F21) With e_i the deviation of the path's posture at waypoint i and s the step, the grid of the
// next round is the product of {e_i - s, e_i, e_i + s}, kept in the box. A round that lowers the
// cost by more than kSettled is repeated with the same step, as the path may travel; else s is
// halved, and the search ends when kIdleHalvings in a row have not paid. One is not enough: where
// the best path turns by less than s from waypoint to waypoint, only a finer grid shows it.

namespace {

constexpr double kSettled = 1e-3;  // relative
constexpr int kIdleHalvings = 4;
constexpr int kMostRounds = 100;

/// The largest interval of the first grid in each coordinate; 0 where the coordinate is held.
Vector6 grid_step(const ToleranceBox& box, const GraphOptions& options) {
  const Vector6 asked =
      options.automatic_samples > 0 ? automatic_step(box, options.automatic_samples) : options.step;
  Vector6 step = Vector6::Zero();
  for (int k = 0; k < 6; ++k) {
    const auto samples = coordinate_samples(box.lower[k], box.upper[k], asked[k]);
    if (samples.size() < 2) continue;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      step[k] = std::max(step[k], samples[i + 1] - samples[i]);
    }
  }
  return step;
}

std::vector<Vector6> grid_around(const ToleranceBox& box, const Vector6& center,
                                 const Vector6& step) {
  std::vector<Vector6> grid = {center};
  for (int k = 0; k < 6; ++k) {
    if (step[k] == 0) continue;
    std::vector<double> values;
    for (const double offset : {-step[k], 0.0, step[k]}) {
      const double value = center[k] + offset;
      values.push_back(box.is_free(k) ? value : std::clamp(value, box.lower[k], box.upper[k]));
    }
    values.erase(std::unique(values.begin(), values.end()), values.end());
    std::vector<Vector6> product;
    for (const Vector6& e : grid) {
      for (const double value : values) {
        product.push_back(e);
        product.back()[k] = value;
      }
    }
    grid = std::move(product);
  }
  return grid;
}

class Refinement {
 public:
  Refinement(GraphSearch& search, const SamplingInput& input, const Task& task, LadderPath path,
             int threads)
      : search_(search), input_(input), task_(task), result_{std::move(path), 0} {
    threads_ = threads;
    for (const Waypoint& waypoint : task.waypoints) {
      steps_.push_back(grid_step(waypoint.tolerance, input.options) / 2);
    }
  }

  FinerPath run() {
    double cost_before_halving = result_.path.cost;
    for (int idle = 0; idle < kIdleHalvings && result_.rounds < kMostRounds;) {
      const double before = result_.path.cost;
      if (!search_around()) break;
      if (has_paid(before)) continue;
      idle = has_paid(cost_before_halving) ? 0 : idle + 1;
      cost_before_halving = result_.path.cost;
      for (Vector6& step : steps_) step /= 2;
    }
    return std::move(result_);
  }

 private:
  bool has_paid(double before) const {
    return before - result_.path.cost > kSettled * std::abs(before);
  }

  bool search_around() {
    std::vector<std::vector<Vector6>> grids;
    for (std::size_t i = 0; i < task_.waypoints.size(); ++i) {
      const Waypoint& waypoint = task_.waypoints[i];
      const Pose tcp = tcp_pose(input_.robot, result_.path.positions[i]);
      grids.push_back(grid_around(
          waypoint.tolerance,
          in_box(waypoint.tolerance, deviation(waypoint.tolerance, waypoint.frame, tcp)),
          steps_[i]));
    }
    const std::vector<Rung> rungs = sample_grids(input_, task_, grids, threads_);
    for (const Rung& rung : rungs) {
      if (rung.size() == 0) return false;
    }
    LadderPath path = search_.find_path(rungs);
    ++result_.rounds;
    add(path.statistics);
    if (!path.found) return false;
    if (path.cost < result_.path.cost) {
      path.statistics = result_.path.statistics;
      result_.path = std::move(path);
    }
    return true;
  }

  /// Held coordinates exactly as they are held.
  static Vector6 in_box(const ToleranceBox& box, Vector6 e) {
    for (int k = 0; k < 6; ++k) {
      if (!box.is_free(k)) e[k] = std::clamp(e[k], box.lower[k], box.upper[k]);
    }
    return e;
  }

  void add(const LadderStatistics& more) {
    LadderStatistics& sum = result_.path.statistics;
    sum.vertices += more.vertices;
    sum.edges += more.edges;
    sum.edges_evaluated += more.edges_evaluated;
    sum.usable_checks += more.usable_checks;
    sum.clear_checks += more.clear_checks;
  }

  GraphSearch& search_;
  const SamplingInput& input_;
  const Task& task_;
  int threads_ = 1;
  FinerPath result_;
  std::vector<Vector6> steps_;
};

}  // namespace

FinerPath refine_grid(GraphSearch& search, const SamplingInput& input, const Task& task,
                      LadderPath path, int threads) {
  return Refinement(search, input, task, std::move(path), threads).run();
}

}  // namespace wristwise
