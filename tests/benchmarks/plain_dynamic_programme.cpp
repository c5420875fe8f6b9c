#include "plain_dynamic_programme.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "graph/sampling_grid.hpp"
#include "vector_clones.hpp"

namespace wristwise::benchmarks {

namespace {

constexpr int kJoints = 6;
constexpr std::size_t kLanes = 16;
using Lanes = float __attribute__((vector_size(64)));
using Indices = int __attribute__((vector_size(64)));

/// Padded to whole vectors with vertices that cannot be reached.
struct Columns {
  std::size_t count = 0;
  std::array<std::vector<float>, kJoints> q;
  std::vector<float> distance;
};

constexpr std::size_t kTargets = 4;

/// The best predecessor of four targets at a time.
WRISTWISE_VECTOR_CLONES
void relax(const Columns& from, const std::array<std::array<float, kJoints>, kTargets>& targets,
           float* least, int* previous) {
  std::array<Lanes, kTargets> best{};
  std::array<Indices, kTargets> index{};
  for (Lanes& lanes : best) lanes = Lanes{} + std::numeric_limits<float>::infinity();
  Indices at{};
  for (std::size_t lane = 0; lane < kLanes; ++lane) at[lane] = static_cast<int>(lane);
  for (std::size_t u = 0; u < from.distance.size(); u += kLanes, at += static_cast<int>(kLanes)) {
    Lanes distance;
    __builtin_memcpy(&distance, &from.distance[u], sizeof distance);
    std::array<Lanes, kTargets> sum{};
    for (Lanes& lanes : sum) lanes = distance;
    for (std::size_t j = 0; j < kJoints; ++j) {
      Lanes q;
      __builtin_memcpy(&q, &from.q[j][u], sizeof q);
      for (std::size_t k = 0; k < kTargets; ++k) {
        const Lanes step = q - targets[k][j];
        sum[k] += step < 0 ? -step : step;
      }
    }
    for (std::size_t k = 0; k < kTargets; ++k) {
      const auto better = sum[k] < best[k];
      best[k] = better ? sum[k] : best[k];
      index[k] = better ? at : index[k];
    }
  }
  for (std::size_t k = 0; k < kTargets; ++k) {
    least[k] = std::numeric_limits<float>::infinity();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!(best[k][lane] < least[k])) continue;
      least[k] = best[k][lane];
      previous[k] = index[k][lane];
    }
  }
}

Columns columns_of(const std::vector<JointVector>& postures) {
  Columns columns;
  columns.count = postures.size();
  const std::size_t padded = (postures.size() + kLanes - 1) / kLanes * kLanes;
  columns.distance.assign(padded, std::numeric_limits<float>::infinity());
  for (std::size_t j = 0; j < kJoints; ++j) {
    columns.q[j].assign(padded, 0);
    for (std::size_t v = 0; v < postures.size(); ++v) {
      columns.q[j][v] = static_cast<float>(postures[v][static_cast<Eigen::Index>(j)]);
    }
  }
  return columns;
}

std::vector<int> relax_rung(const Columns& from, Columns& to) {
  std::vector<int> previous((to.count + kTargets - 1) / kTargets * kTargets, -1);
  for (std::size_t v = 0; v < to.count; v += kTargets) {
    std::array<std::array<float, kJoints>, kTargets> targets{};
    for (std::size_t k = 0; k < kTargets; ++k) {
      for (std::size_t j = 0; j < kJoints; ++j)
        targets[k][j] = to.q[j][std::min(v + k, to.count - 1)];
    }
    std::array<float, kTargets> least{};
    relax(from, targets, least.data(), &previous[v]);
    for (std::size_t k = 0; k < kTargets && v + k < to.count; ++k) to.distance[v + k] = least[k];
  }
  return previous;
}

}  // namespace

PlainResult plain_dynamic_programme(const Problem& problem, const InverseKinematics& ik) {
  PlainResult result;
  std::vector<std::vector<JointVector>> postures;
  std::vector<std::vector<int>> previous;
  std::vector<JointVector> branches;
  Columns last;
  for (const Waypoint& waypoint : problem.task.waypoints) {
    auto& here = postures.emplace_back();
    for (const Vector6& e : sampling_grid(waypoint.tolerance, problem.graph.step)) {
      ik.solve(pose_at_deviation(waypoint.tolerance, waypoint.frame, e), branches);
      for (const JointVector& branch : branches) {
        append_turns(*problem.robot, branch, problem.graph.turns, here);
      }
    }
    result.vertices += here.size();
    Columns next = columns_of(here);
    if (postures.size() == 1) {
      std::fill_n(next.distance.begin(), next.count, 0.0F);
      previous.emplace_back();
    } else {
      previous.push_back(relax_rung(last, next));
    }
    last = std::move(next);
  }
  std::size_t at = 0;
  for (std::size_t v = 0; v < last.count; ++v) {
    if (last.distance[v] < last.distance[at]) at = v;
  }
  result.path.resize(postures.size());
  for (std::size_t i = postures.size(); i-- > 0;) {
    result.path[i] = postures[i][at];
    if (i > 0) at = static_cast<std::size_t>(previous[i][at]);
  }
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    result.cost += (result.path[i] - result.path[i - 1]).lpNorm<1>();
  }
  return result;
}

}  // namespace wristwise::benchmarks
