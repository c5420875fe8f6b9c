#include "graph/corridor_search.hpp"

#include <algorithm>
#include <numeric>

#include "cancelled.hpp"
#include "graph/relaxation.hpp"
#include "parallel.hpp"

namespace wristwise {

namespace {

/// After this many blocked moves of best paths in one interval, the moves into every vertex of the
/// interval are checked during relaxation: each further search would only find the next blocked
/// one.
constexpr int kLazyAttempts = 16;
/// From this size on a tree finds the best predecessor faster than a look at each.
constexpr std::size_t kTreeSize = 256;
constexpr Eigen::Index kChunk = 16;

}  // namespace

CorridorSearch::CorridorSearch(const SearchGraph& graph, const Corridor& corridor,
                               KnownChecks& known, int threads, const Monitor& monitor)
    : graph_(graph),
      rules_(*graph.rules),
      known_(known),
      threads_(threads),
      monitor_(monitor),
      layers_(corridor.size()),
      intervals_(corridor.size() - 1) {
  for (std::size_t i = 0; i < layers_.size(); ++i) add_layer(i, corridor[i]);
  for (std::size_t i = 0; i < intervals_.size(); ++i) add_interval(i);
}

void CorridorSearch::add_layer(std::size_t i, const std::vector<Eigen::Index>& vertices) {
  const Rung& all = (*graph_.rungs)[i];
  Layer& layer = layers_[i];
  layer.vertex = vertices;
  const auto count = static_cast<Eigen::Index>(vertices.size());
  layer.rung.positions.resize(count, all.positions.cols());
  layer.rung.cost.resize(count);
  for (Eigen::Index v = 0; v < count; ++v) {
    const Eigen::Index vertex = vertices[static_cast<std::size_t>(v)];
    layer.rung.positions.row(v) = all.positions.row(vertex);
    layer.rung.cost[v] = all.cost[vertex];
  }
  leave_out_blocked(i);
  layer.changed.assign(vertices.size(), 0);
  if (i == 0) layer.distance = layer.rung.cost;
  const bool followed = i + 1 < layers_.size();
  if (followed && vertices.size() > kTreeSize) {
    layer.tree.emplace(layer.rung.positions, graph_.metric);
  }
}

/// The step limit, infinite for joints that could not break it between these layers.
void CorridorSearch::add_interval(std::size_t i) {
  Interval& interval = intervals_[i];
  interval.max_step = rules_.max_step[i];
  const Rung& from = layers_[i].rung;
  const Rung& to = layers_[i + 1].rung;
  if (from.size() == 0 || to.size() == 0) return;
  for (Eigen::Index j = 0; j < interval.max_step.size(); ++j) {
    const auto& a = from.positions.col(j);
    const auto& b = to.positions.col(j);
    const double longest =
        std::min(std::max(b.maxCoeff() - a.minCoeff(), a.maxCoeff() - b.minCoeff()),
                 graph_.metric.period[j] / 2);
    if (longest <= interval.max_step[j]) interval.max_step[j] = kInfinity;
    interval.limited = interval.limited || interval.max_step[j] < kInfinity;
  }
}

CorridorSearch::Result CorridorSearch::run(bool repair_part) {
  for (;;) {
    reached_ = relax_stale_intervals();
    if (reached_ + 1 < layers_.size() && !repair_part) return {};
    const std::vector<Eigen::Index> path = best_path();
    if (!find_blocked_vertices(path) && !find_blocked_moves(path)) break;
  }
  Result result;
  const std::vector<Eigen::Index> path = best_path();
  result.found = !path.empty() && reached_ + 1 == layers_.size();
  for (std::size_t i = 0; i < path.size(); ++i) {
    result.vertices.push_back(layers_[i].vertex[static_cast<std::size_t>(path[i])]);
  }
  if (!path.empty()) result.cost = layers_[reached_].distance[path.back()];
  result.evaluated = evaluated_;
  return result;
}

/// Relaxes the intervals whose moves or start have changed; returns the last layer that can be
/// reached.
std::size_t CorridorSearch::relax_stale_intervals() {
  if (layers_[0].distance.size() == 0 || layers_[0].distance.minCoeff() == kInfinity) return 0;
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    const std::vector<char>& changed = layers_[i].changed;
    if (intervals_[i].stale || std::find(changed.begin(), changed.end(), 1) != changed.end()) {
      throw_if_cancelled(monitor_);
      relax(i);
      monitor_.report("search",
                      static_cast<double>(i + 1) / static_cast<double>(intervals_.size()));
    }
    const Eigen::ArrayXd& distance = layers_[i + 1].distance;
    if (distance.size() == 0 || distance.minCoeff() == kInfinity) return i;
  }
  return intervals_.size();
}

