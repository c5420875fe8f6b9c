#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "graph/joint_metric.hpp"

namespace wristwise {

/// A k-d tree over configurations that finds the one with the least key + cost: an additively
/// weighted nearest neighbour. Each cell holds the least key below it, so that the search looks
/// only at cells with  least key + cost to the cell's box <= best so far  (F18).
class NeighbourTree {
 public:
  struct Nearest {
    double total = kInfinity;  ///< key + cost
    Eigen::Index index = -1;   ///< row of `positions`; -1: none
  };

  /// @param positions points x joints, rad and m
  NeighbourTree(const Eigen::ArrayXXd& positions, const JointMetric& metric);

  /// @param keys one for each row; infinity takes the point out
  void set_keys(const Eigen::ArrayXd& keys);

  /// The point with the least key + cost to `target` among those with a total <= `limit` and no
  /// step longer than `max_step` (one per joint; null: any). The lower index wins among equals.
  /// @param hint a point to start from: a good one makes the search faster, not different
  /// @param evaluated is increased by the number of points looked at
  Nearest nearest(const double* target, const double* max_step, double limit, Eigen::Index hint,
                  std::size_t& evaluated) const;

  /// Rows in the order of the tree: neighbours in this order are near each other.
  const std::vector<Eigen::Index>& order() const { return order_; }

  static constexpr int kFan = 8;
  static constexpr int kLeaf = 16;

  struct Node {  ///< the boxes of its children follow in boxes_
    std::array<double, kFan> least{};
    std::array<std::int32_t, kFan> child{};  ///< a node, or ~leaf
  };

 private:
  using Range = std::pair<std::size_t, std::size_t>;

  std::int32_t build(const Eigen::ArrayXXd& positions, Range range);
  std::int32_t add_leaf(const Eigen::ArrayXXd& positions, Range range);
  std::vector<Range> split(const Eigen::ArrayXXd& positions, Range range);
  void halve(const Eigen::ArrayXXd& positions, Range range, std::size_t middle);
  void start_from(Eigen::Index row, const double* target, const double* max_step,
                  Nearest& best) const;
  void set_box(const Eigen::ArrayXXd& positions, std::int32_t node, int slot, Range range);

  JointMetric metric_;
  std::vector<Eigen::Index> order_;
  std::vector<Node> nodes_;         ///< parents before children; the root first
  std::vector<double> boxes_;       ///< node, middle or half width, joint, child
  std::vector<double> points_;      ///< leaf, joint, lane
  std::vector<double> keys_;        ///< leaf, lane
  std::vector<Eigen::Index> rows_;  ///< leaf, lane
  std::vector<std::size_t> place_;  ///< row -> leaf * kLeaf + lane
};

}  // namespace wristwise
