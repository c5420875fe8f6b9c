// A sample of the random test bed: every seam is solved, and verified once more through its file at
// 50 samples an interval, or it is refused with a diagnosis. tests/benchmarks/random_seams_report
// runs the whole bed.

#include "random_seams.hpp"

#include <gtest/gtest.h>

#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

namespace bed = test::bed;

constexpr int kSeamsInAGroup = 8;

/// Ends of ramps and of roundings have rows of their own.
bool is_plain(const bed::RandomSeam& seam) { return seam.kind != bed::Kind::corner; }

class RandomSeams : public testing::TestWithParam<int> {
 protected:
  Problem problem(const bed::RandomSeam& seam) const {
    return load_problem(folder_.write("seam.yaml", seam.problem));
  }

  /// What a reader of trajectory.csv has.
  Trajectory written_and_read(const Problem& problem, const Trajectory& trajectory) const {
    const std::vector<std::string> names = problem.robot->joint_names();
    const auto file = folder_.path() / "trajectory.csv";
    write_trajectory(file, names, trajectory);
    return read_trajectory(file, names).trajectory.value();
  }

  test::TemporaryFolder folder_;
};

void expect_a_row_for_each_waypoint(const Trajectory& rows, const Task& task) {
  ASSERT_EQ(rows.times().size(), task.waypoints.size());
  for (std::size_t i = 0; i < rows.times().size(); ++i) {
    EXPECT_EQ(rows.times()[i], task.waypoints[i].time);
  }
}

TEST_P(RandomSeams, AreSolvedAndVerifiedOrDiagnosed) {
  PlanOptions dense;
  dense.verification.samples_per_interval = 50;
  int solved = 0, plain = 0;
  for (int index = GetParam(); index < GetParam() + kSeamsInAGroup; ++index) {
    SCOPED_TRACE("random seam " + std::to_string(index));
    const bed::RandomSeam seam = bed::random_seam(index);
    const Problem of = problem(seam);
    const PlanResult result = plan(of);
    if (result.status == Status::solved) {
      ++solved;
      const Trajectory read = written_and_read(of, result.trajectory);
      const Verification verification = check(of, read, dense);
      EXPECT_TRUE(verification.passed)
          << (verification.failures.empty() ? "" : verification.failures.front());
      EXPECT_GE(read.positions().size(), of.task.waypoints.size());
      if (is_plain(seam)) {
        ++plain;
        expect_a_row_for_each_waypoint(read, of.task);
      }
    } else {
      ASSERT_FALSE(result.diagnosis.empty());
      EXPECT_FALSE(result.diagnosis.front().reason.empty());
      EXPECT_FALSE(result.diagnosis.front().detail.empty());
    }
  }
  EXPECT_GE(solved, kSeamsInAGroup / 2);
  EXPECT_GE(plain, 2);
}

INSTANTIATE_TEST_SUITE_P(Groups, RandomSeams, testing::Values(0, 8, 16));

TEST_F(RandomSeams, AreTheSameEveryTime) {
  EXPECT_EQ(bed::random_seam(5).problem, bed::random_seam(5).problem);
  EXPECT_NE(bed::random_seam(5).problem, bed::random_seam(6).problem);
}

TEST_F(RandomSeams, PassTheirPostureHalfWay) {
  int checked = 0;
  for (int index = 0; index < 30; ++index) {
    SCOPED_TRACE("random seam " + std::to_string(index));
    const bed::RandomSeam seam = bed::random_seam(index);
    const Problem of = problem(seam);
    const Seam& path = of.task.seam;
    if (!seam.corners.empty()) continue;  // rounded off, or run at another speed
    EXPECT_NEAR(path.length(), seam.length, 1e-9);
    EXPECT_NEAR(path.end_time() - path.start_time(), seam.length / seam.speed, 1e-3);
    const Pose middle = path.frame_at(0.5 * (path.start_time() + path.end_time()));
    EXPECT_TRUE(middle.isApprox(tcp_pose(*of.robot, seam.posture), 1e-9));
    ++checked;
  }
  EXPECT_GT(checked, 15);
}

TEST_F(RandomSeams, PassTheWristSingularityInEveryThird) {
  for (int index = 0; index < 30; ++index) {
    const bed::RandomSeam seam = bed::random_seam(index);
    EXPECT_EQ(seam.singular, index % 3 == 0);
    EXPECT_EQ(std::abs(seam.posture[4]) <= 2 * bed::kDegree, seam.singular);
  }
}

}  // namespace
}  // namespace wristwise
