// The keys of the problem file that stage 2 reads last: posture, singularity, seeds, time limit.

#include <gtest/gtest.h>

#include <cmath>

#include "gantry_urdf.hpp"
#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;

class Stage2Keys : public testing::Test {
 protected:
  Stage2Keys() { folder_.write("gantry.urdf", test::kGantryUrdf); }

  /// A line with the given sections at its end, which begin on line 3.
  Problem load(const std::string& sections) {
    return load_problem(
        folder_.write("a.yaml",
                      "robot: {urdf: gantry.urdf}\n"
                      "path: {speed: 1, waypoints: 3, segments: [line: {from: {xyz: [0, 0, 0]}, "
                      "to: {xyz: [1, 0, 0]}}]}\n" +
                          sections));
  }

  test::TemporaryFolder folder_;
};

TEST_F(Stage2Keys, AreRead) {
  const Problem problem = load(
      "cost: {posture: {joints: [20 cm, -0.1, 90 deg], weight: 4}, singularity: {refine: 0.3}}\n"
      "graph: {seeds: 2, spare_seeds: 0}\n"
      "refine: {time_limit: 250 ms}\n");
  ASSERT_EQ(problem.cost.preferred_posture.size(), 3U);
  EXPECT_DOUBLE_EQ(problem.cost.preferred_posture[0], 0.2);
  EXPECT_DOUBLE_EQ(problem.cost.preferred_posture[1], -0.1);
  EXPECT_DOUBLE_EQ(problem.cost.preferred_posture[2], std::acos(0.0));
  EXPECT_EQ(problem.cost.posture, 4);
  EXPECT_EQ(problem.cost.singularity_refine, 0.3);
  EXPECT_EQ(problem.cost.singularity_graph, 0);
  EXPECT_EQ(problem.graph.seeds, 2);
  EXPECT_EQ(problem.graph.spare_seeds, 0);
  EXPECT_EQ(problem.refine.time_limit, 0.25);
}

TEST_F(Stage2Keys, LeftOutTheyHaveTheDefaultsOfTheDocs) {
  for (const char* sections :
       {"", "refine: {time_limit: off}\n", "cost: {singularity: {graph: 0}}\n"}) {
    const Problem problem = load(sections);
    EXPECT_TRUE(problem.cost.preferred_posture.empty());
    EXPECT_EQ(problem.cost.singularity_refine, 0);
    EXPECT_EQ(problem.graph.seeds, 1);
    EXPECT_EQ(problem.graph.spare_seeds, 3);
    EXPECT_EQ(problem.refine.time_limit, INFINITY);
    EXPECT_EQ(problem.refine.max_rounds, 60);
  }
  const Problem problem = load("cost: {posture: {joints: [0, 0, 0]}}\n");
  EXPECT_EQ(problem.cost.preferred_posture, std::vector<double>(3, 0));
  EXPECT_EQ(problem.cost.posture, 1);
}

TEST_F(Stage2Keys, MistakesAreNamedWithLineAndKey) {
  struct Case {
    std::string section, where, what;
  };
  const std::vector<Case> cases = {
      {"cost: {posture: {weight: 1}}", ":3: cost.posture", "'joints' is missing"},
      {"cost: {posture: {joints: [0, 0]}}", ":3: cost.posture.joints", "3, one per joint"},
      {"cost: {posture: {joints: [0, 0, 1 mm]}}", "cost.posture.joints[2]", "unit of a length"},
      {"cost: {posture: {joints: [1 deg, 0, 0]}}", "cost.posture.joints[0]", "unit of an angle"},
      {"cost: {posture: {joints: [0, .nan, 0]}}", "cost.posture.joints[1]", "not finite"},
      {"cost: {posture: {joints: [0, 0, 0], weight: -1}}", "cost.posture.weight", "negative"},
      {"cost: {posture: {joint: [0, 0, 0]}}", "cost.posture.joint", "'joints'"},
      {"cost: {posture: [0, 0, 0]}", "cost.posture", "keys"},
      {"cost: {singularity: {refine: -1}}", "cost.singularity.refine", "negative"},
      {"cost: {singularity: {refine: .inf}}", "cost.singularity.refine", "not finite"},
      {"graph: {spare_seeds: -1}", ":3: graph.spare_seeds", "at least 0"},
      {"graph: {spare_seeds: 1.5}", "graph.spare_seeds", "whole number"},
      {"refine: {time_limit: 0}", ":3: refine.time_limit", "not above zero"},
      {"refine: {time_limit: -1 s}", "refine.time_limit", "not above zero"},
      {"refine: {time_limit: 1 mm}", "refine.time_limit", "unit of a length"},
      {"refine: {time_limit: never}", "refine.time_limit", "'never'"},
      {"refine: {time_limits: 1}", "refine.time_limits", "'time_limit'"},
  };
  for (const Case& mistake : cases) {
    const std::string message = invalid_input([&] { load(mistake.section + "\n"); });
    EXPECT_TRUE(says(message, mistake.where)) << message << "\nexpected " << mistake.where;
    EXPECT_TRUE(says(message, mistake.what)) << message << "\nexpected " << mistake.what;
  }
}

}  // namespace
}  // namespace wristwise
