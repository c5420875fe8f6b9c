#include "graph/path_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wristwise {
namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr std::size_t kAll = 1000000;

struct Instance {
  std::vector<Rung> rungs;
  JointMetric metric;
  std::vector<std::vector<char>> blocked;

  PathBounds::IsBlocked is_blocked() const {
    return [this](std::size_t rung, Eigen::Index v) {
      return blocked[rung][static_cast<std::size_t>(v)] != 0;
    };
  }
};

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

 private:
  std::mt19937 random_;
};

double wrapped(double angle) { return std::remainder(angle, kTurn); }

Rung random_rung(Dice& dice, int joints) {
  Rung rung;
  const int count = dice.integer(1, 60);
  rung.positions = Eigen::ArrayXXd::NullaryExpr(
      count, joints, [&] { return dice.uniform(-kTurn / 2, kTurn / 2); });
  rung.cost = Eigen::ArrayXd::NullaryExpr(count, [&] { return dice.uniform(-0.5, 0.5); });
  return rung;
}

/// The rung before, a little farther on: as along a seam.
Rung drifted(Dice& dice, const Rung& before) {
  Rung rung = before;
  for (double& value : rung.positions.reshaped()) value = wrapped(value + dice.uniform(-0.05, 0.1));
  rung.cost += 0.1 * dice.uniform(-1, 1);
  return rung;
}

Instance random_instance(unsigned seed, double blocked_share) {
  Dice dice(seed);
  Instance instance;
  const int rungs = dice.integer(5, 30), joints = dice.integer(1, 6);
  const bool circular = seed % 2 == 0, along_a_seam = seed % 3 == 0;
  for (int i = 0; i < rungs; ++i) {
    const bool new_rung = i == 0 || !along_a_seam;
    instance.rungs.push_back(new_rung ? random_rung(dice, joints)
                                      : drifted(dice, instance.rungs.back()));
    const auto count = static_cast<std::size_t>(instance.rungs.back().size());
    std::vector<char>& blocked = instance.blocked.emplace_back(count, char{0});
    for (char& flag : blocked) flag = dice.uniform(0, 1) < blocked_share;
  }
  instance.metric.weight = JointVector::NullaryExpr(joints, [&] { return dice.uniform(0, 1.5); });
  instance.metric.period = JointVector::NullaryExpr(
      joints, [&] { return circular && dice.integer(0, 1) == 0 ? kTurn : kInfinity; });
  return instance;
}

double edge(const Instance& instance, std::size_t i, Eigen::Index u, Eigen::Index v) {
  double sum = 0;
  for (int j = 0; j < instance.metric.weight.size(); ++j) {
    const double straight =
        instance.rungs[i + 1].positions(v, j) - instance.rungs[i].positions(u, j);
    const double step =
        std::abs(std::isfinite(instance.metric.period[j]) ? wrapped(straight) : straight);
    sum += instance.metric.weight[j] * (instance.metric.squared ? step * step : step);
  }
  return sum;
}

/// The cost of the best path through each vertex, by looking at every edge.
std::vector<Eigen::ArrayXd> best_through(const Instance& instance) {
  const std::size_t rungs = instance.rungs.size();
  std::vector<Eigen::ArrayXd> own(rungs), before(rungs), after(rungs), through(rungs);
  for (std::size_t i = 0; i < rungs; ++i) {
    own[i] = instance.rungs[i].cost;
    for (Eigen::Index v = 0; v < own[i].size(); ++v) {
      if (instance.blocked[i][static_cast<std::size_t>(v)]) own[i][v] = kInfinity;
    }
    before[i] = own[i];
    after[i] = Eigen::ArrayXd::Constant(own[i].size(), i + 1 == rungs ? 0 : kInfinity);
  }
  for (std::size_t i = 0; i + 1 < rungs; ++i) {
    before[i + 1].setConstant(kInfinity);
    for (Eigen::Index v = 0; v < own[i + 1].size(); ++v) {
      for (Eigen::Index u = 0; u < own[i].size(); ++u) {
        before[i + 1][v] =
            std::min(before[i + 1][v], before[i][u] + edge(instance, i, u, v) + own[i + 1][v]);
      }
    }
  }
  for (std::size_t i = rungs - 1; i-- > 0;) {
    for (Eigen::Index u = 0; u < own[i].size(); ++u) {
      for (Eigen::Index v = 0; v < own[i + 1].size(); ++v) {
        after[i][u] =
            std::min(after[i][u], edge(instance, i, u, v) + own[i + 1][v] + after[i + 1][v]);
      }
    }
  }
  for (std::size_t i = 0; i < rungs; ++i) through[i] = before[i] + after[i];
  return through;
}

