// A robot program as a seam.

#include <gtest/gtest.h>

#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;

constexpr double kDegree = 3.14159265358979323846 / 180;
const std::string kUrdf =
    std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/kuka_kr5_arc.urdf";

class SeamProgram : public testing::Test {
 protected:
  Problem load(const std::string& name, const std::string& program,
               const std::string& speed = "  speed: 10 mm/s\n") {
    folder_.write(name, program);
    return load_problem(folder_.write(
        "p.yaml",
        "robot: {urdf: " + kUrdf +
            ", base_link: base_link, tip_link: torch_tip}\nscene: {collision: off}\npath:\n"
            "  frame: {xyz: [1, 0, 0]}\n  spacing: 1\n" +
            speed + "  segments:\n    - {program: " + name + ", tolerance: {x: 1 mm}}\n"));
  }
  std::string error(const std::string& name, const std::string& program) {
    const std::string message = invalid_input([&] { load(name, program); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  static void expect_frame(const Waypoint& waypoint, const Eigen::Vector3d& xyz,
                           const Eigen::Vector3d& rpy_degrees) {
    const Pose expected = pose_from_xyz_rpy(xyz, rpy_degrees * kDegree);
    EXPECT_LT((waypoint.frame.matrix() - expected.matrix()).norm(), 1e-6);
  }

  test::TemporaryFolder folder_;
};

constexpr const char* kKrl =
    "DEF a()\nPTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}\n$VEL.CP=0.02\n"
    "PTP {X 0,Y -100,Z 500,A 0,B 180,C 0}\nLIN {X 0,Y 100,Z 500,A 10,B 170,C 5} C_DIS\n"
    "LIN {Y 200}\nPTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}\nEND\n";

TEST_F(SeamProgram, KrlLinesInThePartsFrameBetweenJointWaypoints) {
  const Problem problem = load("a.src", kKrl);
  const auto& waypoints = problem.task.waypoints;
  ASSERT_EQ(waypoints.size(), 5u);
  EXPECT_TRUE(waypoints[0].joints);
  EXPECT_NEAR(waypoints[0].joints->lower[1], -90 * kDegree, 1e-12);
  expect_frame(waypoints[1], {1, -0.1, 0.5}, {0, 180, 0});
  expect_frame(waypoints[2], {1, 0.1, 0.5}, {5, 170, 10});
  expect_frame(waypoints[3], {1, 0.2, 0.5}, {5, 170, 10});
  EXPECT_TRUE(waypoints[4].joints);
  EXPECT_EQ(waypoints[2].tolerance.upper[0], 1e-3);
  EXPECT_NEAR(waypoints[2].time - waypoints[1].time, 20, 1e-9) << "path.speed counts";
}

TEST_F(SeamProgram, SpeedsOfTheProgramWhereTheProblemHasNone) {
  const std::string lines =
      "$VEL.CP=0.02\nPTP {X 0,Y -100,Z 500,A 0,B 180,C 0}\n"
      "LIN {X 0,Y 100,Z 500,A 0,B 180,C 0}\nBAS(#VEL_CP,0.1)\nLIN {Y 200}\n";
  const auto waypoints = load("a.src", lines, "").task.waypoints;
  ASSERT_EQ(waypoints.size(), 3u);
  EXPECT_NEAR(waypoints[1].time - waypoints[0].time, 10, 1e-9);
  EXPECT_NEAR(waypoints[2].time - waypoints[1].time, 1, 1e-9);
}

TEST_F(SeamProgram, RapidLines) {
  const auto waypoints =
      load("a.mod",
           "MODULE m\nCONST robtarget p1:=[[0,-100,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,"
           "9E9]];\nPROC p()\nMoveJ p1,v100,fine,torch\\WObj:=part;\n"
           "MoveL "
           "[[0,100,500],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v50,z1,"
           "torch\\WObj:=part;\nENDPROC\nENDMODULE\n",
           "")
          .task.waypoints;
  ASSERT_EQ(waypoints.size(), 2u);
  expect_frame(waypoints[0], {1, -0.1, 0.5}, {0, 180, 0});
  const Eigen::Matrix3d turned =
      Eigen::Quaterniond(0, std::sqrt(0.5), std::sqrt(0.5), 0).toRotationMatrix();
  EXPECT_LT((waypoints[1].frame.linear() - turned).norm(), 1e-6);
  EXPECT_NEAR(waypoints[1].time, 4, 1e-9);
}

constexpr const char* kLs =
    "/PROG A\n/MN\n 1:J P[1] 10% FINE ;\n 2:  Arc Start[1] ;\n 3:L P[2] 60cm/min CNT100 ;\n"
    " 4:  Arc End[1] ;\n/POS\nP[1]{\n GP1:\n UF : 1, UT : 1, CONFIG : 'N U T, 0, 0, 0',\n"
    " X = 0 mm, Y = -100 mm, Z = 500 mm,\n W = 0 deg, P = 180 deg, R = 0 deg\n};\n"
    "P[2]{\n GP1:\n UF : 1, UT : 1, CONFIG : 'N U T, 0, 0, 0',\n X = 0 mm, Y = 100 mm, Z = 500 "
    "mm,\n"
    " W = 5 deg, P = 170 deg, R = 10 deg\n};\n/END\n";

TEST_F(SeamProgram, FanucLines) {
  const auto waypoints = load("a.ls", kLs, "").task.waypoints;
  ASSERT_EQ(waypoints.size(), 2u);
  expect_frame(waypoints[0], {1, -0.1, 0.5}, {0, 180, 0});
  expect_frame(waypoints[1], {1, 0.1, 0.5}, {5, 170, 10});
  EXPECT_NEAR(waypoints[1].time, 20, 1e-9);
}

TEST_F(SeamProgram, LinesStartWhereTheJointMoveBeforeThemEnds) {
  const Robot& robot = *load("a.src", kKrl).robot;
  JointVector q(6);
  q << 0.1, -1.4, 1.5, 0, 0.5, 0;
  const Pose tcp = tcp_pose(robot, q);
  std::string start = "PTP {";
  for (int j = 0; j < 6; ++j)
    start += (j > 0 ? ",A" : "A") + std::to_string(j + 1) + " " + std::to_string(q[j] / kDegree);
  const Eigen::Vector3d end = (tcp.translation() - Eigen::Vector3d(1, -0.1, 0)) * 1e3;
  const auto waypoints =
      load("a.src", start + "}\nLIN {X " + std::to_string(end[0]) + ",Y " + std::to_string(end[1]) +
                        ",Z " + std::to_string(end[2]) + ",A 0,B 90,C 0}\n")
          .task.waypoints;
  ASSERT_EQ(waypoints.size(), 2u);
  EXPECT_LT((waypoints[0].frame.matrix() - tcp.matrix()).norm(), 1e-6);
  EXPECT_LT(
      (waypoints[1].frame.translation() - tcp.translation() - Eigen::Vector3d(0, 0.1, 0)).norm(),
      1e-6);
}

TEST_F(SeamProgram, WhatIsNotUnderstoodIsOneLine) {
  const std::string start = "PTP {X 0,Y -100,Z 500,A 0,B 180,C 0}\n";
  EXPECT_TRUE(says(error("a.src", "LIN {X 0,Y -100,Z 500,A 0,B 180,C 0}\n"), "without a start"));
  EXPECT_TRUE(says(error("a.src", start + start + "LIN {Y 100}\n"), "that no linear move follows"));
  EXPECT_TRUE(says(error("a.src", start + "LIN {Y 100}\n" + start), "a.src:3"));
  EXPECT_TRUE(says(error("a.src", start + "$BASE={X 0}\nLIN {Y 100}\n"), "a.src:2"));
  EXPECT_TRUE(says(error("a.src", start + "BAS(#TOOL,2)\nLIN {Y 100}\n"), "changes between"));
  EXPECT_TRUE(says(error("a.src", start + "LIN {Y -100}\n"), "repeated waypoint"));
  EXPECT_TRUE(says(error("a.src", ""), "no moves"));
  EXPECT_TRUE(says(error("a.txt", ""), "extension"));
  const std::string ls = kLs;
  EXPECT_TRUE(says(
      error("a.ls",
            test::replaced(ls, "UF : 1, UT : 1, CONFIG : 'N U T, 0, 0, 0',\n X = 0 mm, Y = 100",
                           "UF : 2, UT : 1, CONFIG : 'N U T, 0, 0, 0',\n X = 0 mm, Y = 100")),
      "another user frame"));
  EXPECT_TRUE(says(error("a.ls", test::replaced(ls, " W = 5 deg,", "")), "no W"));
  EXPECT_TRUE(says(error("a.ls", test::replaced(ls, " W = 5 deg,", " J1 = 5 deg,")), "either"));
}

}  // namespace
}  // namespace wristwise
