#include "graph/path_bounds.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "cancelled.hpp"
#include "parallel.hpp"

namespace wristwise {

// (F19) The L1 metric keeps the triangle inequality, so a path that skips rungs costs no more than
// one that stops on each: with c'_i = c_i - min c_i >= 0,
//   cost of a path through u_a, u_b, ..  >=  sum_i min c_i + c'(u_a) + |u_b - u_a| + c'(u_b) + ..
// A dynamic programme over every s-th rung gives bounds for the vertices of those; between two of
// them, with the vertices that are left,
//   before(v) = min_u before(u) + |v - u| + c'(v),   after(v) = min_w |w - v| + c'(w) + after(w),
// and v can be on a path of cost C only if sum_i min c_i + before(v) + after(v) <= C.
// Squared steps break the triangle inequality: s = 1.

namespace {

constexpr std::size_t kChunk = 64;
/// Relative to 1 + the limit: round-off must not exclude a vertex of the best path.
constexpr double kRounding = 1e-11;

}  // namespace

/// What is left of a rung, to be reached from others or to be gone on from.
struct PathBounds::Source {
  std::optional<NeighbourTree> tree;
  Eigen::ArrayXd middle, half_width;  // of the box round it
  double least = kInfinity;           // key

  /// For each configuration of a rung, no total is less.
  Eigen::ArrayXd bound(const Rung& rung, const JointMetric& metric) const {
    Eigen::ArrayXd sum = Eigen::ArrayXd::Constant(rung.size(), least);
    for (Eigen::Index j = 0; j < rung.positions.cols(); ++j) {
      Eigen::ArrayXd step = (rung.positions.col(j) - middle[j]).abs();
      if (metric.period[j] < kInfinity) {
        step = step.min((metric.period[j] - step).abs());  // the middle may lie beyond the seam
      }
      step = (step - half_width[j]).max(0);
      sum += metric.weight[j] * (metric.squared ? step.square().eval() : step);
    }
    return sum;
  }
};

PathBounds::PathBounds(const std::vector<Rung>& rungs, const JointMetric& metric,
                       std::size_t stride, IsBlocked is_blocked, int threads,
                       const Monitor& monitor)
    : rungs_(rungs), metric_(metric), is_blocked_(std::move(is_blocked)), threads_(threads) {
  for (const Rung& rung : rungs_) {
    least_cost_.push_back(rung.cost.minCoeff());
    base_ += least_cost_.back();
  }
  for (std::size_t i = 0; i + 1 < rungs_.size(); i += stride) landmarks_.push_back(i);
  landmarks_.push_back(rungs_.size() - 1);
  if (base_ < kInfinity) run_forward(threads, monitor);
}

/// Above the least of the rung; infinite where blocked.
Eigen::ArrayXd PathBounds::spare_cost(std::size_t rung) const {
  Eigen::ArrayXd cost = rungs_[rung].cost - least_cost_[rung];
  for (Eigen::Index v = 0; v < cost.size(); ++v) {
    if (is_blocked_(rung, v)) cost[v] = kInfinity;
  }
  return cost;
}

void PathBounds::run_forward(int threads, const Monitor& monitor) {
  forward_.push_back(spare_cost(0));
  std::vector<std::size_t> evaluated(static_cast<std::size_t>(threads), 0);
  NeighbourTree tree(rungs_[0].positions, metric_);
  for (std::size_t k = 1; k < landmarks_.size(); ++k) {
    throw_if_cancelled(monitor);
    const Rung& rung = rungs_[landmarks_[k]];
    tree.set_keys(forward_.back());
    NeighbourTree next(rung.positions, metric_);
    Eigen::ArrayXd before = spare_cost(landmarks_[k]);
    const auto& order = next.order();
    parallel_for((order.size() + kChunk - 1) / kChunk, threads, [&](int worker, std::size_t chunk) {
      Eigen::Index hint = -1;
      const std::size_t end = std::min(order.size(), (chunk + 1) * kChunk);
      for (std::size_t at = chunk * kChunk; at < end; ++at) {
        if (before[order[at]] == kInfinity) continue;
        const JointVector target = rung.vertex(order[at]);
        const auto nearest = tree.nearest(target.data(), nullptr, kInfinity, hint,
                                          evaluated[static_cast<std::size_t>(worker)]);
        hint = nearest.index;
        before[order[at]] += nearest.total;
      }
    });
    forward_.push_back(std::move(before));
    tree = std::move(next);
    monitor.report("search", 0.5 * static_cast<double>(k) / static_cast<double>(landmarks_.size()));
  }
  least_ = base_ + forward_.back().minCoeff();
  evaluated_ = std::accumulate(evaluated.begin(), evaluated.end(), std::size_t{0});
}

PathBounds::Source PathBounds::source(std::size_t rung, const Stop& stop, bool forward) const {
  const auto count = static_cast<Eigen::Index>(stop.alive.size());
  Source source;
  Eigen::ArrayXXd positions(count, metric_.joints());
  Eigen::ArrayXd keys = forward ? stop.before : stop.after;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index v = stop.alive[static_cast<std::size_t>(k)];
    positions.row(k) = rungs_[rung].positions.row(v);
    if (!forward) keys[k] += rungs_[rung].cost[v] - least_cost_[rung];
  }
  source.tree.emplace(positions, metric_);
  source.tree->set_keys(keys);
  source.least = keys.minCoeff();
  for (Eigen::Index j = 0; j < positions.cols(); ++j) {  // a box on the circle
    const double period = metric_.period[j];
    if (period == kInfinity) continue;
    for (Eigen::Index k = 1; k < count; ++k) {
      positions(k, j) -= period * std::round((positions(k, j) - positions(0, j)) / period);
    }
  }
  const Eigen::ArrayXd low = positions.colwise().minCoeff(), high = positions.colwise().maxCoeff();
  source.middle = (low + high) / 2;
  source.half_width = (high - low) / 2;
  return source;
}