bool contains(const Corridor& corridor, std::size_t rung, Eigen::Index vertex) {
  return std::binary_search(corridor[rung].begin(), corridor[rung].end(), vertex);
}

/// @param exact what the corridor holds is on a path within the limit
void expect_holds_every_path(const Instance& instance, const std::vector<Eigen::ArrayXd>& through,
                             const PathBounds& bounds, double limit, bool exact) {
  const auto corridor = bounds.corridor(limit, kAll);
  if (!corridor) {
    EXPECT_GT(through[0].minCoeff(), limit);
    return;
  }
  ASSERT_EQ(corridor->size(), instance.rungs.size());
  for (std::size_t i = 0; i < corridor->size(); ++i) {
    EXPECT_TRUE(std::is_sorted((*corridor)[i].begin(), (*corridor)[i].end()));
    for (Eigen::Index v = 0; v < instance.rungs[i].size(); ++v) {
      if (through[i][v] <= limit) {
        EXPECT_TRUE(contains(*corridor, i, v)) << "rung " << i << ", vertex " << v;
      } else if (exact && through[i][v] > limit + 1e-9) {
        EXPECT_FALSE(contains(*corridor, i, v)) << "rung " << i << ", vertex " << v;
      }
      if (instance.blocked[i][static_cast<std::size_t>(v)]) {
        EXPECT_FALSE(contains(*corridor, i, v)) << "rung " << i << ", vertex " << v;
      }
    }
  }
}

void expect_sound(const Instance& instance, std::size_t stride, Dice& dice) {
  const auto through = best_through(instance);
  const double optimum = through[0].minCoeff();
  const PathBounds bounds(instance.rungs, instance.metric, stride, instance.is_blocked(), 2, {});
  if (optimum == kInfinity) {
    EXPECT_FALSE(bounds.corridor(100, kAll));
    return;
  }
  EXPECT_LE(bounds.least(), optimum + 1e-9);
  if (stride == 1) {
    EXPECT_NEAR(bounds.least(), optimum, 1e-9);
  }
  const std::size_t some_rung = instance.rungs.size() / 2;
  std::vector<double> limits = {optimum,       optimum - 0.1, optimum + 0.01,
                                optimum + 0.3, optimum + 2,   optimum + 100};
  for (int k = 0; k < 2; ++k) {  // exactly what a vertex needs
    const int last = static_cast<int>(through[some_rung].size()) - 1;
    const double cost = through[some_rung][dice.integer(0, last)];
    if (cost < kInfinity) limits.push_back(cost);
  }
  for (const double limit : limits) {
    expect_holds_every_path(instance, through, bounds, limit, stride == 1);
  }
}

TEST(PathBounds, HoldEveryPathWithinTheLimit) {
  Dice dice(1);
  for (unsigned seed = 0; seed < 120; ++seed) {
    const Instance instance = random_instance(seed, seed % 4 == 3 ? 0.4 : 0);
    for (const std::size_t stride : {1U, 2U, 4U, 8U}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", stride " << stride);
      expect_sound(instance, stride, dice);
      if (HasFailure()) return;
    }
  }
}

TEST(PathBounds, HoldEveryPathWithSquaredCosts) {
  Dice dice(2);
  for (unsigned seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Instance instance = random_instance(1000 + seed, seed % 4 == 3 ? 0.4 : 0);
    instance.metric.squared = true;
    expect_sound(instance, 1, dice);
    if (HasFailure()) return;
  }
}

