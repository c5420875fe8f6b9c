#include "wristwise/urdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "invalid_input.hpp"
#include "kinematics/urdf_collision.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::replaced;
using test::says;
using test::TemporaryFolder;

constexpr double kDegree = 0.017453292519943295;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A column on a rail, an arm, and a gripper that is not on the chain.
const char* const kUrdf = R"(<?xml version="1.0"?>
<robot name="cell">
  <link name="hall"/>
  <link name="rail"><collision><geometry><box size="1 2 3"/></geometry></collision></link>
  <link name="column"/>
  <link name="arm">
    <collision><origin xyz="1 2 3"/><geometry><sphere radius="0.1"/></geometry></collision>
    <collision><geometry><cylinder radius="0.1" length="0.4"/></geometry></collision>
  </link>
  <link name="bracket"/>
  <link name="tip"/>
  <link name="finger"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <joint name="hall_rail" type="fixed">
    <origin xyz="0 0 1"/><parent link="hall"/><child link="rail"/>
  </joint>
  <joint name="slide" type="prismatic">
    <origin xyz="0 0 0.5"/><parent link="rail"/><child link="column"/><axis xyz="0 2 0"/>
    <limit lower="-1" upper="2" effort="0" velocity="0.5"/>
  </joint>
  <joint name="mount" type="fixed">
    <origin xyz="0.1 0 0" rpy="0 0 1.5707963267948966"/><parent link="column"/>
    <child link="bracket"/>
  </joint>
  <joint name="swing" type="revolute">
    <origin xyz="0.2 0 0"/><parent link="bracket"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="1" effort="0" velocity="3"/>
  </joint>
  <joint name="spin" type="continuous">
    <origin xyz="0 0 0.3"/><parent link="arm"/><child link="tip"/><axis xyz="1 0 0"/>
    <limit effort="0" velocity="4"/>
  </joint>
  <joint name="grip" type="prismatic">
    <origin xyz="0 0.7 0"/><parent link="arm"/><child link="finger"/><axis xyz="0 0 1"/>
    <limit lower="0.05" upper="0.1" effort="0" velocity="1"/>
  </joint>
</robot>
)";

const char* const kLimits = R"(default_velocity_scaling_factor: 0.1
joint_limits:
  swing:
    has_velocity_limits: true
    max_velocity: 1.5
    has_acceleration_limits: true
    max_acceleration: 7
    has_jerk_limits: false
    max_jerk: 0
  spin:
    has_jerk_limits: true
    max_jerk: 90
  elsewhere:
    max_velocity: 3
)";

Robot load(const TemporaryFolder& folder, const std::string& urdf = kUrdf,
           const std::string& limits = {}, const std::function<void(RobotSource&)>& change = {}) {
  RobotSource source;
  source.urdf = folder.write("robot.urdf", urdf);
  source.tip_link = "tip";
  if (!limits.empty()) source.limits = folder.write("limits.yaml", limits);
  if (change) change(source);
  return load_robot(source);
}

const Link& link(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links().begin(), robot.links().end(),
                                  [&](const Link& candidate) { return candidate.name == name; });
  EXPECT_NE(found, robot.links().end()) << name;
  return *found;
}

bool adjacent(const Robot& robot, const std::string& a, const std::string& b) {
  return std::any_of(
      robot.adjacent_links().begin(), robot.adjacent_links().end(), [&](const auto& pair) {
        const auto& first = robot.links()[static_cast<std::size_t>(pair.first)].name;
        const auto& second = robot.links()[static_cast<std::size_t>(pair.second)].name;
        return (first == a && second == b) || (first == b && second == a);
      });
}

bool warned(const Robot& robot, const std::string& part) {
  return std::any_of(robot.warnings().begin(), robot.warnings().end(),
                     [&](const std::string& warning) { return says(warning, part); });
}

