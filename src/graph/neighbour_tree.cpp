#include "graph/neighbour_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "vector_clones.hpp"

namespace wristwise {

// (F18) For a point u in a box B and a target v,  key_u + cost(u, v) >= min key over B + cost(B,
// v),
//   cost(B, v) = sum_j w_j max(0, s_j(v, m_j) - h_j),
// with m the box's middle and h its half widths: s_j is a metric on the line and on the circle, so
// s_j(u, v) >= s_j(v, m_j) - s_j(u, m_j) and s_j(u, m_j) <= h_j. Squared costs likewise.

namespace {

constexpr int kFan = NeighbourTree::kFan;
constexpr int kLeaf = NeighbourTree::kLeaf;

/// Eight doubles, in as many registers as the machine needs for them.
using Lanes = double __attribute__((vector_size(64)));
static_assert(kFan == 8 && kLeaf == 16);

/// Bounds and totals are rounded differently by this much at most, relative to 1 + |total|.
constexpr double kRounding = 1e-12;

struct View {
  const NeighbourTree::Node* nodes;
  const double* boxes;
  const double* points;
  const double* keys;
  const Eigen::Index* rows;
  const double* weight;
  const double* period;
  int joints;
  bool squared;
};

struct Query {
  const double* target;
  const double* max_step;
};

struct Pending {
  double bound;
  std::int32_t id;
};

WRISTWISE_IN_CLONES void load(Lanes& lanes, const double* from) {
  __builtin_memcpy(&lanes, from, sizeof lanes);
}

/// |value - target|, or the shorter way round.
WRISTWISE_IN_CLONES void step_between(Lanes& step, const Lanes& values, double target,
                                      double period) {
  step = values - target;
  step = step < 0 ? -step : step;
  const Lanes back = period - step;
  step = back < step ? back : step;
}

WRISTWISE_IN_CLONES void bound_children(const View& tree, std::int32_t node, const Query& query,
                                        double* bounds) {
  Lanes sum;
  load(sum, tree.nodes[node].least.data());
  const std::ptrdiff_t length = std::ptrdiff_t{kFan} * tree.joints;
  const double* middle = tree.boxes + 2 * length * node;
  const double* half = middle + length;
  for (int j = 0; j < tree.joints; ++j, middle += kFan, half += kFan) {
    Lanes m, h, step;
    load(m, middle);
    load(h, half);
    step_between(step, m, query.target[j], tree.period[j]);
    step -= h;
    step = step < 0 ? step * 0 : step;
    sum += tree.weight[j] * (tree.squared ? step * step : step);
  }
  __builtin_memcpy(bounds, &sum, sizeof sum);
}

WRISTWISE_IN_CLONES void scan_leaf(const View& tree, std::int32_t leaf, const Query& query,
                                   NeighbourTree::Nearest& best) {
  const double* point = tree.points + static_cast<std::ptrdiff_t>(leaf) * kLeaf * tree.joints;
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(leaf) * kLeaf;
  Lanes low, high;
  load(low, tree.keys + first);
  load(high, tree.keys + first + kFan);
  for (int j = 0; j < tree.joints; ++j, point += kLeaf) {
    Lanes a, b, step_a, step_b;
    load(a, point);
    load(b, point + kFan);
    step_between(step_a, a, query.target[j], tree.period[j]);
    step_between(step_b, b, query.target[j], tree.period[j]);
    const double w = tree.weight[j];
    low += w * (tree.squared ? step_a * step_a : step_a);
    high += w * (tree.squared ? step_b * step_b : step_b);
    if (query.max_step != nullptr) {
      const Lanes never = Lanes{} + kInfinity;
      low = step_a > query.max_step[j] ? never : low;
      high = step_b > query.max_step[j] ? never : high;
    }
  }
  const Lanes least = low < high ? low : high;
  bool any = false;
  for (int lane = 0; lane < kFan; ++lane) any |= least[lane] <= best.total;
  if (!any) return;
  for (int lane = 0; lane < kLeaf; ++lane) {
    const double total = lane < kFan ? low[lane] : high[lane - kFan];
    const Eigen::Index row = tree.rows[first + lane];
    if (total < best.total ||
        (total == best.total && total < kInfinity && (best.index < 0 || row < best.index))) {
      best = {total, row};
    }
  }
}

WRISTWISE_VECTOR_CLONES
void search(const View& tree, const Query& query, NeighbourTree::Nearest& best,
            std::size_t& leaves) {
  Pending stack[128];
  int size = 0;
  stack[size++] = {-kInfinity, 0};
  while (size > 0) {
    const Pending next = stack[--size];
    const double worth = best.total + kRounding * (1 + std::abs(best.total));
    if (next.bound > worth) continue;
    if (next.id < 0) {
      ++leaves;
      scan_leaf(tree, ~next.id, query, best);
      continue;
    }
    double bounds[kFan];
    bound_children(tree, next.id, query, bounds);
    const int base = size;
    for (int slot = 0; slot < kFan; ++slot) {
      if (!(bounds[slot] <= worth) || bounds[slot] == kInfinity) continue;
      int at = size++;  // the nearest on top
      for (; at > base && stack[at - 1].bound < bounds[slot]; --at) stack[at] = stack[at - 1];
      stack[at] = {bounds[slot], tree.nodes[next.id].child[static_cast<std::size_t>(slot)]};
    }
  }
}

}  // namespace

NeighbourTree::NeighbourTree(const Eigen::ArrayXXd& positions, const JointMetric& metric)
    : metric_(metric), place_(static_cast<std::size_t>(positions.rows())) {
  order_.resize(place_.size());
  std::iota(order_.begin(), order_.end(), Eigen::Index{0});
  if (order_.empty()) return;
  if (order_.size() <= kLeaf) {
    nodes_.emplace_back();
    nodes_[0].least.fill(kInfinity);
    boxes_.assign(std::size_t{2} * kFan * static_cast<std::size_t>(metric_.joints()), 0);
    nodes_[0].child[0] = add_leaf(positions, {0, order_.size()});
    set_box(positions, 0, 0, {0, order_.size()});
  } else {
    build(positions, {0, order_.size()});
  }
}

std::int32_t NeighbourTree::build(const Eigen::ArrayXXd& positions, Range range) {
  if (range.second - range.first <= kLeaf) return add_leaf(positions, range);
  const auto node = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.back().least.fill(kInfinity);
  boxes_.resize(boxes_.size() + std::size_t{2} * kFan * static_cast<std::size_t>(metric_.joints()),
                0);
  int slot = 0;
  for (const Range& part : split(positions, range)) {
    set_box(positions, node, slot, part);
    const std::int32_t child = build(positions, part);
    nodes_[static_cast<std::size_t>(node)].child[static_cast<std::size_t>(slot++)] = child;
  }
  return node;
}

/// Up to eight parts, by halving three times; a part that fits into a leaf stays whole.
std::vector<NeighbourTree::Range> NeighbourTree::split(const Eigen::ArrayXXd& positions,
                                                       Range range) {
  std::vector<Range> parts = {range};
  for (int round = 0; round < 3; ++round) {
    std::vector<Range> halves;
    for (const Range& part : parts) {
      if (part.second - part.first <= kLeaf) {
        halves.push_back(part);
        continue;
      }
      const std::size_t middle = part.first + (part.second - part.first) / 2;
      halve(positions, part, middle);
      halves.push_back({part.first, middle});
      halves.push_back({middle, part.second});
    }
    parts = std::move(halves);
  }
  return parts;
}

/// Across the joint whose values cost the most to cross.
void NeighbourTree::halve(const Eigen::ArrayXXd& positions, Range range, std::size_t middle) {
  Eigen::Index widest = 0;
  double width = -1;
  for (Eigen::Index j = 0; j < positions.cols(); ++j) {
    double low = kInfinity, high = -kInfinity;
    for (std::size_t k = range.first; k < range.second; ++k) {
      const double value = positions(order_[k], j);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (metric_.weight[j] * (high - low) <= width) continue;
    width = metric_.weight[j] * (high - low);
    widest = j;
  }
  const auto at = [this](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(range.first), at(middle), at(range.second),
                   [&](Eigen::Index a, Eigen::Index b) {
                     const double qa = positions(a, widest), qb = positions(b, widest);
                     return qa != qb ? qa < qb : a < b;
                   });
}

void NeighbourTree::set_box(const Eigen::ArrayXXd& positions, std::int32_t node, int slot,
                            Range range) {
  const int joints = metric_.joints();
  double* const middle = boxes_.data() + static_cast<std::ptrdiff_t>(node) * 2 * kFan * joints;
  for (int j = 0; j < joints; ++j) {
    double low = kInfinity, high = -kInfinity;
    for (std::size_t k = range.first; k < range.second; ++k) {
      const double value = positions(order_[k], j);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    middle[j * kFan + slot] = (low + high) / 2;
    middle[(joints + j) * kFan + slot] = (high - low) / 2;
  }
}

std::int32_t NeighbourTree::add_leaf(const Eigen::ArrayXXd& positions, Range range) {
  const std::size_t first = keys_.size();
  const auto joints = static_cast<std::size_t>(metric_.joints());
  keys_.resize(first + kLeaf, kInfinity);
  rows_.resize(first + kLeaf, -1);
  points_.resize(points_.size() + kLeaf * joints, 0);
  double* const points = points_.data() + first * joints;
  for (std::size_t k = range.first; k < range.second; ++k) {
    const std::size_t lane = k - range.first;
    rows_[first + lane] = order_[k];
    place_[static_cast<std::size_t>(order_[k])] = first + lane;
    for (std::size_t j = 0; j < joints; ++j) {
      points[j * kLeaf + lane] = positions(order_[k], static_cast<Eigen::Index>(j));
    }
  }
  return ~static_cast<std::int32_t>(first / kLeaf);
}

void NeighbourTree::set_keys(const Eigen::ArrayXd& keys) {
  for (std::size_t row = 0; row < place_.size(); ++row) {
    keys_[place_[row]] = keys[static_cast<Eigen::Index>(row)];
  }
  for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
    for (std::size_t slot = 0; slot < kFan; ++slot) {
      const std::int32_t child = node->child[slot];
      if (child == 0) continue;  // no child: the root is nobody's
      if (child > 0) {
        const auto& least = nodes_[static_cast<std::size_t>(child)].least;
        node->least[slot] = *std::min_element(least.begin(), least.end());
      } else {
        const auto first = keys_.begin() + static_cast<std::ptrdiff_t>(~child) * kLeaf;
        node->least[slot] = *std::min_element(first, first + kLeaf);
      }
    }
  }
}

void NeighbourTree::start_from(Eigen::Index row, const double* target, const double* max_step,
                               Nearest& best) const {
  const std::size_t place = place_[static_cast<std::size_t>(row)];
  const std::size_t lane = place % kLeaf;
  const double* const point =
      points_.data() + (place - lane) * static_cast<std::size_t>(metric_.joints()) + lane;
  double total = keys_[place];
  for (int j = 0; j < metric_.joints(); ++j) {
    const double step = metric_.step(j, target[j], point[std::ptrdiff_t{kLeaf} * j]);
    if (max_step != nullptr && step > max_step[j]) return;
    total += metric_.weight[j] * (metric_.squared ? step * step : step);
  }
  if (total <= best.total && total < kInfinity) best = {total, row};
}

NeighbourTree::Nearest NeighbourTree::nearest(const double* target, const double* max_step,
                                              double limit, Eigen::Index hint,
                                              std::size_t& evaluated) const {
  Nearest best{limit, -1};
  if (nodes_.empty()) return {};
  const View tree{nodes_.data(),         boxes_.data(),    points_.data(),
                  keys_.data(),          rows_.data(),     metric_.weight.data(),
                  metric_.period.data(), metric_.joints(), metric_.squared};
  const Query query{target, max_step};
  std::size_t leaves = 0;
  if (hint >= 0) start_from(hint, query.target, max_step, best);
  search(tree, query, best, leaves);
  evaluated += leaves * kLeaf;
  return best.index < 0 ? Nearest{} : best;
}

}  // namespace wristwise