/// The most promising, in the order of their indices.
void PathBounds::keep_best(Stop& stop, std::size_t widest) {
  if (stop.alive.size() <= widest) return;
  std::vector<std::size_t> order(stop.alive.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto worth = [&stop](std::size_t k) {
    const auto index = static_cast<Eigen::Index>(k);
    return stop.before[index] + stop.after[index];
  };
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(widest);
  std::nth_element(order.begin(), end - 1, order.end(), [&](std::size_t a, std::size_t b) {
    return worth(a) != worth(b) ? worth(a) < worth(b) : a < b;
  });
  std::sort(order.begin(), end);
  Stop best;
  best.before.resize(static_cast<Eigen::Index>(widest));
  best.after.resize(static_cast<Eigen::Index>(widest));
  for (std::size_t k = 0; k < widest; ++k) {
    const auto from = static_cast<Eigen::Index>(order[k]), to = static_cast<Eigen::Index>(k);
    best.alive.push_back(stop.alive[order[k]]);
    best.before[to] = stop.before[from];
    best.after[to] = stop.after[from];
  }
  stop = std::move(best);
}

/// The landmarks' vertices that are left, from the last landmark to the first.
bool PathBounds::run_backward(double limit, std::size_t widest, std::vector<Stop>& stops) const {
  stops.assign(landmarks_.size(), {});
  for (std::size_t k = landmarks_.size(); k-- > 0;) {
    const std::size_t rung = landmarks_[k];
    const bool last = k + 1 == landmarks_.size();
    Source next;
    Eigen::ArrayXd bound = Eigen::ArrayXd::Zero(rungs_[rung].size());
    if (!last) {
      next = source(landmarks_[k + 1], stops[k + 1], false);
      bound = next.bound(rungs_[rung], metric_);
    }
    std::vector<double> after;
    for (Eigen::Index v = 0; v < rungs_[rung].size(); ++v) {
      const double before = forward_[k][v];
      if (before > limit || is_blocked_(rung, v)) continue;
      double rest = 0;
      if (!last) {
        if (before + bound[v] > limit) continue;
        const JointVector target = rungs_[rung].vertex(v);
        rest = next.tree->nearest(target.data(), nullptr, limit - before, -1, evaluated_).total;
        if (rest == kInfinity) continue;
      }
      stops[k].alive.push_back(v);
      after.push_back(rest);
    }
    if (after.empty()) return false;
    const auto count = static_cast<Eigen::Index>(after.size());
    stops[k].after = Eigen::Map<const Eigen::ArrayXd>(after.data(), count);
    stops[k].before.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      stops[k].before[i] = forward_[k][stops[k].alive[static_cast<std::size_t>(i)]];
    }
    keep_best(stops[k], widest);
  }
  return true;
}