TEST(LoadRobot, FoldsFixedJointsFromTheRootOn) {
  const TemporaryFolder folder;
  const Robot robot = load(folder);
  EXPECT_EQ(robot.name(), "cell");
  EXPECT_EQ(robot.base_link(), "hall");
  EXPECT_EQ(robot.tip_link(), "tip");
  ASSERT_EQ(robot.joint_count(), 3);
  const Joint& slide = robot.joints()[0];
  EXPECT_EQ(slide.type, JointType::prismatic);
  EXPECT_LT((slide.axis - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((slide.origin.translation() - Eigen::Vector3d(0, 0, 1.5)).norm(), 1e-15);
  const Joint& swing = robot.joints()[1];
  EXPECT_LT((swing.origin.translation() - Eigen::Vector3d(0.1, 0.2, 0)).norm(), 1e-15);
  EXPECT_LT((swing.origin.linear().col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_EQ(robot.lower_limits(), (JointVector(3) << -1, -2, -kInfinity).finished());
  EXPECT_EQ(robot.upper_limits(), (JointVector(3) << 2, 1, kInfinity).finished());
  EXPECT_EQ(robot.velocity_limits(), (JointVector(3) << 0.5, 3, 4).finished());
  EXPECT_EQ(robot.jerk_limits(), JointVector::Constant(3, kInfinity));
}

TEST(LoadRobot, FromAText) {
  const TemporaryFolder folder;
  const Robot of_file = load(folder);
  RobotSource source;
  source.urdf_text = kUrdf;
  source.tip_link = "tip";
  const Robot robot = load_robot(source);
  EXPECT_EQ(robot.name(), of_file.name());
  EXPECT_EQ(robot.joint_names(), (std::vector<std::string>{"slide", "swing", "spin"}));
  EXPECT_EQ(robot.joint_names(), of_file.joint_names());
  EXPECT_EQ(robot.links().size(), of_file.links().size());
  EXPECT_EQ(robot.upper_limits(), of_file.upper_limits());
  for (std::size_t j = 0; j < robot.joints().size(); ++j)
    EXPECT_EQ(robot.joints()[j].origin.matrix(), of_file.joints()[j].origin.matrix());

  // Errors name the text; a name may be given, and need not be a file.
  source.urdf_text = "<robot name='x'>\n<link";
  EXPECT_TRUE(says(invalid_input([&] { load_robot(source); }), "urdf_text:2: not valid XML"));
  source.urdf = "/robot_description";
  EXPECT_TRUE(says(invalid_input([&] { load_robot(source); }), "/robot_description:2:"));
  source.urdf_text = "<link/>";
  EXPECT_TRUE(says(invalid_input([&] { load_robot(source); }), "no <robot> element"));
  source.urdf_text = kUrdf;
  source.tip_link = "tap";
  EXPECT_TRUE(says(invalid_input([&] { load_robot(source); }), "/robot_description: "));
}

TEST(LoadRobot, FindsTheTipWithTheMostMovableJoints) {
  const TemporaryFolder folder;
  const auto tip_of = [&](const std::string& urdf) {
    return load(folder, urdf, {}, [](RobotSource& s) { s.tip_link.clear(); }).tip_link();
  };
  const std::string spin_type = "name=\"spin\" type=\"continuous\"";
  const std::string grip_type = "name=\"grip\" type=\"prismatic\"";
  EXPECT_EQ(tip_of(replaced(kUrdf, grip_type, "name=\"grip\" type=\"fixed\"")), "tip");
  EXPECT_EQ(tip_of(replaced(kUrdf, spin_type, "name=\"spin\" type=\"fixed\"")), "finger");
}

TEST(LoadRobot, CarriesEveryLinkAlong) {
  const TemporaryFolder folder;
  const Robot robot = load(folder);
  EXPECT_EQ(robot.links().size(), 7u);
  EXPECT_EQ(link(robot, "rail").joint, -1);
  EXPECT_EQ(link(robot, "bracket").joint, 0);
  EXPECT_EQ(link(robot, "arm").joint, 1);
  EXPECT_EQ(link(robot, "tip").joint, 2);
  ASSERT_EQ(link(robot, "arm").collision.size(), 2u);
  EXPECT_EQ(std::get<Sphere>(link(robot, "arm").collision[0].geometry).radius, 0.1);
  EXPECT_EQ(link(robot, "arm").collision[0].pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<Cylinder>(link(robot, "arm").collision[1].geometry).length, 0.4);
  EXPECT_EQ(std::get<Box>(link(robot, "rail").collision[0].geometry).size,
            Eigen::Vector3d(1, 2, 3));
}

TEST(LoadRobot, FreezesWhatIsOffTheChain) {
  const TemporaryFolder folder;
  const Robot robot = load(folder);
  EXPECT_EQ(link(robot, "finger").joint, 1);
  EXPECT_LT((link(robot, "finger").pose.translation() - Eigen::Vector3d(0, 0.7, 0.05)).norm(),
            1e-15);
  EXPECT_TRUE(warned(robot, "'grip' (prismatic) is not on the chain and is held at 0.05"));
}

TEST(LoadRobot, FreezesWhatIsAboveTheBase) {
  const TemporaryFolder folder;
  const Robot robot = load(folder, kUrdf, {}, [](RobotSource& s) { s.base_link = "bracket"; });
  ASSERT_EQ(robot.joint_count(), 2);
  EXPECT_TRUE(warned(robot, "'slide' (prismatic) is not on the chain and is held at 0"));
  const Link& rail = link(robot, "rail");
  EXPECT_EQ(rail.joint, -1);
  // In the bracket's frame, which is turned by +90 deg about z against the rail's.
  EXPECT_LT((rail.pose.translation() - Eigen::Vector3d(0, 0.1, -0.5)).norm(), 1e-15);
}

TEST(LoadRobot, AdjacencyCrossesLinksWithoutShapes) {
  const TemporaryFolder folder;
  const Robot robot = load(folder);
  EXPECT_TRUE(adjacent(robot, "rail", "column"));
  EXPECT_TRUE(adjacent(robot, "arm", "finger"));
  EXPECT_FALSE(adjacent(robot, "rail", "arm"));  // two movable joints apart
  const Robot held = load(folder, kUrdf, {}, [](RobotSource& s) { s.base_link = "column"; });
  EXPECT_TRUE(adjacent(held, "rail", "arm"));  // one, as the slide is held
}

TEST(LoadRobot, AppliesTheTool) {
  const TemporaryFolder folder;
  const Robot robot = load(folder, kUrdf, {}, [](RobotSource& s) {
    s.tool = pose_from_xyz_rpy({0.1, 0.2, 0.3}, {0, 0, 0});
    s.tip_link = "finger";
  });
  EXPECT_EQ(robot.joint_count(), 3);
  EXPECT_EQ(robot.joints()[2].name, "grip");
  EXPECT_EQ(robot.tcp().translation(), Eigen::Vector3d(0.1, 0.2, 0.3));
}

TEST(LoadRobot, LimitsFileComesFirst) {
  const TemporaryFolder folder;
  const Robot robot = load(folder, kUrdf, kLimits);
  EXPECT_EQ(robot.velocity_limits(), (JointVector(3) << 0.5, 1.5, 4).finished());
  EXPECT_EQ(robot.acceleration_limits(), (JointVector(3) << kInfinity, 7, kInfinity).finished());
  EXPECT_EQ(robot.jerk_limits(), (JointVector(3) << kInfinity, kInfinity, 90).finished());
}

TEST(LoadRobot, LimitsFileMayGivePositionLimits) {
  const TemporaryFolder folder;
  const std::string position =
      "joint_limits:\n  swing: {has_position_limits: true, min_position: !degrees -90, "
      "max_position: 1.5}\n  spin: {min_position: -1, max_position: 1}\n";
  const Robot robot = load(folder, kUrdf, position);
  EXPECT_NEAR(robot.joints()[1].lower, -90 * kDegree, 1e-15);
  EXPECT_EQ(robot.joints()[1].upper, 1.5);
  EXPECT_TRUE(warned(robot, "'swing': the limits file allows more"));
  EXPECT_EQ(robot.joints()[2].type, JointType::revolute);
  const std::string bare =
      replaced(kUrdf, "<limit lower=\"-2\" upper=\"1\" effort=\"0\" velocity=\"3\"/>", "");
  const std::string velocity = replaced(position, "max_position: 1.5}",
                                        "max_position: 1.5, "
                                        "max_velocity: 2}");
  EXPECT_EQ(load(folder, bare, velocity).joints()[1].max_velocity, 2);
}

TEST(LoadRobot, AFirstLookNeedsNoVelocityLimits) {
  const TemporaryFolder folder;
  const std::string bare = replaced(kUrdf, " velocity=\"3\"", "");
  EXPECT_TRUE(says(invalid_input([&] { load(folder, bare); }), "'swing': has no velocity"));
  const Robot robot =
      load(folder, bare, {}, [](RobotSource& s) { s.require_velocity_limits = false; });
  EXPECT_EQ(robot.joints()[1].max_velocity, kInfinity);
}

struct Fault {
  std::string name, old_text, new_text, told;
};

std::string instance_name(const testing::TestParamInfo<Fault>& instance) {
  return instance.param.name;
}

class UrdfFaults : public testing::TestWithParam<Fault> {};

TEST_P(UrdfFaults, AreRefused) {
  const TemporaryFolder folder;
  const std::string urdf = replaced(kUrdf, GetParam().old_text, GetParam().new_text);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const std::string message = invalid_input([&] { load(folder, urdf); });
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_TRUE(says(message, "robot.urdf")) << message;
  EXPECT_TRUE(says(message, GetParam().told)) << message;
  EXPECT_FALSE(says(message, "\n")) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, UrdfFaults,
    testing::Values(
        Fault{"Xml", "</robot>", "</robot", "robot.urdf:"},
        Fault{"NoRobotElement", "<robot name=\"cell\">", "<arm name=\"cell\"></arm><robot>", ""},
        Fault{"MalformedNumber", "xyz=\"0 0 0.3\"", "xyz=\"0 0 0.3abc\"", "spin"},
        Fault{"CommaForPoint", "xyz=\"0 0 0.3\"", "xyz=\"0 0 0,3\"", "spin"},
        Fault{"NanOrigin", "xyz=\"0 0 0.3\"", "xyz=\"0 0 nan\"", "spin"},
        Fault{"InfiniteOrigin", "xyz=\"0 0 0.3\"", "xyz=\"0 0 1e999\"", "spin"},
        Fault{"TwoNumbers", "xyz=\"0 0 0.3\"", "xyz=\"0 0\"", "spin"},
        Fault{"MalformedLimit", "upper=\"1\"", "upper=\"1deg\"", "1deg"},
        Fault{"NanLimit", "upper=\"1\"", "upper=\"nan\"", "nan"},
        Fault{"InvertedLimits", "upper=\"1\"", "upper=\"-3\"", "'swing'"},
        Fault{"NoPositionLimits", "lower=\"-2\" upper=\"1\"", "", "'swing': has no position"},
        Fault{"NoLimit", "<limit lower=\"-2\" upper=\"1\" effort=\"0\" velocity=\"3\"/>", "",
              "'swing': has no position limits"},
        Fault{"ZeroVelocity", "velocity=\"3\"", "velocity=\"0\"", "'swing': has no velocity"},
        Fault{"NegativeVelocity", "velocity=\"3\"", "velocity=\"-3\"", "'swing'"},
        Fault{"ZeroAxis", "<axis xyz=\"1 0 0\"/>", "<axis xyz=\"0 0 0\"/>", "'spin'"},
        Fault{"FloatingJoint", "type=\"continuous\"", "type=\"floating\"", "'spin': is floating"},
        Fault{"PlanarJoint", "type=\"continuous\"", "type=\"planar\"", "'spin': is planar"},
        Fault{"UnknownType", "type=\"continuous\"", "type=\"helical\"", "spin"},
        Fault{"Mimic", "<axis xyz=\"1 0 0\"/>", "<axis xyz=\"1 0 0\"/><mimic joint=\"swing\"/>",
              "'spin': mimics joint 'swing'"},
        Fault{"UnknownGeometry", "<sphere radius=\"0.1\"/>", "<capsule radius=\"0.1\"/>",
              "capsule"},
        Fault{"NegativeRadius", "<sphere radius=\"0.1\"/>", "<sphere radius=\"-0.1\"/>", "'arm'"},
        Fault{"ZeroLength", "length=\"0.4\"", "length=\"0\"", "'arm'"},
        Fault{"FlatBox", "size=\"1 2 3\"", "size=\"1 0 3\"", "'rail'"},
        Fault{"MissingMesh", "<sphere radius=\"0.1\"/>", "<mesh filename=\"package://p/a.stl\"/>",
              "package://p/a.stl"},
        Fault{"MeshScheme", "<sphere radius=\"0.1\"/>", "<mesh filename=\"http://p/a.stl\"/>",
              "unknown scheme"},
        Fault{"DuplicateLink", "<link name=\"tip\"/>", "<link name=\"arm\"/>", "arm"},
        Fault{"UnknownParent", "<parent link=\"bracket\"/>", "<parent link=\"none\"/>", "none"},
        Fault{"TwoRoots", "<link name=\"tip\"/>", "<link name=\"tip\"/><link name=\"second\"/>",
              "second"}),
    instance_name);

TEST(LoadRobot, NamesLinksThatAreNotThere) {
  const TemporaryFolder folder;
  const std::string unknown =
      invalid_input([&] { load(folder, kUrdf, {}, [](RobotSource& s) { s.tip_link = "tipp"; }); });
  EXPECT_TRUE(says(unknown, "no link 'tipp'")) << unknown;
  EXPECT_TRUE(says(unknown, "'tip'")) << unknown;
  const std::string upward = invalid_input([&] {
    load(folder, kUrdf, {}, [](RobotSource& s) {
      s.base_link = "tip";
      s.tip_link = "finger";
    });
  });
  EXPECT_TRUE(says(upward, "'tip'") && says(upward, "'finger'")) << upward;
  const std::string still = invalid_input([&] {
    load(folder, kUrdf, {}, [](RobotSource& s) {
      s.base_link = "hall";
      s.tip_link = "rail";
    });
  });
  EXPECT_TRUE(says(still, "no movable joint")) << still;
  EXPECT_TRUE(says(
      invalid_input([&] { load(folder, kUrdf, {}, [](RobotSource& s) { s.urdf = "nowhere"; }); }),
      "no such file"));
}

class LimitsFaults : public testing::TestWithParam<Fault> {};

TEST_P(LimitsFaults, AreRefusedWithTheirLine) {
  const TemporaryFolder folder;
  const std::string limits = replaced(kLimits, GetParam().old_text, GetParam().new_text);
  const std::string message = invalid_input([&] { load(folder, kUrdf, limits); });
  EXPECT_TRUE(says(message, "limits.yaml")) << message;
  EXPECT_TRUE(says(message, GetParam().told)) << message;
  EXPECT_FALSE(says(message, "\n")) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, LimitsFaults,
    testing::Values(
        Fault{"UnknownKey", "max_velocity: 1.5", "max_velocty: 1.5",
              "limits.yaml:5: joint 'swing', key 'max_velocty': unknown key; expected "
              "'max_velocity'"},
        Fault{"NoNumber", "1.5", "fast", "limits.yaml:5: joint 'swing', key 'max_velocity'"},
        Fault{"Negative", "1.5", "-1.5", "key 'max_velocity'"},
        Fault{"Zero", "1.5", "0", "key 'max_velocity'"},
        Fault{"Nan", "1.5", ".nan", "key 'max_velocity'"},
        Fault{"Infinite", "1.5", ".inf", "key 'max_velocity'"},
        Fault{"List", "1.5", "[1, 2]", "key 'max_velocity'"},
        Fault{"Missing", "    max_velocity: 1.5\n", "", "key 'max_velocity': is missing"},
        Fault{"NoTruthValue", "has_velocity_limits: true", "has_velocity_limits: 3",
              "key 'has_velocity_limits'"},
        Fault{"Tag", "1.5", "!rpm 1.5", "unknown tag"},
        Fault{"TwiceInJoint", "max_velocity: 1.5", "max_velocity: 1.5\n    max_velocity: 2",
              "key 'max_velocity': is given twice"},
        Fault{"JointTwice", "elsewhere", "swing", "joint 'swing' is given twice"},
        Fault{"InvertedPosition", "max_jerk: 90",
              "max_jerk: 90\n    min_position: 2\n    "
              "max_position: 1",
              "key 'min_position'"},
        Fault{"HalfPosition", "max_jerk: 90", "max_jerk: 90\n    min_position: 2",
              "key 'max_position': is missing"},
        Fault{"NoMapping", "elsewhere:\n    max_velocity: 3", "elsewhere: 3", "'elsewhere'"},
        Fault{"NoJointLimits", "joint_limits:", "limits:", "no mapping 'joint_limits'"},
        Fault{"Yaml", "joint_limits:", "joint_limits: {", "not valid YAML"}),
    instance_name);

TEST(ResolveMesh, SearchesPackagesAndRelativePaths) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "my_robot" / "meshes");
  const auto mesh = folder.write("my_robot/meshes/a.stl", "solid");
  const auto same = [&](const std::string& uri, const MeshFolders& folders) {
    return std::filesystem::equivalent(resolve_mesh(uri, folders, "test"), mesh);
  };
  const std::string uri = "package://my_robot/meshes/a.stl";
  EXPECT_TRUE(same(uri, {"/", {"/nowhere", folder.path()}}));   // contains the package
  EXPECT_TRUE(same(uri, {"/", {folder.path() / "my_robot"}}));  // is the package
  EXPECT_TRUE(same(uri, {"/", {(folder.path() / "my_robot").string() + "/"}}));
  EXPECT_TRUE(same("meshes/a.stl", {folder.path() / "my_robot", {}}));
  EXPECT_TRUE(same("file://" + mesh.string(), {"/", {}}));
  const std::string missing = invalid_input([&] {
    resolve_mesh("package://other/a.stl", {"/", {folder.path()}}, "test");
  });
  EXPECT_TRUE(says(missing, "package://other/a.stl") && says(missing, folder.path().string()));
}

}  // namespace
}  // namespace wristwise
