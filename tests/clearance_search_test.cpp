// The least distance along a motion, and what is shown of it for all t (F31), against dense
// samples.

#include "collision/clearance_search.hpp"

#include <gtest/gtest.h>

#include "collision_robots.hpp"

namespace wristwise {
namespace {

using test::arm;
using test::random_posture;
using test::uniform;
using test::workshop;

constexpr double kResolution = 1e-5;
constexpr double kMeasured = 1e-6;  // m, the accuracy of a distance

std::shared_ptr<const ClearanceModel> workshop_model() {
  return std::make_shared<const ClearanceModel>(arm(), workshop());
}

/// A quintic that stays inside the joint limits.
MotionPiece random_motion(const Robot& robot, std::mt19937& random, double size) {
  MotionPiece::Polynomials joints(robot.joint_count(), 6);
  joints.col(0) = 0.6 * random_posture(robot, random);
  for (int j = 0; j < robot.joint_count(); ++j) {
    const double step = j == 0 ? 0.1 : 0.4;
    for (int k = 1; k < 6; ++k) joints(j, k) = size * step * uniform(random, -1, 1) / k / k;
  }
  return {2, 5, joints};
}

std::vector<double> sample_times(const MotionPiece& motion, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i)
    times.push_back(motion.start() + i * (motion.end() - motion.start()) / count);
  return times;
}

TEST(ClearanceSearch, FindsTheLeastDistanceAndABoundBelowIt) {
  ClearanceChecker checker(workshop_model());
  std::mt19937 random(61);
  int separated = 0, overlapping = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const MotionPiece motion =
        random_motion(checker.model().robot(), random, uniform(random, 0.05, 0.6));
    double least = HUGE_VAL;
    for (const double t : sample_times(motion, 600)) {
      checker.set_posture(motion.posture(t));
      if (const auto nearest = checker.nearest(least)) least = nearest->distance;
    }
    ClearanceSearch search(checker, kResolution);
    ClearanceFinding found;
    search.look_along(motion, found);
    EXPECT_LE(found.bound, least + kMeasured) << trial;
    EXPECT_GE(found.bound, found.least - kResolution - 1e-12) << trial;
    EXPECT_LE(found.least, least + kResolution + kMeasured) << trial;
    checker.set_posture(motion.posture(found.time));
    EXPECT_NEAR(checker.distance(found.pair).distance, found.least, kMeasured) << trial;
    ++(least > 0 ? separated : overlapping);
  }
  EXPECT_GT(separated, 5);
  EXPECT_GT(overlapping, 5);
}

/// Pair by pair, so that bounds of pairs that are not the nearest are tested too.
TEST(ClearanceSearch, IsNeverOptimisticOfAnyPair) {
  const Scene all = workshop();
  std::mt19937 random(62);
  for (const auto& names : std::vector<Scene::Names>{{"torch", "table"},
                                                     {"torch", "post"},
                                                     {"fore", "ball"},
                                                     {"elbow", "table"},
                                                     {"torch", "shoulder"},
                                                     {"wrist", "upper"},
                                                     {"torch", "base"}}) {
    Scene scene = all;
    scene.scope = CollisionScope::pairs;
    scene.pairs = {names};
    ClearanceChecker checker(std::make_shared<const ClearanceModel>(arm(), scene));
    for (int trial = 0; trial < 15; ++trial) {
      const MotionPiece motion =
          random_motion(checker.model().robot(), random, uniform(random, 0.05, 1));
      double least = HUGE_VAL;
      for (const double t : sample_times(motion, 1000)) {
        checker.set_posture(motion.posture(t));
        if (const auto nearest = checker.nearest(least)) least = nearest->distance;
      }
      ClearanceSearch search(checker, 1e-4);
      ClearanceFinding found;
      search.look_along(motion, found);
      EXPECT_LE(found.bound, least + kMeasured) << names.first << " - " << names.second;
      EXPECT_GE(found.bound, least - 1e-4 - 1e-3 * std::abs(least));
    }
  }
}

