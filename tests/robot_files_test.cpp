#include "kinematics/robot_files.hpp"

#include <gtest/gtest.h>

#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using Files = std::vector<std::filesystem::path>;

const std::string kArm = R"(<robot name="arm">
  <link name="base"><collision><geometry><mesh filename="base.stl"/></geometry></collision></link>
  <link name="lid"><collision><geometry><mesh filename="missing.stl"/></geometry></collision></link>
  <link name="arm"><visual><geometry><mesh filename="package://shop/arm.stl"/></geometry></visual>
    <collision><geometry><box size="1 1 1"/></geometry></collision></link>
  <link name="tip"><visual><geometry><mesh filename="package://shop/tip.stl"/></geometry></visual></link>
  <joint name="a" type="fixed"><parent link="base"/><child link="lid"/></joint>
  <joint name="b" type="fixed"><parent link="base"/><child link="arm"/></joint>
  <joint name="c" type="fixed"><parent link="arm"/><child link="tip"/></joint>
</robot>)";

TEST(RobotFiles, AreTheDescriptionAndWhatItIsReadWith) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "packages/shop");
  const auto base = folder.write("base.stl", ""), tip = folder.write("packages/shop/tip.stl", "");
  folder.write("packages/shop/arm.stl", "");
  RobotSource source;
  source.urdf = folder.write("arm.urdf", kArm);
  source.packages = {folder.path() / "packages"};
  EXPECT_EQ(robot_files(source), (Files{source.urdf, base}));
  source.limits = "limits.yaml";
  source.srdf = "arm.srdf";
  source.visual_as_collision = true;
  Files files = robot_files(source);
  ASSERT_EQ(files.size(), 5U);
  EXPECT_EQ(files[1], "limits.yaml");
  EXPECT_EQ(files[2], "arm.srdf");
  EXPECT_EQ(files[3], base);
  EXPECT_TRUE(std::filesystem::equivalent(files[4], tip));
  source.read_collision_shapes = false;
  EXPECT_EQ(robot_files(source), (Files{source.urdf, "limits.yaml", "arm.srdf"}));
}

}  // namespace
}  // namespace wristwise
