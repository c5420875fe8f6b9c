#include "kinematics/nearest_keys.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace wristwise {
namespace {

constexpr int kLeafSize = 12;

}  // namespace

NearestKeys::NearestKeys(std::vector<Key> keys) : keys_(std::move(keys)), order_(keys_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<int>(keys_.size()));
  std::vector<Key> in_order;
  in_order.reserve(keys_.size());
  for (const int index : order_) in_order.push_back(keys_[static_cast<std::size_t>(index)]);
  keys_ = std::move(in_order);
}

int NearestKeys::build(int begin, int end) {
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({begin, end, -1, -1, 0, 0});
  if (end - begin <= kLeafSize) return node;
  const auto key = [this](int index) -> const Key& {
    return keys_[static_cast<std::size_t>(index)];
  };
  Key least = key(order_[static_cast<std::size_t>(begin)]), most = least;
  for (int i = begin; i < end; ++i) {
    least = least.cwiseMin(key(order_[static_cast<std::size_t>(i)]));
    most = most.cwiseMax(key(order_[static_cast<std::size_t>(i)]));
  }
  Eigen::Index widest = 0;
  (most - least).maxCoeff(&widest);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int a, int b) {
                     return std::make_pair(key(a)[widest], a) < std::make_pair(key(b)[widest], b);
                   });
  const double split = key(order_[static_cast<std::size_t>(middle)])[widest];
  const int low = build(begin, middle);
  const int high = build(middle, end);
  nodes_[static_cast<std::size_t>(node)] = {begin, end, low, high, static_cast<int>(widest), split};
  return node;
}

void NearestKeys::find(const Key& key, std::size_t count, std::vector<Neighbour>& nearest) const {
  nearest.clear();
  if (count > 0) search(0, key, count, nearest);
  std::sort_heap(nearest.begin(), nearest.end());
}

void NearestKeys::search(int index, const Key& key, std::size_t count,
                         std::vector<Neighbour>& heap) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  if (node.low < 0) {
    for (int i = node.begin; i < node.end; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const Neighbour candidate{(keys_[place] - key).squaredNorm(), order_[place]};
      if (heap.size() == count) {
        if (!(candidate < heap.front())) continue;
        std::pop_heap(heap.begin(), heap.end());
        heap.back() = candidate;
      } else {
        heap.push_back(candidate);
      }
      std::push_heap(heap.begin(), heap.end());
    }
    return;
  }
  const double beyond = key[node.coordinate] - node.split;
  search(beyond < 0 ? node.low : node.high, key, count, heap);
  if (heap.size() < count || beyond * beyond <= heap.front().square)
    search(beyond < 0 ? node.high : node.low, key, count, heap);
}

}  // namespace wristwise
