// Robot programs and ROS messages as joint paths.

#include <gtest/gtest.h>

#include <cmath>

#include "export_example.hpp"
#include "invalid_input.hpp"
#include "random_arm.hpp"
#include "temporary_folder.hpp"
#include "wristwise/kinematics.hpp"
#include "wristwise/program_file.hpp"

namespace wristwise {
namespace {

using test::Dice;
using test::export_example;
using test::ExportExample;
using test::invalid_input;
using test::kDegree;
using test::says;

class JointProgram : public testing::Test {
 protected:
  JointPath read(const std::string& name, const std::string& text) {
    return read_joint_path(folder_.write(name, text), *robot_, options_);
  }
  std::string error(const std::string& name, const std::string& text) {
    const std::string message = invalid_input([&] { read(name, text); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(says(message, name)) << message;
    return message;
  }
  void expect_point(const JointPath& path, std::size_t i, double rail_mm,
                    const std::array<double, 6>& degrees) {
    ASSERT_LT(i, path.size());
    EXPECT_LT((path.positions[i] - test::rail_posture(rail_mm, degrees)).cwiseAbs().maxCoeff(),
              1e-12)
        << i;
  }

  test::TemporaryFolder folder_;
  std::shared_ptr<const Robot> robot_ = test::rail_robot();
  ExportOptions options_;
};

// ---- KRL

TEST_F(JointProgram, KrlWithPointsOfTheDatFile) {
  folder_.write("weld.dat",
                "&ACCESS RVP\nDEFDAT WELD PUBLIC\nEXT BAS (BAS_COMMAND :IN,REAL :IN )\n"
                "DECL E6AXIS XHOME={A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0,E1 -250.5}\n"
                "DECL GLOBAL E6AXIS XP1 = {E6AXIS: A1 1.0E1, A2 -80.5, A3 +85, A4 0, A5 .5, A6 0, "
                "E1 0.0, E2 0.0, S 'B010', T 2} ; a comment\n"
                "DECL FDAT FP1={TOOL_NO 1,BASE_NO 0,IPO_FRAME #BASE,POINT2[] \" \"}\n"
                "DECL PDAT PPDAT1={VEL 100.0,ACC 100.0,APO_DIST 100.0}\nENDDAT\n");
  const JointPath path = read("weld.src",
                              "&ACCESS RVP\n&REL 3\nDEF weld( )\n;FOLD INI;%{PE}\n"
                              "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\n"
                              "INTERRUPT ON 3\nBAS (#INITMOV,0 )\n;ENDFOLD\n$BWDSTART=FALSE\n"
                              "PDAT_ACT=PPDAT1\nFDAT_ACT=FP1\nBAS(#PTP_PARAMS,50)\nPTP XHOME\n"
                              "ptp xp1 c_ptp\n$OUT[3]=TRUE\nWAIT SEC 0.5\n"
                              "PTP {A1 20} C_PTP\nEND\n");
  ASSERT_EQ(path.size(), 3u);
  expect_point(path, 0, -250.5, {0, -90, 90, 0, 0, 0});
  expect_point(path, 1, 0, {10, -80.5, 85, 0, 0.5, 0});
  expect_point(path, 2, 0, {20, -80.5, 85, 0, 0.5, 0});
  // At half of 2 rad/s (or m/s) the rail is the slowest by 0.2505 s.
  EXPECT_NEAR(path.times[1], 0.2505, 1e-12);
  EXPECT_NEAR(path.times[2] - path.times[1], 10 * kDegree, 1e-12);
}

TEST_F(JointProgram, KrlSpeedOfEachAxis) {
  const std::string targets =
      "PTP {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0,E1 0}\nPTP {A1 10,A2 10,A3 0,A4 0,A5 0,A6 0,E1 0}\n";
  const JointPath path = read("a.src", "$VEL_AXIS[1]=10\n$VEL_AXIS[2]=20\n" + targets);
  EXPECT_NEAR(path.times[1], 10 * kDegree / (2 * 0.1), 1e-12);
  const JointPath all = read("b.src", "BAS(#VEL_PTP,25)\n" + targets);
  EXPECT_NEAR(all.times[1], 10 * kDegree / (2 * 0.25), 1e-12);
}

TEST_F(JointProgram, KrlTimesOfASplineBlock) {
  const std::string start = "PTP {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0,E1 0}\nPTP_SPLINE\n";
  const JointPath path =
      read("a.src", start +
                        "TIME_BLOCK START\nSPTP {A1 1}\nTIME_BLOCK PART = 25\nSPTP {A1 2}\n"
                        "TIME_BLOCK PART = 75\nTIME_BLOCK END = 8\nSPTP {A1 3}\nENDSPLINE C_SPL\n");
  ASSERT_EQ(path.size(), 4u);
  EXPECT_EQ(path.times[1], 2);
  EXPECT_EQ(path.times[2], 8);
  EXPECT_NEAR(path.times[3], 8 + kDegree / 2, 1e-12);
  EXPECT_TRUE(
      says(error("b.src", start + "TIME_BLOCK START\nSPTP {A1 1}\nTIME_BLOCK END=3\n"), "b.src:5"));
  EXPECT_TRUE(says(error("c.src", start + "TIME_BLOCK START\nSPTP {A1 1}\n"), "without END"));
  EXPECT_TRUE(says(error("d.src", start + "SPTP {A1 1}\nTIME_BLOCK PART=1\n"), "d.src:4"));
  EXPECT_TRUE(says(error("e.src", start + "TIME_BLOCK START\nSPTP {A1 1}\nTIME_BLOCK PART=-1\n"
                                          "TIME_BLOCK END=3\n"),
                   "above zero"));
}

TEST_F(JointProgram, KrlThatIsNotUnderstoodNamesTheLine) {
  const std::string start = "DEF a()\nPTP {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0,E1 0}\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"IF $IN[1] THEN", "'IF' is not understood"},
      {"LOOP", "'LOOP' is not understood"},
      {"MY_SUB()", "'MY_SUB' is not understood"},
      {"CIRC XP1, XP2", "'CIRC' is not understood"},
      {"PTP_REL {A1 1}", "'PTP_REL' is not understood"},
      {"PTP XP9", "'XP9' has no value"},
      {"PTP {A1 1", "'}'"},
      {"PTP {A1 nan}", "finite number"},
      {"PTP {A1 1e999}", "finite"},
      {"PTP {A1 }", "finite number"},
      {"PTP {A1 1,A1 2}", "given twice"},
      {"PTP {A1 1,X 2}", "either"},
      {"PTP {S 2}", "without values"},
      {"PTP", "the end of the line"},
      {"PTP {A1 1} WITH $VEL_AXIS[1]=3", "'WITH' is not understood"},
      {"LIN {X 1,Y 2,Z 3,A 0,B 0,C 0}", "a linear move"},
      {"PTP {X 1,Y 2,Z 3,A 0,B 0,C 0}", "a joint move to a pose"},
      {"PTP {X 1}", "no Y"},
      {"LIN {A1 3}", "linear move to values of axes"},
      {"BAS(#VEL_PTP,0)", "out of range"},
      {"$VEL_AXIS[7]=3", "no such axis"},
      {"$VEL_AXIS[1]=300", "out of range"},
      {"$VEL.CP=0", "above zero"},
      {"$VEL={CP 1}", "'$VEL' is not understood"},
      {"X Y = 3", "'X' is not understood"},
      {"DEF b()", "second program"},
      {"E6AXIS XA[3]", "no arrays"},
      {"\x01\x02", "'?'"},
  };
  for (const auto& [line, part] : cases) {
    const std::string message = error("a.src", start + line + "\nEND\n");
    EXPECT_TRUE(says(message, part)) << line << "\n" << message;
    EXPECT_TRUE(says(message, "a.src:3")) << line << "\n" << message;
  }
  EXPECT_TRUE(says(error("a.src", ""), "0 points"));
  EXPECT_TRUE(says(error("a.src", start), "1 points"));
  EXPECT_TRUE(says(error("a.src", "PTP {A1 1}\n"), "a.src:1"));
}

// ---- RAPID

TEST_F(JointProgram, RapidTargetsSpeedsAndTimes) {
  const JointPath path = read(
      "weld.mod",
      "%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\nMODULE weld(SYSMODULE)\n"
      "  CONST jointtarget home:=[[0,-90,90,0,0,0],[-250.5,9E9,9E9,9E9,9E9,9E9]];\n"
      "  LOCAL PERS jointtarget j1 := [[10,-80.5,85,0,.5,0],\n    [0,9E+09,9E9,9E9,9E9,9E9]];\n"
      "  VAR speeddata slow:=[100,500,5000,1000]; ! a comment; with a semicolon\n"
      "  PERS tooldata torch:=[TRUE,[[0,0,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
      "  PROC main()\n    ConfJ\\Off;\n    MoveAbsJ home,v1000,fine,torch;\n"
      "    MoveAbsJ\\Conc,j1\\NoEOffs,v1000\\T:=2.5,z10,torch\\WObj:=wobj0;\n    SetDO doWeld,1;\n"
      "    MoveAbsJ "
      "[[20,-80.5,85,0,0.5,0],[0,9E9,9E9,9E9,9E9,9E9]]\\ID:=20,slow,z1\\Inpos:=inpos50,"
      "torch;\n    MoveAbsJ home,vmax,fine,torch;\n  ENDPROC\nENDMODULE\n");
  ASSERT_EQ(path.size(), 4u);
  expect_point(path, 0, -250.5, {0, -90, 90, 0, 0, 0});
  expect_point(path, 1, 0, {10, -80.5, 85, 0, 0.5, 0});
  expect_point(path, 3, -250.5, {0, -90, 90, 0, 0, 0});
  EXPECT_EQ(path.times[1], 2.5);
  const double length = (tcp_pose(*robot_, path.positions[2]).translation() -
                         tcp_pose(*robot_, path.positions[1]).translation())
                            .norm();
  EXPECT_NEAR(path.times[2] - 2.5, std::max(length / 0.1, 10 * kDegree / 2), 1e-12);
  EXPECT_NEAR(path.times[3] - path.times[2], std::max(20 * kDegree, 0.2505) / 2, 1e-12);
}

TEST_F(JointProgram, RapidThatIsNotUnderstoodNamesTheLine) {
  const std::string start =
      "MODULE m\nPROC p()\nMoveAbsJ [[0,0,0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"IF x THEN", "'IF' is not understood"},
      {"helper;", "'HELPER' is not understood"},
      {"MoveC a,b,v10,fine,t;", "'MOVEC' is not understood"},
      {"MoveAbsJ j9,v10,fine,t;", "'J9' is not understood"},
      {"MoveAbsJ *,v10,fine,t;", "'*' is not understood"},
      {"MoveAbsJ [[0,0,0,0,0,0],[0]],v10,fine,t;", "7 numbers"},
      {"MoveAbsJ [[0,0,0,0,0,x],[0,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;", "finite"},
      {"MoveAbsJ [[0,0,0,0,0,1e999],[0,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;", "finite"},
      {"MoveAbsJ [[0,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;", "no value for axis E1"},
      {"MoveAbsJ [[0,0,0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],vx,fine,t;", "'VX' is not understood"},
      {"MoveAbsJ [[0,0,0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v10\\T:=0,fine,t;", "above zero"},
      {"MoveAbsJ [[0,0,0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v10\\Q:=1,fine,t;", "\\Q"},
      {"MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;", "a linear move"},
      {"MoveJ [[1,2,3],[1,0,0,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;", "to a pose"},
      {"MoveL [[1,2,3],[1,1,0,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],v10,fine,t;", "norm"},
      {"PROC q()", "second procedure"},
      {"VelSet 0,1;", "out of range"},
      {"CONST jointtarget a{2}:=[];", "no arrays"},
      {"MoveAbsJ [[[[[[[[0", "too deep"},
  };
  for (const auto& [line, part] : cases) {
    const std::string message = error("a.mod", start + line + "\nENDPROC\nENDMODULE\n");
    EXPECT_TRUE(says(message, part)) << line << "\n" << message;
    EXPECT_TRUE(says(message, "a.mod:4")) << line << "\n" << message;
  }
  EXPECT_TRUE(says(error("a.mod", ""), "0 points"));
}

// ---- Fanuc LS

constexpr const char* kLs =
    "/PROG  WELD\n/ATTR\nOWNER = MNEDITOR;\nTCD:  STACK_SIZE = 0,\n      TASK_PRIORITY = 50;\n"
    "/APPL\n/MN\n   1:  !a remark ;\n   2:  UFRAME_NUM=0 ;\n   3:J P[1] 100% FINE ;\n"
    "   4:J P[2:\"start\"] 1.5sec CNT100\n    :  ACC50 ;\n   5:  Arc Start[1] ;\n"
    "   6:J P[3] 250msec CNT100 ;\n   7:J P[1] 50% FINE ;\n   8:   ;\n/POS\nP[1]{\n   GP1:\n"
    "\tUF : 0, UT : 1,\n\tJ1= 0.000 deg,\tJ2= -90 deg,\tJ3= 180 deg,\n"
    "\tJ4= 0 deg,\tJ5= 0 deg,\tJ6= 0 deg,\n\tE1= -250.5 mm\n};\nP[2:\"start\"]{\n   GP1:\n"
    "\tUF : F, UT : F,\tJ1= 10 deg, J2= -80.5 deg, J3= 165.5 deg, J4= 0 deg, J5= .5 deg, J6= 0 deg,"
    " E1= 0 mm\n};\nP[3]{\n   GP1:\n\tUF : 0, UT : 1,\tJ1= 20 deg, J2= -80.5 deg, J3= 165.5 deg, "
    "J4= 0 deg, J5= 0.5 deg, J6= 0 deg, E1= 0 mm\n};\n/END\n";

TEST_F(JointProgram, LsPositionsTimesAndCoupling) {
  const JointPath path = read("weld.ls", kLs);
  ASSERT_EQ(path.size(), 4u);
  expect_point(path, 0, -250.5, {0, -90, 90, 0, 0, 0});  // J3 from the horizontal is 180
  expect_point(path, 1, 0, {10, -80.5, 85, 0, 0.5, 0});
  expect_point(path, 2, 0, {20, -80.5, 85, 0, 0.5, 0});
  EXPECT_EQ(path.times[1], 1.5);
  EXPECT_NEAR(path.times[2], 1.75, 1e-12);
  EXPECT_NEAR(path.times[3] - path.times[2], std::max(20 * kDegree, 0.2505), 1e-12);
  options_.ls.j3_coupling = 0;
  expect_point(read("weld.ls", kLs), 0, -250.5, {0, -90, 180, 0, 0, 0});
}

TEST_F(JointProgram, LsThatIsNotUnderstoodNamesTheLine) {
  const auto changed = [&](const std::string& old_part, const std::string& new_part) {
    return error("a.ls", test::replaced(kLs, old_part, new_part));
  };
  const auto line3 = [&](const std::string& text) {
    const std::string message = changed("J P[1] 100% FINE", text);
    EXPECT_TRUE(says(message, "a.ls:10")) << message;
    return message;
  };
  EXPECT_TRUE(says(line3("CALL SUB"), "'CALL' is not understood"));
  EXPECT_TRUE(says(line3("JMP LBL[1]"), "'JMP' is not understood"));
  EXPECT_TRUE(says(line3("C P[1] P[2] 10mm/sec FINE"), "'C' is not understood"));
  EXPECT_TRUE(says(line3("J PR[1] 100% FINE"), "'PR' is not understood"));
  EXPECT_TRUE(says(line3("J P[R[1]] 100% FINE"), "finite number"));
  EXPECT_TRUE(says(line3("J P[1] R[1]% FINE"), "finite number"));
  EXPECT_TRUE(says(line3("J P[1] 0% FINE"), "above zero"));
  EXPECT_TRUE(says(line3("J P[1] 10furlong/sec FINE"), "FURLONG"));
  EXPECT_TRUE(says(line3("J P[1] 10% FINE Offset,PR[1]"), "'OFFSET' is not understood"));
  EXPECT_TRUE(says(line3("J P[9] 10% FINE"), "no position P[9]"));
  EXPECT_TRUE(says(line3("J P[1.5] 10% FINE"), "whole number"));
  EXPECT_TRUE(says(line3("L P[1] 10mm/sec FINE"), "a linear move"));
  EXPECT_TRUE(says(changed("J2= -90 deg", "J2= ******** deg"), "finite number"));
  EXPECT_TRUE(says(changed("J2= -90 deg", "J2= nan deg"), "finite number"));
  EXPECT_TRUE(says(changed("J2= -90 deg", "J2= -90"), "deg or mm"));
  EXPECT_TRUE(says(changed("J2= -90 deg,", ""), "no value for axis A2"));
  EXPECT_TRUE(says(changed("J2= -90 deg", "J9= -90 deg"), "'J9' is not understood"));
  EXPECT_TRUE(says(changed("   GP1:\n", "   GP2:\n"), "motion group"));
  EXPECT_TRUE(says(changed("P[3]{", "P[1]{"), "given twice"));
  EXPECT_TRUE(says(changed("};\n/END\n", ""), "a.ls:"));
  EXPECT_TRUE(says(error("a.ls", ""), "no instructions"));
  EXPECT_TRUE(says(error("a.ls", "/MN\n 1:J P[1] 10% FINE\n"), "an instruction without an end"));
}

// ---- ROS

TEST_F(JointProgram, RosMessagesOfBothVersions) {
  const std::string body =
      "joint_names: [joint_1, joint_2, joint_3, joint_4, joint_5, joint_6, gripper, rail]\n"
      "points:\n- positions: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 9, -1]\n";
  for (const std::string& times :
       {std::string("{sec: 0, nanosec: 0}"), std::string("{secs: 0, nsecs: 0}")}) {
    const JointPath path =
        read("a.yaml", body + "  time_from_start: " + times +
                           "\n- positions: [1, 2, 3, 4, 5, 6, 9, 7]\n" +
                           "  time_from_start: {sec: 1, nanosec: 500000000}\n---\n");
    ASSERT_EQ(path.size(), 2u);
    EXPECT_EQ(path.positions[0][0], -1);
    EXPECT_EQ(path.positions[0][1], 0.1);
    EXPECT_EQ(path.positions[1][6], 6);
    EXPECT_EQ(path.times[1], 1.5);
  }
  EXPECT_TRUE(says(error("b.yaml", "joint_names: [rail]\npoints: []\n"), "joint_1"));
  EXPECT_TRUE(
      says(error("b.yaml", body + "  time_from_start: {sec: 0, nanosec: 0}\n"), "1 points"));
  EXPECT_TRUE(says(error("b.yaml", body), "time_from_start"));
  EXPECT_TRUE(
      says(error("b.yaml", body + "  time_from_start: {sec: .nan, nanosec: 0}\n"), "not finite"));
  EXPECT_TRUE(says(error("b.yaml", ""), "b.yaml"));
}

// ---- what is exported comes back

TEST_F(JointProgram, ExportsComeBack) {
  Dice dice(11);
  for (int trial = 0; trial < 25; ++trial) {
    ExportExample example = export_example();
    JointPath& path = example.result.path;
    path = {};
    double t = 0;
    for (int i = 0; i < 20; ++i) {
      path.times.push_back(t);
      path.positions.push_back(dice.posture(7));
      t += dice.uniform(0.01, 3);
    }
    example.problem.task = test::task_with_runs(path.times);
    example.problem.exports.axes = {{7, -1, 0.5}, {0, -1, 0.1}, {1, 1, -1},  {2, -1, 1},
                                    {3, 1, 0},    {5, -1, 3},   {4, 1, 0.25}};
    example.problem.exports.ls.j3_coupling = trial % 3 - 1;
    for (const ProgramFormat format : program_formats()) {
      const auto file = write_program(format, folder_.path(), example.result, example.problem);
      const JointPath back = read_joint_path(file, *robot_, example.problem.exports);
      ASSERT_EQ(back.size(), path.size()) << file;
      for (std::size_t i = 0; i < path.size(); ++i) {
        EXPECT_NEAR(back.times[i], path.times[i], 0.51e-3) << file;
        EXPECT_LT((back.positions[i] - path.positions[i]).cwiseAbs().maxCoeff(),
                  0.6e-4 * kDegree * 2)
            << file;
      }
    }
  }
}

TEST_F(JointProgram, StartsWhenItIsTold) {
  const auto file = folder_.write("weld.LS", kLs);
  const JointPath path = read_joint_path(file, *robot_, options_, -2);
  EXPECT_EQ(path.times[0], -2);
  EXPECT_EQ(path.times[1], -0.5);
}

TEST_F(JointProgram, LineEndsOfWindowsMakeNoDifference) {
  const ExportExample example = export_example();
  for (const ProgramFormat format : program_formats()) {
    const auto file = write_program(format, folder_.path(), example.result, example.problem);
    const std::string text = test::file_text(file), name = file.filename().string();
    std::string windows;
    for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const JointPath path = read(name, text), same = read(name, windows);
    EXPECT_EQ(path.times, same.times) << name;
    EXPECT_EQ(path.positions, same.positions) << name;
  }
}

TEST_F(JointProgram, OtherExtensionsAreCsv) {
  EXPECT_TRUE(says(error("a.txt", "time,rail\n0,0\n"), "joint_1"));
}

// ---- no damaged file crashes

TEST_F(JointProgram, DamagedFilesAreReadOrRefused) {
  std::mt19937 random(12);
  const ExportExample example = export_example();
  std::vector<std::pair<std::string, std::string>> files = {{"weld.ls", kLs}};
  for (const ProgramFormat format : program_formats()) {
    const auto file = write_program(format, folder_.path(), example.result, example.problem);
    files.emplace_back(file.filename().string(), test::file_text(file));
  }
  const auto read_or_refuse = [&](const std::string& name, const std::string& text) {
    try {
      const JointPath path = read(name, text);
      for (const JointVector& q : path.positions) EXPECT_TRUE(q.allFinite());
    } catch (const InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  };
  for (const auto& [name, text] : files) {
    for (int trial = 0; trial < 80; ++trial) {
      std::string damaged = text.substr(0, random() % (text.size() + 1));
      read_or_refuse(name, damaged);
      damaged = text;
      for (int k = 0; k < 1 + trial % 4; ++k)
        damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8));
      read_or_refuse(name, damaged);
      damaged = text;
      const std::size_t from = random() % text.size();
      damaged.erase(from, random() % 40);
      damaged.insert(random() % damaged.size(), text, random() % text.size(), random() % 60);
      read_or_refuse(name, damaged);
    }
    read_or_refuse(name, std::string(100000, '{'));
    read_or_refuse(name, std::string(100000, '['));
    read_or_refuse(name, "P[1]" + std::string(1000, '\0'));
  }
}

}  // namespace
}  // namespace wristwise
