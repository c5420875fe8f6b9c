#include "picture/tolerance_picture.hpp"

#include <gtest/gtest.h>

#include "plotted_motion.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::gantry_problem;
using test::kDuration;
using test::PlotReader;
using test::Plotted;
using test::swing;

constexpr double kDegree = 0.017453292519943295;

PlanResult result_of(const Problem& problem) {
  PlanResult result;
  result.mode = Mode::graph_only;
  for (const Waypoint& waypoint : problem.task.waypoints) {
    result.path.times.push_back(waypoint.time);
    result.path.positions.push_back(swing(waypoint.time));
  }
  return result;
}

void set_box(Problem& problem, int k, double lower, double upper) {
  for (Waypoint& waypoint : problem.task.waypoints) {
    waypoint.tolerance.lower[k] = lower;
    waypoint.tolerance.upper[k] = upper;
  }
}

/// px between a line and a function of the waypoints' times.
template <typename Function>
double largest_error(const PlotReader& reader, const std::string& panel, const Problem& problem,
                     const Function& value) {
  const auto line = reader.line(panel, "graph-only", "rz" + panel.substr(panel.find(' ')));
  const double pixel = std::abs(reader.value_axis(panel).per_pixel);
  double largest = 0;
  for (const double t : test::times_of(problem.task)) {
    double least = 1e9;
    for (const double nearby : {t - 0.002, t, t + 0.002})
      least = std::min(
          least, std::abs(test::at(line, std::clamp(nearby, 0.0, kDuration), 1e-3) - value(t)));
    largest = std::max(largest, least / pixel);
  }
  return largest;
}

// The gantry's y and tilt are the deviations y and rx from its seam.
TEST(TolerancePicture, HasTheDeviationInMillimetresAndDegrees) {
  const Problem problem = gantry_problem();
  const PlotReader reader = Plotted(problem, result_of(problem)).read("tolerance.svg");
  const auto side = [](double t) { return 5 * std::sin(2 * t); };
  EXPECT_LT(largest_error(reader, "y deviation", problem, side), 0.3);
  const auto turn = [](double t) { return 0.3 * std::sin(2 * t) / kDegree; };
  EXPECT_LT(largest_error(reader, "rx deviation", problem, turn), 0.3);
  EXPECT_GT(largest_error(reader, "rx deviation", problem, side), 1);  // planted fault
}

TEST(TolerancePicture, HasTheShareFromMinusOneToOne) {
  Problem problem = gantry_problem();
  set_box(problem, 1, -0.004, 0.008);  // middle 2 mm, 6 mm to either side
  const PlotReader reader = Plotted(problem, result_of(problem)).read("tolerance.svg");
  const auto share = [](double t) {
    const double off = 5 * std::sin(2 * t) - 2;
    if (std::abs(off) <= 6) return off / 6;
    return std::copysign(std::max(1.0, std::abs(off) / 7), off);  // 1 mm more between waypoints
  };
  EXPECT_LT(largest_error(reader, "y share", problem, share), 0.3);
  EXPECT_GT(largest_error(reader, "y share", problem, [&](double t) { return -share(t); }), 1);
  EXPECT_GT(largest_error(reader, "y share", problem, [&](double t) { return std::abs(share(t)); }),
            1);
  const auto band = reader.filled("y share", plot::kAllowed);
  ASSERT_EQ(band.size(), 1U);
  const auto axis = reader.value_axis("y share");
  const double top = PlotReader::number(band[0], "y");
  EXPECT_NEAR(axis.value(top), 1, 1e-2);
  EXPECT_NEAR(axis.value(top + PlotReader::number(band[0], "height")), -1, 1e-2);
  ASSERT_EQ(reader.limits("y share").size(), 2U);
}

TEST(TolerancePicture, DrawsTheEdgesOfEachStretch) {
  Problem problem = gantry_problem();
  for (std::size_t i = 10; i < problem.task.waypoints.size(); ++i)
    problem.task.waypoints[i].tolerance.upper[1] = 0.02;
  const PlotReader reader = Plotted(problem, result_of(problem)).read("tolerance.svg");
  const auto upper = reader.line("y deviation", "upper edge", "rz deviation");
  const double pixel = std::abs(reader.value_axis("y deviation").per_pixel);
  EXPECT_NEAR(test::at(upper, 1), 10, pixel);
  EXPECT_NEAR(test::at(upper, 3), 20, pixel);
  EXPECT_NEAR(test::at(reader.line("y deviation", "lower edge", "rz deviation"), 3), -10, pixel);
}