void CorridorSearch::relax(std::size_t i) {
  Layer& layer = layers_[i + 1];
  if (intervals_[i].fresh) {
    layer.distance.setConstant(layer.rung.size(), kInfinity);
    layer.previous.assign(static_cast<std::size_t>(layer.rung.size()), -1);
  }
  if (layers_[i].tree) layers_[i].tree->set_keys(layers_[i].distance);
  const std::vector<Eigen::Index> chunks = chunk_starts(i + 1);
  std::vector<Scratch> scratch(static_cast<std::size_t>(threads_));
  parallel_for(chunks.size() - 1, threads_, [&](int worker, std::size_t chunk) {
    Scratch& own = scratch[static_cast<std::size_t>(worker)];
    for (Eigen::Index v = chunks[chunk]; v < chunks[chunk + 1]; ++v) {
      if (must_relax(i, v, worker, own)) relax_vertex(i, v, worker, own);
    }
  });
  for (const Scratch& used : scratch) {
    known_.add(i, used.fresh);
    evaluated_ += static_cast<double>(used.evaluated);
  }
  intervals_[i].stale = intervals_[i].fresh = false;
  std::fill(layers_[i].changed.begin(), layers_[i].changed.end(), 0);
}

/// Distances only grow while vertices and moves are found to be blocked, so that a best predecessor
/// stays the best until it or the move from it changes.
bool CorridorSearch::must_relax(std::size_t i, Eigen::Index v, int worker, Scratch& scratch) {
  if (intervals_[i].fresh) return true;
  const Layer& layer = layers_[i + 1];
  if (layer.distance[v] == kInfinity) return false;
  if (layer.rung.cost[v] == kInfinity) return true;
  const Eigen::Index u = layer.previous[static_cast<std::size_t>(v)];
  if (layers_[i].changed[static_cast<std::size_t>(u)]) return true;
  return intervals_[i].stale && !is_allowed(i, u, v, worker, scratch);
}

/// Cuts a layer into chunks for the threads, never between copies of one configuration: they share
/// what is known of their moves.
std::vector<Eigen::Index> CorridorSearch::chunk_starts(std::size_t i) const {
  const Eigen::Index count = layers_[i].rung.size();
  std::vector<Eigen::Index> starts;
  for (Eigen::Index v = 0; v < count; ++v) {
    const bool is_due = starts.empty() || v - starts.back() >= kChunk;
    if (is_due && (v == 0 || configuration(i, v) != configuration(i, v - 1))) starts.push_back(v);
  }
  starts.push_back(count);
  return starts;
}

Eigen::Index CorridorSearch::configuration(std::size_t i, Eigen::Index v) const {
  return graph_.configuration(i, layers_[i].vertex[static_cast<std::size_t>(v)]);
}

void CorridorSearch::relax_vertex(std::size_t i, Eigen::Index v, int worker, Scratch& scratch) {
  Layer& layer = layers_[i + 1];
  Candidate best;
  if (layer.rung.cost[v] < kInfinity) {
    best = least_total(i, layer.rung.vertex(v), scratch);
    const bool as_it_is =
        best.index < 0 || (!rules_.edge_cost && is_allowed(i, best.index, v, worker, scratch));
    if (!as_it_is) best = best_allowed(i, v, worker, scratch);
  }
  const double distance = best.total + layer.rung.cost[v];
  if (distance != layer.distance[v]) layer.changed[static_cast<std::size_t>(v)] = 1;
  layer.distance[v] = distance;
  layer.previous[static_cast<std::size_t>(v)] = best.index;
}

