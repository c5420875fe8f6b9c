// The section `placement` of a problem file.

#include <gtest/gtest.h>

#include <cmath>

#include "invalid_input.hpp"
#include "placement_example.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::placement_request;
using test::placement_text;
using test::says;

constexpr double kDegree = 3.14159265358979323846 / 180;

class PlacementKeys : public testing::Test {
 protected:
  PlacementOptions read(const std::string& placement) {
    return placement_request(folder_, placement).options;
  }

  void expect_invalid(const std::string& placement, const std::vector<std::string>& parts) {
    const std::string message = invalid_input([&] { read(placement); });
    for (const std::string& part : parts)
      EXPECT_TRUE(says(message, part)) << part << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    // plan reads the section too
    const auto file = folder_.path() / "placement.yaml";
    EXPECT_TRUE(says(invalid_input([&] { load_problem(file); }), parts.front()));
  }

  test::TemporaryFolder folder_;
};

TEST_F(PlacementKeys, EveryKeyIsRead) {
  const PlacementOptions options = read(
      "{move: robot, with: [pillar], x: 10 cm, y: [-0.2, 0.3], z: [1 mm, 1 mm], rx: 1 deg, "
      "ry: [0, 2 deg], rz: [-180 deg, 180 deg], weights: {speed: 2, singularity: 3, clearance: 4}, "
      "margins: {singularity: 0.25, clearance: 5 mm}, evaluations: 77, map: 5, seed: 9, "
      "time_limit: 1 min}");
  EXPECT_EQ(options.placed, Placed::robot);
  EXPECT_EQ(options.with, std::vector<std::string>{"pillar"});
  Offset lower, upper;
  lower << -0.1, -0.2, 0.001, -kDegree, 0, -180 * kDegree;
  upper << 0.1, 0.3, 0.001, kDegree, 2 * kDegree, 180 * kDegree;
  EXPECT_LT((options.lower - lower).norm(), 1e-15);
  EXPECT_LT((options.upper - upper).norm(), 1e-15);
  EXPECT_EQ(options.speed_weight, 2);
  EXPECT_EQ(options.singularity_weight, 3);
  EXPECT_EQ(options.clearance_weight, 4);
  EXPECT_EQ(options.singularity_margin, 0.25);
  EXPECT_EQ(options.clearance_margin, 0.005);
  EXPECT_EQ(options.evaluations, 77);
  EXPECT_EQ(options.map_points, 5);
  EXPECT_EQ(options.seed, 9U);
  EXPECT_EQ(options.time_limit, 60);
}

TEST_F(PlacementKeys, DefaultsAreThoseOfTheHeader) {
  const PlacementOptions options = read("{with: all}"), plain;
  EXPECT_EQ(options.placed, plain.placed);
  EXPECT_EQ(options.with, (std::vector<std::string>{"plate", "pillar"}));
  EXPECT_EQ(options.lower, plain.lower);
  EXPECT_EQ(options.upper, plain.upper);
  EXPECT_EQ(options.evaluations, plain.evaluations);
  EXPECT_EQ(options.map_points, plain.map_points);
  EXPECT_TRUE(std::isinf(options.time_limit));
  EXPECT_TRUE(std::isinf(read("{with: all, time_limit: off}").time_limit));
  EXPECT_EQ(read("{with: all, map: off}").map_points, 0);
  EXPECT_TRUE(read("{move: robot}").with.empty());
}

TEST_F(PlacementKeys, TheFrameOfThePartIsKnown) {
  const PlacementRequest request = placement_request(folder_, "{with: all}");
  EXPECT_TRUE(request.part_frame.isApprox(pose_from_xyz_rpy({1, 0, 0.8}, {0, 0, 0})));
  EXPECT_EQ(request.problem.task.waypoints.size(), 7U);
}

TEST_F(PlacementKeys, BadValuesAreToldWithTheirKey) {
  expect_invalid("{with: all, x: [0.2, 0.1]}", {"placement.x", "above the upper"});
  expect_invalid("{with: all, y: [.nan, 0.1]}", {"placement.y", "not finite"});
  expect_invalid("{with: all, y: [0, .inf]}", {"placement.y", "not finite"});
  expect_invalid("{with: all, z: -0.1}", {"placement.z", "negative"});
  expect_invalid("{with: all, z: [1, 2, 3]}", {"placement.z", "[lower, upper]"});
  expect_invalid("{with: all, rz: 200 deg}", {"placement.rz", "whole turn"});
  expect_invalid("{with: all, rz: 1 mm}", {"placement.rz", "unit"});
  expect_invalid("{with: all, move: table}", {"placement.move", "part or robot"});
  expect_invalid("{with: [plat]}", {"placement.with[0]", "no object 'plat'", "'plate'"});
  expect_invalid("{with: [plate, plate]}", {"placement.with[1]", "twice"});
  expect_invalid("{with: plate}", {"placement.with", "a list of their names"});
  expect_invalid("{x: 0.1}", {"placement", "which objects move"});
  expect_invalid("{with: all, weights: {speed: -1}}", {"placement.weights.speed", "negative"});
  expect_invalid("{with: all, weights: {sped: 1}}", {"placement.weights.sped", "speed"});
  expect_invalid("{with: all, margins: {singularity: 1.5}}", {"placement.margins.singularity"});
  expect_invalid("{with: all, margins: {clearance: -1 mm}}", {"placement.margins.clearance"});
  expect_invalid("{with: all, evaluations: 0}", {"placement.evaluations"});
  expect_invalid("{with: all, map: 1}", {"placement.map"});
  expect_invalid("{with: all, map: 5000}", {"placement.map", "too many"});
  expect_invalid("{with: all, seed: -1}", {"placement.seed"});
  expect_invalid("{with: all, time_limit: 0}", {"placement.time_limit"});
  expect_invalid("{with: all, xx: 0}", {"placement.xx", "unknown key"});
}

TEST_F(PlacementKeys, WithoutTheSectionThereIsNothingToPlace) {
  const std::string text = placement_text("x");
  const auto file = folder_.write("p.yaml", text.substr(0, text.find("placement:")));
  EXPECT_NO_THROW(load_problem(file));
  EXPECT_TRUE(says(invalid_input([&] { load_placement(file); }), "'placement' is missing"));
}

}  // namespace
}  // namespace wristwise
