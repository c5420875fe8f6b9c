#include "kinematics/srdf.hpp"

#include <gtest/gtest.h>

#include "invalid_input.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;
using test::TemporaryFolder;
using Pairs = std::vector<Srdf::Names>;
using Words = std::vector<std::string>;

TEST(ReadSrdf, TakesPairsAndGroups) {
  const TemporaryFolder folder;
  const Srdf srdf = read_srdf(folder.write("robot.srdf", R"(<robot name="cell">
    <group name="g"><chain base_link="a" tip_link="c"/><joint name="j"/><link name="l"/>
      <group name="h"/></group><group name="h"/>
    <disable_collisions link1="a" link2="b" reason="Adjacent"/>
    <disable_collisions link1="a" link2="c"/><enable_collisions link1="d" link2="e"/>
    <disable_default_collisions link="d"/></robot>)"));
  EXPECT_EQ(srdf.robot_name, "cell");
  EXPECT_EQ(srdf.disabled, (Pairs{{"a", "b"}, {"a", "c"}}));
  EXPECT_EQ(srdf.enabled, (Pairs{{"d", "e"}}));
  EXPECT_EQ(srdf.never_by_default, Words{"d"});
  ASSERT_EQ(srdf.groups.size(), 2U);
  const Srdf::Group& group = srdf.groups.at("g");
  EXPECT_EQ(group.chains, (Pairs{{"a", "c"}}));
  EXPECT_EQ(group.joints, Words{"j"});
  EXPECT_EQ(group.links, Words{"l"});
  EXPECT_EQ(group.groups, Words{"h"});
}

TEST(ReadSrdf, FaultsAreRefusedWithTheirLine) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& text) {
    return invalid_input([&] { read_srdf(folder.write("robot.srdf", text)); });
  };
  EXPECT_TRUE(says(message("<robot>\n<disable_collisions link1=\"a\"/></robot>"),
                   "robot.srdf:2: disable_collisions has no link2"));
  EXPECT_TRUE(says(message("<robot><group/></robot>"), "robot.srdf:1: group has no name"));
  EXPECT_TRUE(says(message("<robot><group name='g'/>\n<group name='g'/></robot>"),
                   "robot.srdf:2: group 'g' is given twice"));
  EXPECT_TRUE(says(message("<robot><a></robot>"), "not valid XML"));
  EXPECT_TRUE(says(message("<scene/>"), "no <robot>"));
  EXPECT_TRUE(says(invalid_input([] { read_srdf("nowhere.srdf"); }), "no such file"));
}

}  // namespace
}  // namespace wristwise
