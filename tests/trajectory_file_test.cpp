#include "wristwise/trajectory_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <sstream>

#include "invalid_input.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::invalid_input;
using test::says;
using test::TemporaryFolder;

const std::vector<std::string> kJoints = {"a", "b"};

JointVector pair(double a, double b) {
  JointVector q(2);
  q << a, b;
  return q;
}

/// Finite doubles of every size, by their bits.
double random_double(std::mt19937_64& random) {
  while (true) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

std::size_t count_lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(TrajectoryFile, PathComesBackBitForBit) {
  const TemporaryFolder folder;
  std::mt19937_64 random(3);
  JointPath path;
  for (int i = 0; i < 500; ++i) {
    path.times.push_back(0.1 * i);
    path.positions.push_back(pair(random_double(random), random_double(random)));
  }
  write_path(folder.path() / "p.csv", kJoints, path);
  const TrajectoryFile file = read_trajectory(folder.path() / "p.csv", kJoints);
  EXPECT_FALSE(file.trajectory);
  ASSERT_EQ(file.path.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(file.path.times[i], path.times[i]);
    EXPECT_EQ(file.path.positions[i], path.positions[i]);
  }
}

TEST(TrajectoryFile, CurveComesBackBitForBit) {
  const TemporaryFolder folder;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] { return pair(uniform(random) / 3, uniform(random) * 1e-9); };
  const Trajectory curve({0, 0.1, 0.7}, {any(), any(), any()}, {any(), any(), any()},
                         {any(), any(), any()});
  write_trajectory(folder.path() / "t.csv", kJoints, curve);
  const std::string text = file_text(folder.path() / "t.csv");
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "time,a,b,a_velocity,b_velocity,a_acceleration,b_acceleration");
  const TrajectoryFile file = read_trajectory(folder.path() / "t.csv", kJoints);
  ASSERT_TRUE(file.trajectory);
  EXPECT_EQ(file.trajectory->times(), curve.times());
  EXPECT_EQ(file.trajectory->positions(), curve.positions());
  EXPECT_EQ(file.trajectory->velocities(), curve.velocities());
  EXPECT_EQ(file.trajectory->accelerations(), curve.accelerations());
}

TEST(TrajectoryFile, DenseFileHasEveryPeriodAndTheEnd) {
  const TemporaryFolder folder;
  const Trajectory curve({0, 0.1}, {pair(0, 0), pair(1, 2)}, {pair(0, 0), pair(0, 0)},
                         {pair(0, 0), pair(0, 0)});
  const auto file = folder.path() / "d.csv";
  write_dense(file, kJoints, curve, 0.004);
  EXPECT_EQ(count_lines(file_text(file)), 1u + 26u);  // 0, 4, ... 100 ms
  write_dense(file, kJoints, curve, 0.03);
  const TrajectoryFile read = read_trajectory(file, kJoints);
  EXPECT_EQ(read.path.times, (std::vector<double>{0, 0.03, 0.06, 0.09, 0.1}));
  // A rest-to-rest quintic: q = 10 u^3 - 15 u^4 + 6 u^5.
  const double u = 0.3;
  EXPECT_NEAR(read.path.positions[1][0], 10 * u * u * u - 15 * u * u * u * u + 6 * std::pow(u, 5),
              1e-14);
  invalid_input([&] { write_dense(file, kJoints, curve, 0); });
}

TEST(TrajectoryFile, ForgivesLayout) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "f.csv",
      "\xEF\xBB\xBF# a comment\r\n\r\n b , remark, time ,a\r\n2,hello,0, +1\r\n# more\r\n"
      "\r\n 4 ,,0.5,3e-1\r\n\r\n");
  const TrajectoryFile read = read_trajectory(file, kJoints);
  EXPECT_EQ(read.path.times, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(read.path.positions[0], pair(1, 2));
  EXPECT_EQ(read.path.positions[1], pair(0.3, 4));
}

TEST(TrajectoryFile, SaysWhereItIsWrong) {
  const TemporaryFolder folder;
  const std::vector<std::tuple<std::string, std::string, std::string>> cases = {
      {"", "bad.csv", "empty"},
      {"time,a\n0,1\n1,2\n", "bad.csv:1", "no column 'b'"},
      {"t,a,b\n0,1,1\n1,2,2\n", "bad.csv:1", "no column 'time'"},
      {"time,a,b,a\n0,1,1,1\n1,2,2,2\n", "bad.csv:1", "two columns 'a'"},
      {"time,a,b\n0,1,2\n", "bad.csv", "1 rows"},
      {"time,a,b\n0,1,2\n1,2\n", "bad.csv:3", "2 cells"},
      {"time,a,b\n0,1,2\n1,2,nan\n", "bad.csv:3", "'nan' in column 'b'"},
      {"time,a,b\n0,1,2\n1,inf,2\n", "bad.csv:3", "'inf' in column 'a'"},
      {"time,a,b\n0,1,2\n1,2,1e999\n", "bad.csv:3", "'1e999'"},
      {"time,a,b\n0,1,2\n1,2,2 deg\n", "bad.csv:3", "'2 deg'"},
      {"time,a,b\n0,1,2\n1,,2\n", "bad.csv:3", "'' in column 'a'"},
      {"time,a,b\n0,1,2\n\n0,1,2\n", "bad.csv:4", "time does not increase"},
  };
  for (const auto& [text, where, what] : cases) {
    const auto file = folder.write("bad.csv", text);
    const std::string message = invalid_input([&] { read_trajectory(file, kJoints); });
    EXPECT_TRUE(says(message, where) && says(message, what)) << text << message;
  }
  EXPECT_TRUE(says(invalid_input([&] { read_trajectory(folder.path() / "none.csv", kJoints); }),
                   "no such file"));
  EXPECT_TRUE(says(invalid_input([&] { read_trajectory(folder.path(), kJoints); }), "folder"));
}

TEST(TrajectoryFile, LeavesNothingBehindWhenWritingFails) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "taken.csv" / "inside");
  const JointPath path{{0, 1}, {pair(0, 0), pair(1, 1)}};
  EXPECT_THROW(write_path(folder.path() / "taken.csv", kJoints, path), std::runtime_error);
  EXPECT_THROW(write_path(folder.path() / "none" / "p.csv", kJoints, path), std::runtime_error);
  write_path(folder.path() / "p.csv", kJoints, path);
  std::size_t entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().extension(), ".tmp");
    ++entries;
  }
  EXPECT_EQ(entries, 2u);
}

}  // namespace
}  // namespace wristwise