TEST(PathBounds, OfAGridHoldEveryTie) {
  Dice dice(3);
  for (unsigned seed = 0; seed < 80; ++seed) {
    Instance instance = random_instance(2000 + seed, 0);
    for (Rung& rung : instance.rungs) {
      rung.positions = (rung.positions / (kTurn / 8)).round() * (kTurn / 8);
      rung.cost.setZero();
    }
    for (const std::size_t stride : {1U, 3U, 4U}) expect_sound(instance, stride, dice);
    if (HasFailure()) return;
  }
}

TEST(PathBounds, OfStrideOneKeepABestPathHoweverNarrow) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Instance instance = random_instance(3000 + seed, seed % 2 == 0 ? 0.2 : 0);
    const double optimum = best_through(instance)[0].minCoeff();
    if (optimum == kInfinity) continue;
    const PathBounds bounds(instance.rungs, instance.metric, 1, instance.is_blocked(), 2, {});
    for (const std::size_t widest : {1U, 3U, 20U}) {
      const auto corridor = bounds.corridor(optimum + 0.5, widest);
      ASSERT_TRUE(corridor);
      Instance narrow = instance;
      for (std::size_t i = 0; i < corridor->size(); ++i) {
        EXPECT_LE((*corridor)[i].size(), widest);
        for (Eigen::Index v = 0; v < instance.rungs[i].size(); ++v) {
          if (!contains(*corridor, i, v)) narrow.blocked[i][static_cast<std::size_t>(v)] = 1;
        }
      }
      EXPECT_NEAR(best_through(narrow)[0].minCoeff(), optimum, 1e-9);
    }
  }
}

TEST(PathBounds, LeaveOutWhatIsBlockedLater) {
  Dice dice(4);
  for (unsigned seed = 0; seed < 60; ++seed) {
    Instance instance = random_instance(4000 + seed, 0);
    const PathBounds bounds(instance.rungs, instance.metric, 1 + seed % 4, instance.is_blocked(), 2,
                            {});
    for (auto& rung : instance.blocked) {
      for (char& flag : rung) flag = dice.integer(0, 4) == 0;
    }
    const auto through = best_through(instance);
    const double optimum = through[0].minCoeff();
    if (optimum == kInfinity) continue;
    EXPECT_LE(bounds.least(), optimum + 1e-9);
    expect_holds_every_path(instance, through, bounds, optimum, false);
    expect_holds_every_path(instance, through, bounds, optimum + 0.5, false);
    if (HasFailure()) return;
  }
}

TEST(PathBounds, OfABlockedRungGiveNoCorridor) {
  Instance instance = random_instance(5, 0);
  std::fill(instance.blocked[2].begin(), instance.blocked[2].end(), char{1});
  for (const std::size_t stride : {1U, 2U}) {
    const PathBounds bounds(instance.rungs, instance.metric, stride, instance.is_blocked(), 1, {});
    EXPECT_EQ(bounds.least(), kInfinity);
    EXPECT_FALSE(bounds.corridor(1e6, kAll));
  }
}

TEST(PathBounds, OfASingleRungAreItsCosts) {
  Instance instance = random_instance(6, 0);
  instance.rungs.resize(1);
  const PathBounds bounds(instance.rungs, instance.metric, 4, instance.is_blocked(), 1, {});
  EXPECT_DOUBLE_EQ(bounds.least(), instance.rungs[0].cost.minCoeff());
  ASSERT_TRUE(bounds.corridor(bounds.least(), kAll));
  EXPECT_EQ(bounds.corridor(bounds.least(), kAll)->front().size(), 1U);
}

TEST(PathBounds, DoNotDependOnTheNumberOfThreads) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Instance instance = random_instance(5000 + seed, 0.1);
    const std::size_t stride = 1 + seed % 5;
    const PathBounds one(instance.rungs, instance.metric, stride, instance.is_blocked(), 1, {});
    const PathBounds five(instance.rungs, instance.metric, stride, instance.is_blocked(), 5, {});
    EXPECT_EQ(one.least(), five.least());
    if (one.least() == kInfinity) continue;
    for (const std::size_t widest : {std::size_t{5}, kAll}) {
      EXPECT_EQ(one.corridor(one.least() + 1, widest), five.corridor(one.least() + 1, widest));
    }
    EXPECT_EQ(one.evaluated(), five.evaluated());
  }
}

}  // namespace
}  // namespace wristwise