TEST(TolerancePicture, MeasuresACoordinateWithoutWidthByWhatHoldsBetweenWaypoints) {
  Problem problem = gantry_problem();
  set_box(problem, 1, 0, 0);
  problem.task.between_position = 0.01;
  const PlotReader reader = Plotted(problem, result_of(problem)).read("tolerance.svg");
  EXPECT_LT(
      largest_error(reader, "y share", problem, [](double t) { return 0.5 * std::sin(2 * t); }),
      0.3);
  const auto texts = reader.texts(reader.panel("y deviation"));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "no width; edges: what holds between waypoints"),
            texts.end());
  EXPECT_NEAR(test::at(reader.line("y deviation", "upper edge", "rz deviation"), 2), 10, 0.2);
}

TEST(TolerancePicture, OfAFreeAngleHasTheDeviationOnly) {
  Problem problem = gantry_problem();
  set_box(problem, 3, -ToleranceBox::kFree, ToleranceBox::kFree);
  set_box(problem, 5, -0.1, 0.1);
  const Plotted plotted(problem, result_of(problem));
  EXPECT_EQ(plotted.text("tolerance.svg").find("inf"), std::string::npos);
  const PlotReader reader = plotted.read("tolerance.svg");
  EXPECT_LT(largest_error(reader, "rx deviation", problem,
                          [](double t) { return 0.3 * std::sin(2 * t) / kDegree; }),
            0.3);
  EXPECT_TRUE(reader.runs("rx share", "graph-only").empty());
  const auto texts = reader.texts(reader.panel("rx share"));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "free"), texts.end());
}

TEST(TolerancePicture, OfAFreeAngleHasNoJumpByAWholeTurn) {
  Problem problem = gantry_problem();
  set_box(problem, 3, -ToleranceBox::kFree, ToleranceBox::kFree);
  PlanResult result = result_of(problem);
  for (std::size_t i = 0; i < result.path.size(); ++i)
    result.path.positions[i][3] = 2 + 0.5 * result.path.times[i];  // past 180 deg
  const PlotReader reader = Plotted(problem, result).read("tolerance.svg");
  EXPECT_LT(largest_error(reader, "rx deviation", problem,
                          [](double t) { return (2 + 0.5 * t) / kDegree; }),
            0.3);
}

TEST(TolerancePicture, HasAGapWhereNoPathIsPrescribed) {
  Problem problem = gantry_problem();
  const PlanResult result = result_of(problem);
  for (std::size_t i = 0; i < problem.task.waypoints.size(); ++i)
    if (i > 5 && i < 12)
      problem.task.waypoints[i].joints =
          JointBox{result.path.positions[i], result.path.positions[i]};
  const PlotReader reader = Plotted(problem, result).read("tolerance.svg");
  EXPECT_GE(reader.runs("y deviation", "graph-only").size(), 2U);
  for (std::size_t i = 0; i < problem.task.waypoints.size(); ++i)
    problem.task.waypoints[i].joints = JointBox{result.path.positions[i], result.path.positions[i]};
  std::vector<SeamPiece> pieces = problem.task.seam.pieces();
  pieces[0].kind = SeamPiece::Kind::move;
  problem.task.seam = Seam(pieces);
  const PlotReader none = Plotted(problem, result).read("tolerance.svg");
  const auto texts = none.texts(none.panel("y share"));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "not prescribed"), texts.end());
}

TEST(TolerancePicture, OfOneWaypointIsADot) {
  Problem problem = gantry_problem();
  problem.task.waypoints.resize(1);
  PlanResult result;
  result.mode = Mode::graph_only;
  result.path = {{0}, {gantry::posture(0, 0.005, 1)}};
  const PlotReader reader = Plotted(problem, result).read("tolerance.svg");
  ASSERT_EQ(reader.runs("y share", "graph-only").size(), 1U);
  const auto dot = reader.line("y share", "graph-only", "rz share");
  ASSERT_EQ(dot.size(), 1U);
  EXPECT_NEAR(dot[0].value, 0.5, 1e-2);
}

}  // namespace
}  // namespace wristwise