std::optional<PathBounds::Stop> PathBounds::between(const Source& from, const Source& to,
                                                    std::size_t rung, double limit,
                                                    std::size_t widest,
                                                    std::size_t& evaluated) const {
  Stop stop;
  std::vector<double> before, after;
  const Eigen::ArrayXd bound = from.bound(rungs_[rung], metric_) + to.bound(rungs_[rung], metric_);
  for (Eigen::Index v = 0; v < rungs_[rung].size(); ++v) {
    if (bound[v] + rungs_[rung].cost[v] - least_cost_[rung] > limit) continue;
    const double own = rungs_[rung].cost[v] - least_cost_[rung];
    const JointVector target = rungs_[rung].vertex(v);
    double rest = limit - own - to.least;
    const double up = from.tree->nearest(target.data(), nullptr, rest, -1, evaluated).total + own;
    if (up == kInfinity) continue;
    rest = limit - up;
    const double down = to.tree->nearest(target.data(), nullptr, rest, -1, evaluated).total;
    if (down == kInfinity || is_blocked_(rung, v)) continue;
    stop.alive.push_back(v);
    before.push_back(up);
    after.push_back(down);
  }
  if (before.empty()) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(before.size());
  stop.before = Eigen::Map<const Eigen::ArrayXd>(before.data(), count);
  stop.after = Eigen::Map<const Eigen::ArrayXd>(after.data(), count);
  keep_best(stop, widest);
  return stop;
}

std::optional<Corridor> PathBounds::corridor(double limit, std::size_t widest) const {
  const double spare = limit - base_ + kRounding * (1 + std::abs(limit));
  std::vector<Stop> stops;
  if (!run_backward(spare, widest, stops)) return std::nullopt;
  Corridor corridor(rungs_.size());
  std::vector<char> fits(landmarks_.size(), 1);
  std::vector<std::size_t> evaluated(static_cast<std::size_t>(threads_), 0);
  // The rungs between two landmarks, halving until none is left.
  const auto fill = [&](auto&& self, std::size_t a, const Source& from, std::size_t b,
                        const Source& to, std::size_t& count) -> bool {
    const std::size_t middle = a + (b - a) / 2;
    auto stop = between(from, to, middle, spare, widest, count);
    if (!stop) return false;
    const bool found =
        (middle - a < 2 || self(self, a, from, middle, source(middle, *stop, false), count)) &&
        (b - middle < 2 || self(self, middle, source(middle, *stop, true), b, to, count));
    corridor[middle] = std::move(stop->alive);
    return found;
  };
  parallel_for(landmarks_.size() - 1, threads_, [&](int worker, std::size_t k) {
    const std::size_t a = landmarks_[k], b = landmarks_[k + 1];
    if (b - a < 2) return;
    const bool found = fill(fill, a, source(a, stops[k], true), b, source(b, stops[k + 1], false),
                            evaluated[static_cast<std::size_t>(worker)]);
    fits[k] = found ? 1 : 0;
  });
  evaluated_ = std::accumulate(evaluated.begin(), evaluated.end(), evaluated_);
  if (std::find(fits.begin(), fits.end(), 0) != fits.end()) return std::nullopt;
  for (std::size_t k = 0; k < landmarks_.size(); ++k) {
    corridor[landmarks_[k]] = std::move(stops[k].alive);
  }
  return corridor;
}

}  // namespace wristwise