/// Into scratch.total; returns the least.
double CorridorSearch::measure_all(std::size_t i, const JointVector& target, Scratch& scratch) {
  const Rung& from = layers_[i].rung;
  scratch.total.resize(from.size());
  scratch.evaluated += static_cast<std::size_t>(from.size());
  return relax_towards({from.positions.data(), static_cast<std::size_t>(from.size())},
                       layers_[i].distance.data(), target.data(), graph_.metric,
                       intervals_[i].max_step.data(), scratch.total.data());
}

CorridorSearch::Candidate CorridorSearch::least_total(std::size_t i, const JointVector& target,
                                                      Scratch& scratch) {
  if (layers_[i].tree) {
    const double* const max_step = intervals_[i].limited ? intervals_[i].max_step.data() : nullptr;
    const auto nearest =
        layers_[i].tree->nearest(target.data(), max_step, kInfinity, -1, scratch.evaluated);
    return {nearest.total, nearest.index};
  }
  const double least = measure_all(i, target, scratch);
  if (least == kInfinity) return {};
  const double* const total = scratch.total.data();
  return {least, std::find(total, total + scratch.total.size(), least) - total};
}

/// The cheapest vertex to come from by a move that is allowed, with what edge_cost adds.
CorridorSearch::Candidate CorridorSearch::best_allowed(std::size_t i, Eigen::Index v, int worker,
                                                       Scratch& scratch) {
  measure_all(i, layers_[i + 1].rung.vertex(v), scratch);
  const Eigen::ArrayXd& total = scratch.total;
  std::vector<Eigen::Index>& order = scratch.order;
  order.clear();
  for (Eigen::Index u = 0; u < total.size(); ++u) {
    if (total[u] < kInfinity) order.push_back(u);
  }
  const auto is_worse = [&total](Eigen::Index a, Eigen::Index b) {
    return total[a] != total[b] ? total[a] > total[b] : a > b;
  };
  std::make_heap(order.begin(), order.end(), is_worse);
  Candidate best;
  for (auto end = order.end(); end != order.begin();) {
    std::pop_heap(order.begin(), end--, is_worse);
    const Eigen::Index u = *end;
    if (total[u] > best.total) break;
    double sum = total[u];
    if (rules_.edge_cost) {
      sum += rules_.edge_cost(i, layers_[i].rung.vertex(u), end_of_move(i, u, v));
      if (sum > best.total || (sum == best.total && u > best.index)) continue;
    }
    if (!is_allowed(i, u, v, worker, scratch)) continue;
    best = {sum, u};
    if (!rules_.edge_cost) break;
  }
  return best;
}

/// A move that is not known to be blocked; where the interval asks for it, known to be clear.
bool CorridorSearch::is_allowed(std::size_t i, Eigen::Index u, Eigen::Index v, int worker,
                                Scratch& scratch) {
  if (rules_.is_near &&
      !rules_.is_near(i, layers_[i].rung.vertex(u), layers_[i + 1].rung.vertex(v))) {
    return false;
  }
  if (!rules_.is_clear) return true;
  if (intervals_[i].check_all) return is_clear(i, u, v, worker, scratch.fresh);
  if (known_.moves(i).empty()) return true;
  const auto move = known_.move(i, configuration(i, u), configuration(i + 1, v),
                                layers_[i].rung.vertex(u), end_of_move(i, u, v));
  const auto entry = known_.moves(i).find(move);
  return entry == known_.moves(i).end() || entry->second;
}

bool CorridorSearch::is_clear(std::size_t i, Eigen::Index u, Eigen::Index v, int worker,
                              KnownChecks::Moves& fresh) const {
  const JointVector from = layers_[i].rung.vertex(u), to = end_of_move(i, u, v);
  const auto move = known_.move(i, configuration(i, u), configuration(i + 1, v), from, to);
  const auto known = known_.moves(i).find(move);
  if (known != known_.moves(i).end()) return known->second;
  const auto [entry, is_new] = fresh.try_emplace(move, true);
  if (is_new) entry->second = rules_.is_clear(worker, i, from, to);
  return entry->second;
}

