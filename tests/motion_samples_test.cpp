#include "report/motion_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "gantry.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;

TEST(SampleTimes, KeepTheGivenOnesAndFillUpEvenly) {
  const std::vector<double> given = {0, 1, 4, 4.001, 10};
  const std::vector<double> samples = sample_times(given, 100);
  EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end()));
  EXPECT_EQ(std::adjacent_find(samples.begin(), samples.end()), samples.end());
  for (const double time : given)
    EXPECT_NE(std::find(samples.begin(), samples.end(), time), samples.end()) << time;
  for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_LT(samples[i] - samples[i - 1], 0.151);
  EXPECT_NEAR(static_cast<double>(samples.size()), 100, 4);
}

TEST(SampleTimes, OfVeryManyAreSomeWithBothEnds) {
  std::vector<double> given(100001);
  std::iota(given.begin(), given.end(), 0.0);
  const std::vector<double> samples = sample_times(given, 100);
  EXPECT_LE(samples.size(), 501U);
  EXPECT_EQ(samples.front(), given.front());
  EXPECT_EQ(samples.back(), given.back());
}

TEST(SampleTimes, OfOneOrNoneAreThat) {
  EXPECT_EQ(sample_times({}, 100).size(), 0U);
  EXPECT_EQ(sample_times({3}, 100), std::vector<double>{3});
}

TEST(ToleranceUse, IsOneAtTheEdgeHoweverTheBoxLies) {
  ToleranceBox box;
  box.lower << -0.002, 0, 0, -0.1, 0, -ToleranceBox::kFree;
  box.upper << 0.006, 0, 0.004, 0.1, 0, ToleranceBox::kFree;
  Vector6 widening;
  widening << 0.001, 0.001, 0.001, 0.01, 0.01, 0.01;
  Vector6 e;
  e << 0.006, 0.0005, 0, -0.1, -0.02, 3;
  const Vector6 at_edge = tolerance_use(box, e, widening);
  EXPECT_NEAR(at_edge[0], 1, 1e-12);
  EXPECT_NEAR(at_edge[1], 0.5, 1e-12);  // no width: of the widening
  EXPECT_NEAR(at_edge[2], 1, 1e-12);
  EXPECT_NEAR(at_edge[3], 1, 1e-12);
  EXPECT_NEAR(at_edge[4], 2, 1e-12);
  EXPECT_FALSE(std::isfinite(at_edge[5]));
  e << 0.0065, 0, 0.002, 0.22, 0, 0;
  const Vector6 beyond = tolerance_use(box, e, widening);
  EXPECT_EQ(beyond[0], 1);  // inside the widened box
  EXPECT_NEAR(beyond[2], 0, 1e-12);
  EXPECT_NEAR(beyond[3], 2, 1e-12);
}

TEST(SampleMotion, HasNoDeviationWhereNoPathIsPrescribed) {
  Task task = gantry::task({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, 4, 2, gantry::box(0.01, 0.1));
  std::vector<SeamPiece> pieces = task.seam.pieces();
  pieces[1].kind = SeamPiece::Kind::move;
  task.seam = Seam(pieces);
  const JointPath path = gantry::path_along(task);
  for (std::size_t i = 3; i < task.waypoints.size(); ++i)
    task.waypoints[i].joints = JointBox{path.positions[i], path.positions[i]};
  const auto robot = gantry::robot();
  const MotionSamples samples =
      sample_motion(task, gantry::clearance(robot), PointMotion(path), 50);
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    EXPECT_EQ(samples.deviation[i].has_value(), samples.times[i] < 2 + 1e-9) << samples.times[i];
    EXPECT_EQ(samples.use[i].has_value(), samples.deviation[i].has_value());
    EXPECT_NEAR(samples.seam[i].x(), samples.times[i] / 2, 1e-9);
    EXPECT_FALSE(samples.nearest[i].has_value());  // nothing counts
  }
}

}  // namespace
}  // namespace wristwise
