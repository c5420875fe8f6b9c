#include "graph/neighbour_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wristwise {
namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr int kSizes[] = {1, 15, 16, 17, 100, 3000};

struct Points {
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd keys;
  JointMetric metric;
};

struct Query {
  JointVector target;
  JointVector max_step;  ///< empty: any
  double limit = kInfinity;
};

NeighbourTree::Nearest brute_force(const Points& points, const Query& query) {
  NeighbourTree::Nearest best;
  for (Eigen::Index u = 0; u < points.positions.rows(); ++u) {
    double total = points.keys[u];
    for (int j = 0; j < points.positions.cols(); ++j) {
      const double period = points.metric.period[j];
      const double straight = points.positions(u, j) - query.target[j];
      double step = std::abs(straight);
      if (std::isfinite(period)) {
        step = std::min({step, std::abs(straight + period), std::abs(straight - period)});
      }
      if (query.max_step.size() > 0 && step > query.max_step[j]) total = kInfinity;
      total += points.metric.weight[j] * (points.metric.squared ? step * step : step);
    }
    if (total <= query.limit && total < best.total) best = {total, u};
  }
  return best;
}

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Points scattered(int count, int joints, bool circular, bool squared) {
    Points points;
    points.metric.squared = squared;
    points.metric.weight = JointVector::NullaryExpr(joints, [&] { return uniform(0.1, 2); });
    points.metric.period = JointVector::NullaryExpr(
        joints, [&] { return circular && integer(0, 2) > 0 ? kTurn : kInfinity; });
    points.positions = Eigen::ArrayXXd::NullaryExpr(count, joints, [&] { return angle(); });
    points.keys = Eigen::ArrayXd::NullaryExpr(count, [&] { return uniform(0, 1); });
    return points;
  }

  /// Values that add up without round-off, so that ties are exact.
  Points on_a_grid(int count, int joints, bool circular, bool squared) {
    Points points = scattered(count, joints, circular, squared);
    for (double& weight : points.metric.weight) weight = integer(0, 2);
    for (double& period : points.metric.period) period = std::isfinite(period) ? 8 : kInfinity;
    points.positions =
        Eigen::ArrayXXd::NullaryExpr(count, joints, [&] { return double(integer(-4, 4)); });
    points.keys = Eigen::ArrayXd::NullaryExpr(count, [&] { return 0.5 * integer(0, 3); });
    return points;
  }

  double angle() { return uniform(-kTurn / 2, kTurn / 2); }

  double near_the_seam() {
    const double inside = kTurn / 2 - std::pow(10, uniform(-17, -1));
    return integer(0, 1) == 0 ? inside : -inside;
  }

 private:
  std::mt19937 random_;
};

JointVector target_on_the_grid(RandomPoints& dice, int joints) {
  return JointVector::NullaryExpr(joints, [&] { return double(dice.integer(-4, 4)); });
}

JointVector scattered_target(RandomPoints& dice, int joints) {
  return JointVector::NullaryExpr(
      joints, [&] { return dice.integer(0, 2) == 0 ? dice.near_the_seam() : dice.angle(); });
}

NeighbourTree::Nearest ask(const NeighbourTree& tree, const Query& query, Eigen::Index hint = -1) {
  std::size_t evaluated = 0;
  const double* const max_step = query.max_step.size() > 0 ? query.max_step.data() : nullptr;
  return tree.nearest(query.target.data(), max_step, query.limit, hint, evaluated);
}

void expect_same(const NeighbourTree::Nearest& found, const NeighbourTree::Nearest& expected) {
  EXPECT_EQ(found.total, expected.total);
  EXPECT_EQ(found.index, expected.index);
}

/// The query as it is, with limits round the optimum, and with hints.
void expect_brute_force(const NeighbourTree& tree, const Points& points, Query query,
                        RandomPoints& dice) {
  const auto best = brute_force(points, query);
  expect_same(ask(tree, query), best);
  const int last = static_cast<int>(points.positions.rows()) - 1;
  for (int k = 0; k < 3; ++k) expect_same(ask(tree, query, dice.integer(0, last)), best);
  if (best.index < 0) return;
  expect_same(ask(tree, query, best.index), best);
  query.limit = best.total;
  expect_same(ask(tree, query), best);
  expect_same(ask(tree, query, dice.integer(0, last)), best);
  query.limit = std::nextafter(best.total, -kInfinity);
  expect_same(ask(tree, query), {});
  expect_same(ask(tree, query, best.index), {});
}