/// The copy of v that is nearest to u, joint by joint.
JointVector CorridorSearch::end_of_move(std::size_t i, Eigen::Index u, Eigen::Index v) const {
  JointVector to = layers_[i + 1].rung.vertex(v);
  for (Eigen::Index j = 0; j < to.size(); ++j) {
    const double period = graph_.metric.period[j];
    if (period == kInfinity) continue;
    to[j] += period * std::round((layers_[i].rung.positions(u, j) - to[j]) / period);
  }
  return to;
}

/// Checks the configurations of the path; false if all can be used.
bool CorridorSearch::find_blocked_vertices(const std::vector<Eigen::Index>& path) {
  if (!rules_.is_usable) return false;
  std::vector<char> blocked(path.size(), 0);
  parallel_for(path.size(), threads_, [&](int worker, std::size_t i) {
    if (known_.is_usable(worker, i, configuration(i, path[i]))) return;
    blocked[i] = 1;
    check_neighbours(i, path[i], worker);
  });
  bool any = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!blocked[i]) continue;
    any = true;
    leave_out_blocked(i);
    if (i > 0) intervals_[i - 1].stale = true;
  }
  return any;
}

/// The next search would turn to a neighbour of the blocked vertex: checks more of them each time.
void CorridorSearch::check_neighbours(std::size_t i, Eigen::Index v, int worker) {
  Layer& layer = layers_[i];
  const JointVector q = layer.rung.vertex(v);
  std::vector<std::pair<double, Eigen::Index>> order;
  for (Eigen::Index u = 0; u < layer.rung.size(); ++u) {
    if (!known_.is_unknown(i, configuration(i, u))) continue;
    const JointVector other = layer.rung.vertex(u);
    order.emplace_back(graph_.metric.cost(q.data(), other.data()), u);
  }
  const std::size_t count = std::min(order.size(), (std::size_t{1} << layer.blocked) - 1);
  layer.blocked = std::min(layer.blocked + 1, 30);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
  for (std::size_t k = 0; k < count; ++k) {
    known_.is_usable(worker, i, configuration(i, order[k].second));
  }
}

void CorridorSearch::leave_out_blocked(std::size_t i) {
  for (Eigen::Index v = 0; v < layers_[i].rung.size(); ++v) {
    if (!known_.is_blocked(i, configuration(i, v))) continue;
    layers_[i].rung.cost[v] = kInfinity;
    if (i > 0 || layers_[0].distance.size() == 0) continue;
    if (layers_[0].distance[v] < kInfinity) layers_[0].changed[static_cast<std::size_t>(v)] = 1;
    layers_[0].distance[v] = kInfinity;
  }
}

/// Checks the moves of the path; false if all are clear.
bool CorridorSearch::find_blocked_moves(const std::vector<Eigen::Index>& path) {
  if (!rules_.is_clear || path.size() < 2) return false;
  std::vector<char> blocked(path.size() - 1, 0);
  parallel_for(blocked.size(), threads_, [&](int worker, std::size_t i) {
    KnownChecks::Moves fresh;
    blocked[i] = is_clear(i, path[i], path[i + 1], worker, fresh) ? 0 : 1;
    known_.add(i, fresh);
  });
  bool any = false;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    if (!blocked[i]) continue;
    any = intervals_[i].stale = true;
    if (++intervals_[i].blocked == kLazyAttempts) {
      intervals_[i].check_all = true;
    }
  }
  return any;
}

std::vector<Eigen::Index> CorridorSearch::best_path() const {
  const Eigen::ArrayXd& distance = layers_[reached_].distance;
  if (distance.size() == 0 || distance.minCoeff() == kInfinity) return {};
  std::vector<Eigen::Index> path(reached_ + 1);
  distance.minCoeff(&path[reached_]);
  for (std::size_t i = reached_; i > 0; --i) {
    path[i - 1] = layers_[i].previous[static_cast<std::size_t>(path[i])];
  }
  return path;
}

}  // namespace wristwise
