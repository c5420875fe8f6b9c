#include "graph/ladder_graph.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <queue>
#include <random>
#include <set>

#include "cancelled.hpp"

namespace wristwise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Instance {
  std::vector<Rung> rungs;
  EdgeRules rules;
};

Instance random_instance(unsigned seed, int rungs, int largest, int joints) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1), cost(0, 0.3);
  std::uniform_int_distribution<int> size(1, largest);
  Instance instance;
  for (int i = 0; i < rungs; ++i) {
    Rung rung;
    const int count = size(random);
    rung.positions = Eigen::ArrayXXd::NullaryExpr(count, joints, [&] { return value(random); });
    rung.cost = Eigen::ArrayXd::NullaryExpr(count, [&] { return cost(random); });
    instance.rungs.push_back(rung);
  }
  instance.rules.weight = JointVector::NullaryExpr(joints, [&] { return 0.5 + cost(random); });
  instance.rules.max_step.assign(static_cast<std::size_t>(rungs - 1),
                                 JointVector::Constant(joints, kInfinity));
  return instance;
}

/// A textbook Dijkstra on explicit edges.
double dijkstra(const Instance& instance) {
  using State = std::pair<double, std::pair<std::size_t, Eigen::Index>>;
  std::priority_queue<State, std::vector<State>, std::greater<>> queue;
  std::vector<std::vector<double>> distance;
  for (const Rung& rung : instance.rungs) {
    distance.emplace_back(static_cast<std::size_t>(rung.size()), kInfinity);
  }
  for (Eigen::Index v = 0; v < instance.rungs[0].size(); ++v) {
    distance[0][static_cast<std::size_t>(v)] = instance.rungs[0].cost[v];
    queue.push({instance.rungs[0].cost[v], {0, v}});
  }
  while (!queue.empty()) {
    const auto [d, at] = queue.top();
    queue.pop();
    const auto [i, u] = at;
    if (d > distance[i][static_cast<std::size_t>(u)]) continue;
    if (i + 1 == instance.rungs.size()) return d;
    for (Eigen::Index v = 0; v < instance.rungs[i + 1].size(); ++v) {
      const JointVector from = instance.rungs[i].vertex(u), to = instance.rungs[i + 1].vertex(v);
      double edge = instance.rungs[i + 1].cost[v];
      bool allowed = true;
      for (int j = 0; j < from.size(); ++j) {
        edge += instance.rules.weight[j] * std::abs(to[j] - from[j]);
        allowed = allowed && std::abs(to[j] - from[j]) <= instance.rules.max_step[i][j];
      }
      if (!allowed || (instance.rules.is_clear && !instance.rules.is_clear(0, i, from, to)))
        continue;
      double& known = distance[i + 1][static_cast<std::size_t>(v)];
      if (d + edge < known) {
        known = d + edge;
        queue.push({known, {i + 1, v}});
      }
    }
  }
  return kInfinity;
}

double cost_along(const Instance& instance, const LadderPath& path) {
  double cost = 0;
  for (std::size_t i = 0; i < path.vertices.size(); ++i) {
    cost += instance.rungs[i].cost[path.vertices[i]];
    if (i == 0) continue;
    cost += instance.rules.weight.dot((instance.rungs[i].vertex(path.vertices[i]) -
                                       instance.rungs[i - 1].vertex(path.vertices[i - 1]))
                                          .cwiseAbs());
  }
  return cost;
}

TEST(LeastCostPath, EqualsDijkstra) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Instance instance = random_instance(seed, 8, 40, 1 + static_cast<int>(seed % 7));
    const LadderPath path = find_least_cost_path(instance.rungs, instance.rules, 2, {});
    ASSERT_TRUE(path.found);
    EXPECT_NEAR(path.cost, dijkstra(instance), 1e-12);
    EXPECT_NEAR(path.cost, cost_along(instance, path), 1e-12);
  }
}