/// Every number of joints, every size, both costs, line and circle.
template <typename Body>
void for_every_shape(const Body& body) {
  for (int joints = 1; joints <= 16; ++joints) {
    for (const int size : kSizes) {
      for (const bool circular : {false, true}) {
        for (const bool squared : {false, true}) {
          SCOPED_TRACE(testing::Message() << joints << " joints, " << size << " points, circular "
                                          << circular << ", squared " << squared);
          body(joints, size, circular, squared);
          if (testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

TEST(NeighbourTree, EqualsBruteForce) {
  RandomPoints dice(1);
  for_every_shape([&](int joints, int size, bool circular, bool squared) {
    const Points points = dice.scattered(size, joints, circular, squared);
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    for (int k = 0; k < 6; ++k) {
      expect_brute_force(tree, points, {scattered_target(dice, joints), {}}, dice);
    }
  });
}

TEST(NeighbourTree, GivesTheLowestIndexAmongTies) {
  RandomPoints dice(2);
  for_every_shape([&](int joints, int size, bool circular, bool squared) {
    const Points points = dice.on_a_grid(size, joints, circular, squared);
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    for (int k = 0; k < 6; ++k) {
      expect_brute_force(tree, points, {target_on_the_grid(dice, joints), {}}, dice);
    }
  });
}

TEST(NeighbourTree, KeepsTheStepLimit) {
  RandomPoints dice(3);
  int none = 0;
  for_every_shape([&](int joints, int size, bool circular, bool squared) {
    const Points points = dice.on_a_grid(size, joints, circular, squared);
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    for (int k = 0; k < 4; ++k) {
      Query query{target_on_the_grid(dice, joints), {}};
      query.max_step = JointVector::NullaryExpr(
          joints, [&] { return dice.integer(0, 2) == 0 ? double(dice.integer(1, 3)) : kInfinity; });
      expect_brute_force(tree, points, query, dice);
      none += brute_force(points, query).index < 0;
    }
  });
  EXPECT_GT(none, 10);
}

TEST(NeighbourTree, LeavesOutInfiniteKeys) {
  RandomPoints dice(4);
  for_every_shape([&](int joints, int size, bool circular, bool squared) {
    Points points = dice.scattered(size, joints, circular, squared);
    NeighbourTree tree(points.positions, points.metric);
    for (const double share : {0.5, 0.95, 1.0}) {
      for (double& key : points.keys) key = dice.uniform(0, 1) < share ? kInfinity : 0.5;
      tree.set_keys(points.keys);
      for (int k = 0; k < 2; ++k) {
        expect_brute_force(tree, points, {scattered_target(dice, joints), {}}, dice);
      }
    }
  });
}

TEST(NeighbourTree, FindsTheOnlyPointLeft) {
  RandomPoints dice(11);
  for (const int size : {17, 129, 1000, 3000}) {
    Points points = dice.scattered(size, 3, true, false);
    NeighbourTree tree(points.positions, points.metric);
    for (int k = 0; k < 300; ++k) {
      const int only = dice.integer(0, size - 1);
      points.keys.setConstant(k % 2 == 0 ? kInfinity : 100);
      points.keys[only] = 0;
      tree.set_keys(points.keys);
      EXPECT_EQ(ask(tree, {scattered_target(dice, 3), {}}).index, only);
    }
  }
}

TEST(NeighbourTree, TakesKeysBelowZero) {
  RandomPoints dice(5);
  for (int k = 0; k < 100; ++k) {
    Points points = dice.on_a_grid(500, 1 + k % 5, k % 2 == 0, k % 3 == 0);
    points.keys -= dice.integer(1, 3000);
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    const JointVector target = target_on_the_grid(dice, points.metric.joints());
    expect_brute_force(tree, points, {target, {}}, dice);
    if (HasFailure()) return;
  }
}

TEST(NeighbourTree, TakesWeightsOfZero) {
  RandomPoints dice(6);
  for (const int size : kSizes) {
    Points points = dice.scattered(size, 3, true, false);
    points.metric.weight.setZero();
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    expect_brute_force(tree, points, {scattered_target(dice, 3), {}}, dice);
    tree.set_keys(points.keys.setConstant(2));
    EXPECT_EQ(ask(tree, {scattered_target(dice, 3), {}}).index, 0);
  }
}

TEST(NeighbourTree, TakesDuplicates) {
  RandomPoints dice(7);
  for (const int size : kSizes) {
    Points points = dice.scattered(size, 4, true, false);
    points.positions.rowwise() = points.positions.row(0).eval();
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    expect_brute_force(tree, points, {scattered_target(dice, 4), {}}, dice);
    tree.set_keys(points.keys.setConstant(1));
    expect_brute_force(tree, points, {scattered_target(dice, 4), {}}, dice);
  }
}

TEST(NeighbourTree, GivesTheSameForEveryHint) {
  RandomPoints dice(8);
  for (int k = 0; k < 10; ++k) {
    const Points points =
        k % 2 == 0 ? dice.on_a_grid(200, 3, true, false) : dice.scattered(200, 6, true, k % 4 == 1);
    NeighbourTree tree(points.positions, points.metric);
    tree.set_keys(points.keys);
    const Query query{k % 2 == 0 ? target_on_the_grid(dice, 3) : scattered_target(dice, 6), {}};
    const auto best = brute_force(points, query);
    for (Eigen::Index hint = -1; hint < 200; ++hint) expect_same(ask(tree, query, hint), best);
  }
}

TEST(NeighbourTree, LooksAtFewPointsWhereTheyAreMany) {
  RandomPoints dice(9);
  Points points = dice.scattered(3000, 2, true, false);
  points.keys.setZero();
  NeighbourTree tree(points.positions, points.metric);
  tree.set_keys(points.keys);
  std::size_t evaluated = 0;
  for (int k = 0; k < 100; ++k) {
    tree.nearest(scattered_target(dice, 2).data(), nullptr, kInfinity, -1, evaluated);
  }
  EXPECT_LT(evaluated, 100U * 300U);
}

TEST(NeighbourTree, OrdersEveryRowOnce) {
  RandomPoints dice(10);
  for (const int size : kSizes) {
    const Points points = dice.scattered(size, 3, true, false);
    auto order = NeighbourTree(points.positions, points.metric).order();
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), static_cast<std::size_t>(size));
    for (int k = 0; k < size; ++k) EXPECT_EQ(order[static_cast<std::size_t>(k)], k);
  }
}

TEST(NeighbourTree, OfNoPointsFindsNone) {
  NeighbourTree tree(Eigen::ArrayXXd(0, 2),
                     {JointVector::Ones(2), JointVector::Constant(2, kInfinity), false});
  tree.set_keys({});
  EXPECT_EQ(ask(tree, {JointVector::Zero(2), {}}).index, -1);
}

}  // namespace
}  // namespace wristwise
