// Files of poses: their columns and units.

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

class PoseList : public testing::Test {
 protected:
  PoseList() { folder_.write("gantry.urdf", test::kGantryUrdf); }

  /// The waypoints of a seam of that file.
  std::vector<Waypoint> waypoints(const std::string& csv, const std::string& poses = "poses.csv") {
    folder_.write("poses.csv", csv);
    return load_problem(folder_.write("p.yaml",
                                      "robot: {urdf: gantry.urdf}\npath:\n  speed: 1\n  segments:\n"
                                      "    - poses: " +
                                          poses + "\n"))
        .task.waypoints;
  }
  std::string error(const std::string& csv, const std::string& poses = "poses.csv") {
    const std::string message = invalid_input([&] { waypoints(csv, poses); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  static void expect_pose(const Pose& pose, const Eigen::Vector3d& xyz, const Eigen::Matrix3d& r) {
    EXPECT_LT((pose.translation() - xyz).norm(), 1e-12);
    EXPECT_LT((pose.linear() - r).norm(), 1e-12);
  }

  test::TemporaryFolder folder_;
};

Eigen::Matrix3d about_z(double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

TEST_F(PoseList, TheHeaderSaysTheOrderOfTheQuaternion) {
  const double c = std::cos(15 * kDegree), s = std::sin(15 * kDegree);
  const std::string w = std::to_string(c) + ",", z = std::to_string(s) + ",";
  for (const auto& [header, values] :
       {std::pair<std::string, std::string>{"qw,qx,qy,qz,", w + "0,0," + z},
        {"qx,qy,qz,qw,", "0,0," + z + w},
        {"qz,qw,qx,qy,", z + w + "0,0,"}}) {
    const auto read = waypoints(header + "x,y,z\n" + values + "1,2,3\n" + values + "1.5,2,3\n");
    ASSERT_EQ(read.size(), 2u);
    EXPECT_LT((read[0].frame.linear() - about_z(30)).norm(), 1e-5) << header;
  }
}

TEST_F(PoseList, UnitsInTheHeader) {
  const auto read = waypoints(
      "time_ms,x_mm,y_cm,z_m,rx_deg,ry_rad,rz_deg\n0,100,20,0.3,0,0,30\n500,200,20,0.3,0,0,30\n");
  ASSERT_EQ(read.size(), 2u);
  expect_pose(read[0].frame, {0.1, 0.2, 0.3}, about_z(30));
  EXPECT_NEAR(read[1].time, 0.5, 1e-15);
}

TEST_F(PoseList, AnglesAreThoseOfUrdf) {
  const auto read = waypoints("x,y,z,rx_deg,ry_deg,rz_deg\n1,2,3,10,20,30\n1.5,2,3,10,20,30\n");
  const Eigen::Matrix3d expected =
      about_z(30) * (Eigen::AngleAxisd(20 * kDegree, Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(10 * kDegree, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
  expect_pose(read[0].frame, {1, 2, 3}, expected);
}

TEST_F(PoseList, UnitsAndColumnsInTheProblem) {
  const auto read = waypoints(
      "# no header\n100,200,300,0,0,30\n150,200,300,0,0,30\n",
      "{file: poses.csv, columns: [x, y, z, rx, ry, rz], length_unit: mm, angle_unit: deg}");
  ASSERT_EQ(read.size(), 2u);
  expect_pose(read[0].frame, {0.1, 0.2, 0.3}, about_z(30));
  const auto other = waypoints("x,y,z,qx,qy,qz,qw\n100,0,0,0,0,0,1\n200,0,0,0,0,0,1\n",
                               "{file: poses.csv, length_unit: mm}");
  expect_pose(other[1].frame, {0.2, 0, 0}, Eigen::Matrix3d::Identity());
}

TEST_F(PoseList, MistakesAreSaid) {
  const std::string row = "1,2,3,1,0,0,0\n", header = "x,y,z,qw,qx,qy,qz\n";
  EXPECT_TRUE(says(error("x,y,qw,qx,qy,qz\n1,2,1,0,0,0\n"), "no column 'z'"));
  EXPECT_TRUE(says(error("x,y,z,qw,qx,qy\n1,2,3,1,0,0\n"), "no column 'qz'"));
  EXPECT_TRUE(says(error("x,y,z,rx,ry\n1,2,3,1,0\n"), "no column 'rz'"));
  EXPECT_TRUE(says(error("x,x_mm,y,z,qw,qx,qy,qz\n1,1,2,3,1,0,0,0\n"), "both x and x_mm"));
  EXPECT_TRUE(says(error("x,y,z,qw,qx,qy,qz,rx,ry,rz\n1,2,3,1,0,0,0,0,0,0\n"), "rx, ry, rz"));
  EXPECT_TRUE(says(error("x,y,z,x,qw,qx,qy,qz\n1,2,3,1,1,0,0,0\n"), "two columns 'x'"));
  EXPECT_TRUE(says(error(header + "1,2,nan,1,0,0,0\n"), "poses.csv:2"));
  EXPECT_TRUE(says(error(header + "1,2,inf,1,0,0,0\n"), "finite"));
  EXPECT_TRUE(says(error(header + "1,2,,1,0,0,0\n"), "finite"));
  EXPECT_TRUE(says(error(header + "1,2,3,1,1,0,0\n"), "norm"));
  EXPECT_TRUE(says(error(header + "1,2,3,0,0,0,0\n"), "norm"));
  EXPECT_TRUE(says(error(header + row + row), "repeated waypoint"));
  EXPECT_TRUE(says(error(header), "no poses"));
  EXPECT_TRUE(says(error(""), "empty"));
  EXPECT_TRUE(says(error(row, "{file: poses.csv, columns: [x, y, z]}"), "columns"));
  EXPECT_TRUE(says(error(row, "{file: poses.csv, columns: []}"), "no columns"));
  EXPECT_TRUE(says(error(row, "{file: poses.csv, length_unit: inch}"), "length_unit"));
  EXPECT_TRUE(says(error(row, "{columns: [x]}"), "'file' is missing"));
  EXPECT_TRUE(says(error(row, "{file: other.csv}"), "no such file"));
}

}  // namespace
}  // namespace wristwise
