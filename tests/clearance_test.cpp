#include "wristwise/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

#include "collision_robots.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

using test::arm;
using test::arm_parts;
using test::at;
using test::random_posture;
using test::revolute;
using test::uniform;
using test::workshop;

using Names = std::set<std::pair<std::string, std::string>>;

Names pair_names(const ClearanceModel& model) {
  Names names;
  for (int pair = 0; pair < static_cast<int>(model.pairs().size()); ++pair) {
    names.insert(model.names(pair));
  }
  return names;
}

/// A pendulum: a sphere of radius 0.1 hangs 1 m from the axis y of its only joint.
std::shared_ptr<const Robot> pendulum() {
  Robot::Parts parts;
  parts.name = "pendulum";
  parts.base_link = "stand";
  parts.tip_link = "bob";
  parts.joints = {revolute("swing", Pose::Identity(), Eigen::Vector3d::UnitY())};
  parts.links = {{"stand", -1, Pose::Identity(), {{Box{{0.2, 0.2, 0.2}}}}},
                 {"bob", 0, at(0, 0, -1), {{Sphere{0.1}}}}};
  parts.adjacent_links = {{0, 1}};
  return std::make_shared<const Robot>(parts);
}

std::shared_ptr<const ClearanceModel> workshop_model() {
  return std::make_shared<const ClearanceModel>(arm(), workshop());
}

