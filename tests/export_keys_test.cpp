// The export section of a problem file.

#include <gtest/gtest.h>

#include "gantry_urdf.hpp"
#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr const char* kProblem =
    "robot: {urdf: gantry.urdf}\n"
    "path: {speed: 1, waypoints: 3, segments: [line: {from: {xyz: [0, 0, 0]}, "
    "to: {xyz: [1, 0, 0]}}]}\n";

class ExportKeys : public testing::Test {
 protected:
  ExportKeys() { folder_.write("gantry.urdf", test::kGantryUrdf); }

  Problem load(const std::string& section) {
    return load_problem(folder_.write("p.yaml", kProblem + ("export: " + section + "\n")));
  }
  ExportOptions options(const std::string& section) { return load(section).exports; }
  std::string error(const std::string& section) {
    const std::string message = invalid_input([&] { load(section); });
    EXPECT_TRUE(says(message, "p.yaml:3: export")) << message;
    return message;
  }

  std::string joint(std::size_t j) { return load("{}").robot->joints()[j].name; }

  test::TemporaryFolder folder_;
};

TEST_F(ExportKeys, EveryKeyIsRead) {
  const std::string a = joint(0), b = joint(1), c = joint(2);
  const ExportOptions read = options(
      "{name: SEAM, joints: {" + a + ": E1, " + b + ": {axis: E3, sign: -1, offset: 100 mm}, " + c +
      ": {axis: A1, offset: 90 deg}}, max_deviation: [0.2 mm, 0.3 deg], approach_percent: 25, "
      "weld: "
      "false, krl: {tool: 3, base: 4, weld_on: 'ON()', weld_off: 'OFF()'}, rapid: {tool: torch, "
      "wobj: part, zone: z1, weld_on: [A;, B;], weld_off: C;}, ls: {tool: 5, frame: 6, cnt: 50, "
      "j3_coupling: 1, weld_on: [], weld_off: [x, y]}}");
  EXPECT_EQ(read.name, "SEAM");
  ASSERT_EQ(read.axes.size(), 3u);
  EXPECT_EQ(read.axes[0].number, 6);
  EXPECT_EQ(read.axes[0].sign, 1);
  EXPECT_EQ(read.axes[1].number, 8);
  EXPECT_EQ(read.axes[1].sign, -1);
  EXPECT_EQ(read.axes[1].offset, 0.1);
  EXPECT_EQ(read.axes[2].number, 0);
  EXPECT_EQ(read.axes[2].offset, 90 * kDegree);
  EXPECT_EQ(read.max_deviation, 2e-4);
  EXPECT_EQ(read.max_angle_deviation, 0.3 * kDegree);
  EXPECT_EQ(read.approach_percent, 25);
  EXPECT_FALSE(read.weld);
  EXPECT_EQ(read.krl.tool, 3);
  EXPECT_EQ(read.krl.base, 4);
  EXPECT_EQ(read.krl.weld_on, "ON()");
  EXPECT_EQ(read.krl.weld_off, "OFF()");
  EXPECT_EQ(read.rapid.tool, "torch");
  EXPECT_EQ(read.rapid.wobj, "part");
  EXPECT_EQ(read.rapid.zone, "z1");
  EXPECT_EQ(read.rapid.weld_on, (std::vector<std::string>{"A;", "B;"}));
  EXPECT_EQ(read.rapid.weld_off, (std::vector<std::string>{"C;"}));
  EXPECT_EQ(read.ls.tool, 5);
  EXPECT_EQ(read.ls.frame, 6);
  EXPECT_EQ(read.ls.cnt, 50);
  EXPECT_EQ(read.ls.j3_coupling, 1);
  EXPECT_TRUE(read.ls.weld_on.empty());
  EXPECT_EQ(read.ls.weld_off.size(), 2u);
  EXPECT_EQ(options("{period: 20 ms}").period, 0.02);
}

TEST_F(ExportKeys, MistakesNameTheKey) {
  const std::string a = joint(0), b = joint(1), c = joint(2);
  EXPECT_TRUE(says(error("{joint: {}}"), "the nearest known key is 'joints'"));
  EXPECT_TRUE(says(error("{joints: {" + a + ": A1, " + b + ": A2}}"), c));
  EXPECT_TRUE(says(error("{joints: {" + a + ": A1, " + b + ": A2, " + c + ": A7}}"), "A7"));
  EXPECT_TRUE(
      says(error("{joints: {" + a + ": A1, " + b + ": A2, " + c + ": A2}}"), "the axis of " + b));
  EXPECT_TRUE(says(error("{joints: {" + a + ": A1, " + b + ": A2, elbow: A3}}"), "elbow"));
  EXPECT_TRUE(says(
      error("{joints: {" + a + ": {axis: A1, sign: 2}, " + b + ": A2, " + c + ": A3}}"), "sign"));
  EXPECT_TRUE(
      says(error("{joints: {" + a + ": {axis: A1, offset: .nan}, " + b + ": A2, " + c + ": A3}}"),
           "not finite"));
  EXPECT_TRUE(says(error("{max_deviation: [0, 1]}"), "above zero"));
  EXPECT_TRUE(says(error("{max_deviation: 1 mm}"), "max_deviation"));
  EXPECT_TRUE(says(error("{period: 0.5 ms}"), "1 ms"));
  EXPECT_TRUE(says(error("{period: .inf}"), "period"));
  EXPECT_TRUE(says(error("{period: 10 ms, max_deviation: [1 mm, 1 deg]}"), "one of the two"));
  EXPECT_TRUE(says(error("{approach_percent: 0}"), "approach_percent"));
  EXPECT_TRUE(says(error("{approach_percent: 101}"), "1 to 100"));
  EXPECT_TRUE(says(error("{ls: {j3_coupling: 2}}"), "j3_coupling"));
  EXPECT_TRUE(says(error("{ls: {cnt: 101}}"), "at most 100"));
  EXPECT_TRUE(says(error("{krl: {weld_on: \"a\\nb\"}}"), "printable"));
  EXPECT_TRUE(says(error("{rapid: {weld_on: ['']}}"), "weld_on[0]"));
}

}  // namespace
}  // namespace wristwise