TEST(ClearanceSearch, NothingIsFoundWhereAllIsAboveTheCutoff) {
  ClearanceChecker checker(workshop_model());
  std::mt19937 random(63);
  const MotionPiece motion = random_motion(checker.model().robot(), random, 0.1);
  ClearanceFinding all;
  ClearanceSearch(checker, kResolution).look_along(motion, all);
  ClearanceFinding none;
  none.least = all.bound - 1e-9;
  ClearanceSearch(checker, kResolution).look_along(motion, none);
  EXPECT_EQ(none.pair, -1);
  EXPECT_EQ(none.least, all.bound - 1e-9);
  EXPECT_GE(none.bound, none.least - kResolution);
}

/// Far fewer exact distances are measured than there are postures and pairs.
TEST(ClearanceSearch, MeasuresFewDistances) {
  ClearanceChecker checker(workshop_model());
  std::mt19937 random(64);
  MotionPiece motion = random_motion(checker.model().robot(), random, 0.2);
  ClearanceFinding found;
  ClearanceSearch search(checker, kResolution);
  search.look_along(motion, found);
  EXPECT_LT(checker.queries(), 10 * checker.model().pairs().size());
}

/// Outside the intervals that are listed every pair keeps the distance; inside them it comes near
/// it.
TEST(ClearanceSearch, ListsWhereItIsNotShown) {
  ClearanceChecker checker(workshop_model());
  std::mt19937 random(65);
  int listed = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const MotionPiece motion = random_motion(checker.model().robot(), random, 0.3);
    const double floor = uniform(random, 0, 0.1);
    const auto ranges = ClearanceSearch(checker, kResolution).not_shown(motion, floor);
    std::vector<double> nearest_in(ranges.size(), HUGE_VAL);
    for (const double t : sample_times(motion, 320)) {
      checker.set_posture(motion.posture(t));
      for (int pair = 0; pair < static_cast<int>(checker.model().pairs().size()); ++pair) {
        const double distance =
            checker.lower_bound(pair) > floor + 0.1 ? floor + 0.1 : checker.distance(pair).distance;
        bool is_listed = false;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
          if (ranges[i].first != pair || t < ranges[i].second.first || t > ranges[i].second.second)
            continue;
          is_listed = true;
          nearest_in[i] = std::min(nearest_in[i], distance);
        }
        if (!is_listed) {
          EXPECT_GE(distance, floor - kMeasured);
        }
      }
    }
    for (const double nearest : nearest_in) EXPECT_LT(nearest, floor + 0.05);
    listed += static_cast<int>(ranges.size());
  }
  EXPECT_GT(listed, 20);
}

/// No point of the farther shape is ever farther from the axis.
TEST(Reach, HoldsForEveryPosture) {
  const auto model = workshop_model();
  const Robot& robot = model->robot();
  std::mt19937 random(67);
  double tightest = 0;
  for (int trial = 0; trial < 300; ++trial) {
    ChainPose chain;
    forward_kinematics(robot, random_posture(robot, random), chain);
    for (std::size_t i = 0; i < model->pairs().size(); ++i) {
      const auto& p = model->pairs()[i];
      const auto& a = model->bodies()[static_cast<std::size_t>(p.body_a)];
      const auto& b = model->bodies()[static_cast<std::size_t>(p.body_b)];
      const bool a_is_far = a.joint > b.joint;
      const auto& far = a_is_far ? a : b;
      const auto& shape = far.shapes[static_cast<std::size_t>(a_is_far ? p.shape_a : p.shape_b)];
      const JointVector& reach = model->reach(static_cast<int>(i));
      for (int j = 0; j < robot.joint_count(); ++j) {
        const bool between = j > std::min(a.joint, b.joint) && j <= far.joint;
        EXPECT_EQ(reach[j] > 0, between);
        if (!between || robot.joints()[static_cast<std::size_t>(j)].type == JointType::prismatic)
          continue;
        const Eigen::Vector3d x = chain.frame(far.joint) * shape.pose *
                                  support_point(shape.geometry, test::random_unit(random));
        const auto index = static_cast<std::size_t>(j);
        const double distance =
            chain.axes[index].cross(x - chain.frames[index].translation()).norm();
        EXPECT_LE(distance, reach[j] + 1e-12);
        tightest = std::max(tightest, distance / reach[j]);
      }
    }
  }
  EXPECT_GT(tightest, 0.95);
}

}  // namespace
}  // namespace wristwise