TEST(LeastCostPath, KeepsTheStepLimit) {
  int infeasible = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Instance instance = random_instance(seed, 6, 12, 2);
    for (JointVector& limit : instance.rules.max_step) limit << 0.5, kInfinity;
    const LadderPath path = find_least_cost_path(instance.rungs, instance.rules, 1, {});
    const double expected = dijkstra(instance);
    EXPECT_EQ(path.found, expected < kInfinity);
    if (path.found) {
      EXPECT_NEAR(path.cost, expected, 1e-12);
    } else {
      ++infeasible;
    }
  }
  EXPECT_GT(infeasible, 0);
  EXPECT_LT(infeasible, 60);
}

/// Moves are blocked at random, from rarely to nearly always, so that both ways of checking run.
TEST(LeastCostPath, WithBlockedMovesEqualsDijkstra) {
  int infeasible = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Instance instance = random_instance(seed, 6, 25, 3);
    const double share = (seed % 10) / 10.0 + 0.08;
    instance.rules.is_clear = [share](int, std::size_t i, const JointVector& from,
                                      const JointVector& to) {
      const double hash = std::sin(1e3 * from.sum() + 7e3 * to.sum() + static_cast<double>(i));
      return std::abs(hash * 1e4 - std::floor(hash * 1e4)) > share;
    };
    const LadderPath path = find_least_cost_path(instance.rungs, instance.rules, 2, {});
    const double expected = dijkstra(instance);
    ASSERT_EQ(path.found, expected < kInfinity) << seed;
    if (!path.found) {
      ++infeasible;
      continue;
    }
    EXPECT_NEAR(path.cost, expected, 1e-12);
    for (std::size_t i = 0; i + 1 < path.vertices.size(); ++i) {
      EXPECT_TRUE(instance.rules.is_clear(0, i, instance.rungs[i].vertex(path.vertices[i]),
                                          instance.rungs[i + 1].vertex(path.vertices[i + 1])));
    }
  }
  EXPECT_GT(infeasible, 0);
}

TEST(LeastCostPath, ChecksFewMovesWhereNoneIsBlocked) {
  Instance instance = random_instance(5, 10, 50, 3);
  instance.rules.is_clear = [](int, std::size_t, const JointVector&, const JointVector&) {
    return true;
  };
  const LadderPath path = find_least_cost_path(instance.rungs, instance.rules, 2, {});
  EXPECT_EQ(path.statistics.clear_checks, 9U);
}

TEST(LeastCostPath, DoesNotDependOnTheNumberOfThreads) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Instance instance = random_instance(seed, 8, 40, 3);
    // Coarse values make many ties.
    for (Rung& rung : instance.rungs) {
      rung.positions = (rung.positions * 3).round();
      rung.cost.setZero();
    }
    instance.rules.weight.setOnes();
    const auto one = find_least_cost_path(instance.rungs, instance.rules, 1, {});
    const auto many = find_least_cost_path(instance.rungs, instance.rules, 5, {});
    EXPECT_EQ(one.vertices, many.vertices);
  }
}

TEST(LeastCostPath, GivesTheBestPartWhereTheWayIsBlocked) {
  Instance instance = random_instance(3, 6, 10, 2);
  instance.rules.is_clear = [](int, std::size_t i, const JointVector&, const JointVector&) {
    return i != 3;
  };
  const LadderPath path = find_least_cost_path(instance.rungs, instance.rules, 2, {});
  EXPECT_FALSE(path.found);
  EXPECT_EQ(path.vertices.size(), 4U);
}

TEST(LeastCostPath, OfASingleRungIsItsCheapestVertex) {
  const Instance instance = random_instance(4, 1, 10, 2);
  const LadderPath path = find_least_cost_path(instance.rungs, instance.rules, 2, {});
  EXPECT_TRUE(path.found);
  EXPECT_DOUBLE_EQ(path.cost, instance.rungs[0].cost.minCoeff());
}

TEST(LeastCostPath, StopsWhenCancelled) {
  const Instance instance = random_instance(4, 3, 10, 2);
  const std::atomic<bool> cancel{true};
  Monitor monitor;
  monitor.cancel = &cancel;
  EXPECT_THROW(find_least_cost_path(instance.rungs, instance.rules, 1, monitor), Cancelled);
}

}  // namespace
}  // namespace wristwise