std::string refusal(const Scene& scene) {
  try {
    const ClearanceModel model(arm(), scene);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ClearanceModel, LeavesOutAdjacentLinksAndObjectsAmongThemselves) {
  const auto model = workshop_model();
  const Names names = pair_names(*model);
  EXPECT_EQ(names.count({"base", "carriage"}), 0U);
  EXPECT_EQ(names.count({"wrist", "torch"}), 0U);
  EXPECT_EQ(names.count({"table", "ball"}), 0U);
  EXPECT_EQ(names.count({"fore", "torch"}), 1U);
  EXPECT_EQ(names.count({"torch", "table"}), 1U);
  // 8 links: 28 pairs, 7 adjacent; 7 that move x 3 objects.
  EXPECT_EQ(names.size(), 28U - 7U + 21U);
  // The torch has three shapes and so as many pairs with the table.
  const auto& pairs = model->pairs();
  EXPECT_EQ(std::count_if(
                pairs.begin(), pairs.end(),
                [&](const ClearanceModel::Pair& pair) {
                  return model->bodies()[static_cast<std::size_t>(pair.body_a)].name == "torch" &&
                         model->bodies()[static_cast<std::size_t>(pair.body_b)].name == "table";
                }),
            3);
}

TEST(ClearanceModel, LeavesOutLinksThatMoveTogetherAndDisabledPairs) {
  Robot::Parts parts = arm_parts();
  parts.links.push_back({"camera", 6, at(0, 0.1, 0), {{Sphere{0.02}}}});
  Scene scene = workshop();
  scene.disabled = {{"table", "torch"}, {"fore", "torch"}, {"gripper_finger", "torch"}};
  const ClearanceModel model(std::make_shared<const Robot>(parts), scene);
  const Names names = pair_names(model);
  EXPECT_EQ(names.count({"torch", "camera"}), 0U);
  EXPECT_EQ(names.count({"camera", "table"}), 1U);
  EXPECT_EQ(names.count({"torch", "table"}), 0U);
  EXPECT_EQ(names.count({"fore", "torch"}), 0U);
}

TEST(ClearanceModel, ScopeOffHasNoPairsAndListedPairsAreThoseOnly) {
  Scene scene = workshop();
  scene.scope = CollisionScope::off;
  EXPECT_TRUE(ClearanceModel(arm(), scene).pairs().empty());
  scene.scope = CollisionScope::pairs;
  scene.pairs = {{"ball", "torch"}, {"torch", "ball"}, {"base", "carriage"}};
  const ClearanceModel model(arm(), scene);
  EXPECT_EQ(pair_names(model), (Names{{"torch", "ball"}, {"base", "carriage"}}));
  EXPECT_EQ(model.pairs().size(), 4U);
}

TEST(ClearanceModel, RefusesNamesItCannotUse) {
  Scene scene = workshop();
  scene.scope = CollisionScope::pairs;
  scene.pairs = {{"torhc", "ball"}};
  EXPECT_NE(refusal(scene).find("'torch'"), std::string::npos) << refusal(scene);
  scene.pairs = {{"table", "ball"}};
  EXPECT_NE(refusal(scene).find("do not move"), std::string::npos);
  scene.pairs = {{"torch", "torch"}};
  EXPECT_NE(refusal(scene).find("do not move"), std::string::npos);
  scene.pairs = {{"base", "ball"}};
  EXPECT_NE(refusal(scene).find("do not move"), std::string::npos);

  scene = workshop();
  scene.objects[1].name = "table";
  EXPECT_NE(refusal(scene).find("taken"), std::string::npos);
  scene.objects[1].name = "wrist";
  EXPECT_NE(refusal(scene).find("taken"), std::string::npos);
}

TEST(ClearanceModel, RefusesUnusableNumbersAndShapes) {
  for (const double clearance : {-0.001, std::nan(""), HUGE_VAL}) {
    Scene scene = workshop();
    scene.clearance = clearance;
    EXPECT_NE(refusal(scene).find("clearance"), std::string::npos);
  }
  const std::vector<Geometry> unusable{Box{{1, 0, 1}},
                                       Box{{1, std::nan(""), 1}},
                                       Sphere{-1},
                                       Sphere{HUGE_VAL},
                                       Cylinder{0, 1},
                                       Cylinder{1, std::nan("")},
                                       ConvexHull{{{0, 0, 0}}, {}}};
  for (const Geometry& geometry : unusable) {
    Scene scene = workshop();
    scene.objects[0].shapes[0].geometry = geometry;
    EXPECT_NE(refusal(scene).find("table"), std::string::npos);
  }
  Scene scene = workshop();
  scene.objects[0].shapes.clear();
  EXPECT_NE(refusal(scene).find("table"), std::string::npos);
  scene = workshop();
  scene.objects[0].shapes[0].pose.translation().x() = std::nan("");
  EXPECT_NE(refusal(scene).find("table"), std::string::npos);
}

TEST(ClearanceModel, NamesPermanentContactsAndKeepsTheRest) {
  Scene scene;
  scene.clearance = 0.01;
  scene.find_permanent_contacts = true;
  // The collar is round the bob's axis of motion: always touched, but an object. The wall is
  // touched sometimes, the floor plate by the stand, which never moves; the shelf is clear of the
  // stand.
  scene.objects = {{"collar", {{Sphere{0.95}}}},
                   {"wall", {{Box{{0.1, 1, 3}}, at(1, 0, 0)}}},
                   {"plate", {{Box{{1, 1, 0.02}}, at(0, 0, -0.115)}}},
                   {"shelf", {{Box{{0.1, 0.1, 0.1}}, at(0, 3, 0)}}}};
  const ClearanceModel model(pendulum(), scene);
  const auto& found = model.permanent_contacts();
  EXPECT_EQ(Names(found.begin(), found.end()), (Names{{"stand", "collar"}, {"stand", "plate"}}));
  const Names names = pair_names(model);
  EXPECT_EQ(names.count({"bob", "wall"}), 1U);
  EXPECT_EQ(names.count({"bob", "plate"}), 1U);
  EXPECT_EQ(names.count({"bob", "collar"}), 1U);

  EXPECT_EQ(names.count({"stand", "shelf"}), 0U);

  scene.find_permanent_contacts = false;
  const Names kept = pair_names(ClearanceModel(pendulum(), scene));
  EXPECT_EQ(kept.count({"bob", "collar"}), 1U);
  EXPECT_EQ(kept.count({"stand", "plate"}), 1U);
  EXPECT_EQ(kept.count({"stand", "shelf"}), 0U);
}

TEST(MotionRadius, BoundsTheChangeOfEveryDistance) {
  const auto model = workshop_model();
  const Robot& robot = model->robot();
  ClearanceChecker before(model), after(model);
  std::mt19937 random(41);
  std::vector<double> tightest(model->pairs().size(), 0);
  for (int sample = 0; sample < 400; ++sample) {
    const JointVector q = random_posture(robot, random);
    const JointVector other = random_posture(robot, random);
    JointVector moved = q;
    if (sample % 2) {
      const auto joint = static_cast<Eigen::Index>(random() % 7);
      moved[joint] = q[joint] + std::pow(10.0, uniform(random, -3, 0)) * (other[joint] - q[joint]);
    } else {
      moved = q + std::pow(10.0, uniform(random, -3, 0)) * (other - q);
    }
    before.set_posture(q);
    after.set_posture(moved);
    for (int pair = 0; pair < static_cast<int>(model->pairs().size()); ++pair) {
      const double change =
          std::abs(after.distance(pair).distance - before.distance(pair).distance);
      const double bound = model->motion_radius(pair).dot((moved - q).cwiseAbs());
      EXPECT_LE(change, bound + 1e-6);
      if (bound > 1e-3) {
        double& ratio = tightest[static_cast<std::size_t>(pair)];
        ratio = std::max(ratio, change / bound);
      }
    }
  }
  // A bound that is never approached would be useless.
  EXPECT_GT(*std::max_element(tightest.begin(), tightest.end()), 0.8);
}

TEST(MotionRadius, IsZeroForJointsThatMoveBothAndKnownForThePendulum) {
  const auto model = workshop_model();
  for (int pair = 0; pair < static_cast<int>(model->pairs().size()); ++pair) {
    const auto [a, b] = model->names(pair);
    if (a != "fore" || b != "torch") continue;
    EXPECT_EQ(model->motion_radius(pair).head(5), JointVector::Zero(5));
    EXPECT_GT(model->motion_radius(pair).tail(2).minCoeff(), 0.01);
    EXPECT_LT(model->motion_radius(pair).maxCoeff(), 0.4);
  }
  Scene scene;
  scene.objects = {{"far", {{Sphere{0.1}, at(5, 0, 0)}}}};
  const ClearanceModel swinging(pendulum(), scene);
  ASSERT_EQ(swinging.pairs().size(), 1U);
  EXPECT_NEAR(swinging.motion_radius(0)[0], 1.1, 1e-12);
}

TEST(ClearanceChecker, KnowsThePendulumsDistance) {
  Scene scene;
  scene.objects = {{"wall", {{Box{{0.1, 4, 6}}, at(1.5, 0, 0)}}}};
  const auto model = std::make_shared<const ClearanceModel>(pendulum(), scene);
  ClearanceChecker checker(model);
  for (const double angle : {-1.0, -0.3, 0.0, 0.4}) {
    checker.set_posture(JointVector::Constant(1, angle));
    ASSERT_EQ(model->pairs().size(), 1U);
    const PairDistance measured = checker.distance(0);
    // The bob is at x = -sin(angle); the wall begins at 1.45.
    EXPECT_NEAR(measured.distance, 1.45 + std::sin(angle) - 0.1, 1e-9);
    EXPECT_NEAR(checker.gradient(measured)[0], std::cos(angle), 1e-9);
  }
}

TEST(ClearanceChecker, LowerBoundNeverExceedsTheDistance) {
  const auto model = workshop_model();
  ClearanceChecker checker(model);
  std::mt19937 random(42);
  int penetrating = 0;
  for (int sample = 0; sample < 500; ++sample) {
    checker.set_posture(random_posture(model->robot(), random));
    for (int pair = 0; pair < static_cast<int>(model->pairs().size()); ++pair) {
      const double distance = checker.distance(pair).distance;
      penetrating += distance < 0;
      EXPECT_LE(checker.lower_bound(pair), distance + 1e-9);
    }
  }
  EXPECT_GT(penetrating, 100);
}

TEST(ClearanceChecker, GradientMatchesCentralDifferences) {
  const auto model = workshop_model();
  ClearanceChecker checker(model);
  std::mt19937 random(43);
  int compared = 0, penetrating = 0, bad = 0;
  const double step = 1e-5;
  for (int sample = 0; sample < 100; ++sample) {
    const JointVector q = random_posture(model->robot(), random);
    for (int pair = 0; pair < static_cast<int>(model->pairs().size()); ++pair) {
      checker.set_posture(q);
      const PairDistance measured = checker.distance(pair);
      const JointVector gradient = checker.gradient(measured);
      double difference = 0;
      for (int j = 0; j < q.size(); ++j) {
        JointVector moved = q;
        moved[j] = q[j] + step;
        checker.set_posture(moved);
        const double above = checker.distance(pair).distance;
        moved[j] = q[j] - step;
        checker.set_posture(moved);
        const double below = checker.distance(pair).distance;
        difference = std::max(difference, std::abs((above - below) / (2 * step) - gradient[j]));
      }
      ++compared;
      penetrating += measured.distance < 0;
      // The distance has kinks, where nearest points jump; random postures are seldom near one.
      bad += difference > 1e-3;
    }
  }
  EXPECT_GT(penetrating, 20);
  EXPECT_LE(bad, compared / 200) << compared;
}

TEST(ClearanceChecker, FirstBelowAndNearestAgreeWithMeasuringEverything) {
  const auto model = workshop_model();
  ClearanceChecker checker(model), all(model);
  std::mt19937 random(44);
  const int count = static_cast<int>(model->pairs().size());
  for (int sample = 0; sample < 500; ++sample) {
    const JointVector q = random_posture(model->robot(), random);
    checker.set_posture(q);
    all.set_posture(q);
    const double required = uniform(random, -0.05, 0.1);
    int first = -1;
    PairDistance least;
    least.distance = HUGE_VAL;
    for (int pair = count - 1; pair >= 0; --pair) {
      const PairDistance measured = all.distance(pair);
      if (measured.distance < required) first = pair;
      if (measured.distance <= least.distance) least = measured;
    }
    const auto below = checker.first_below(required);
    EXPECT_EQ(below ? below->pair : -1, first);
    const auto nearest = checker.nearest();
    ASSERT_TRUE(nearest);
    EXPECT_EQ(nearest->distance, least.distance);
    EXPECT_EQ(checker.nearest(least.distance).has_value(), false);
    EXPECT_EQ(checker.nearest(least.distance + 1e-9)->distance, least.distance);
  }
  EXPECT_LT(checker.queries(), all.queries());
  EXPECT_GT(checker.queries(), 0U);
}

TEST(ClearanceChecker, AnswersDoNotDependOnHistoryOrThread) {
  const auto model = workshop_model();
  std::mt19937 random(45);
  std::vector<JointVector> postures;
  postures.reserve(200);
  for (int i = 0; i < 200; ++i) postures.push_back(random_posture(model->robot(), random));
  const auto measure = [&](std::size_t from, std::vector<double>& distances) {
    ClearanceChecker checker(model);
    distances.resize(postures.size());
    for (std::size_t i = 0; i < postures.size(); ++i) {
      const std::size_t k = (from + i) % postures.size();
      checker.set_posture(postures[k]);
      if (from % 2) checker.first_below(0.02);
      distances[k] = checker.nearest()->distance;
    }
  };
  std::vector<double> expected;
  measure(0, expected);
  std::vector<std::vector<double>> found(4);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < found.size(); ++t) {
    threads.emplace_back([&, t] { measure(17 * t + 1, found[t]); });
  }
  for (auto& thread : threads) thread.join();
  for (const auto& distances : found) EXPECT_EQ(distances, expected);
}

TEST(ClearanceChecker, WithoutPairsFindsNothing) {
  Scene scene = workshop();
  scene.scope = CollisionScope::off;
  ClearanceChecker checker(std::make_shared<const ClearanceModel>(arm(), scene));
  EXPECT_FALSE(checker.nearest());
  EXPECT_FALSE(checker.first_below(1e6));
}

TEST(ClearanceChecker, RefusesPosturesItCannotUse) {
  ClearanceChecker checker(workshop_model());
  EXPECT_THROW(checker.set_posture(JointVector::Zero(3)), InvalidInput);
  EXPECT_THROW(checker.set_posture(JointVector::Constant(7, std::nan(""))), InvalidInput);
}

}  // namespace
}  // namespace wristwise
