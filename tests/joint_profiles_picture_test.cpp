#include "picture/joint_profiles_picture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "io/result_file.hpp"
#include "plotted_motion.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::gantry_problem;
using test::kDuration;
using test::PlotReader;
using test::Plotted;
using test::swing;
using test::swinging_result;

const std::vector<std::string> kJoints = {"x", "y", "z", "tilt"};
const std::array<std::string, 4> kNames = {"position", "velocity", "acceleration", "jerk"};
constexpr double kLineError = 0.2;  // px, of a line that was thinned

std::string panel(std::size_t joint, int derivative) {
  return kJoints[joint] + " " + kNames[static_cast<std::size_t>(derivative)];
}

double factor(std::size_t joint) { return joint < 3 ? 1e3 : 1; }  // mm

/// The largest distance of a drawn line from the values of a function, px.
template <typename Function>
double largest_error(const PlotReader& reader, int derivative, const std::vector<double>& times,
                     const Function& value) {
  double largest = 0;
  for (std::size_t j = 0; j < kJoints.size(); ++j) {
    const std::string name = panel(j, derivative);
    const auto line = reader.line(name, "two-stage", panel(3, derivative));
    const double pixel = std::abs(reader.value_axis(name).per_pixel);
    for (const double t : times) {
      // where the line is steep its place in time counts too
      double least = std::numeric_limits<double>::infinity();
      for (const double nearby : {t - 0.001, t, t + 0.001})
        least = std::min(least, std::abs(test::at(line, std::clamp(nearby, 0.0, kDuration), 1e-3) -
                                         factor(j) * value(t)[static_cast<Eigen::Index>(j)]));
      largest = std::max(largest, least / pixel);
    }
  }
  return largest;
}

TEST(JointProfiles, AreTheRowsOfTrajectoryCsv) {
  const Problem problem = gantry_problem();
  const PlanResult result = swinging_result(problem);
  const Plotted plotted(problem, result);
  write_result(plotted.folder(), result, problem);
  const TrajectoryFile file = read_trajectory(plotted.folder() / "trajectory.csv", kJoints);
  const Trajectory& rows = *file.trajectory;
  const PlotReader reader = plotted.read("joints.svg");
  const std::array<const std::vector<JointVector>*, 3> columns = {
      &rows.positions(), &rows.velocities(), &rows.accelerations()};
  for (int k = 0; k < 3; ++k) {
    const auto& column = *columns[static_cast<std::size_t>(k)];
    const auto row = [&](double t) {
      const auto at = std::lower_bound(rows.times().begin(), rows.times().end(), t - 1e-9);
      return column[static_cast<std::size_t>(at - rows.times().begin())];
    };
    EXPECT_LT(largest_error(reader, k, rows.times(), row), kLineError) << kNames[k];
    // planted faults
    const auto exchanged = [&](double t) {
      JointVector q = row(t);
      std::swap(q[1], q[3]);
      return q;
    };
    EXPECT_GT(largest_error(reader, k, rows.times(), exchanged), 1) << kNames[k];
    const auto larger = [&](double t) { return JointVector(1.05 * row(t)); };
    EXPECT_GT(largest_error(reader, k, rows.times(), larger), 1) << kNames[k];
    const auto other_way = [&](double t) { return row(kDuration - t); };
    EXPECT_GT(largest_error(reader, k, rows.times(), other_way), 1) << kNames[k];
  }
}

TEST(JointProfiles, OfACurveAreDrawnBetweenTheRowsToo) {
  const Problem problem = gantry_problem(5);  // few rows: the quintic pieces are long
  const PlanResult result = swinging_result(problem);
  const PlotReader reader = Plotted(problem, result).read("joints.svg");
  std::vector<double> times;
  for (int i = 0; i <= 200; ++i) times.push_back(kDuration * i / 200);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(
        largest_error(reader, k, times, [&](double t) { return result.trajectory.evaluate(t, k); }),
        kLineError);
  // Jerk: of the accelerations, by central differences inside the pieces.
  std::vector<double> inside;
  for (const double t : times)
    if (std::abs(std::remainder(t, 0.8)) > 0.01) inside.push_back(t);
  const auto jerk = [&](double t) {
    constexpr double h = 1e-4;
    return JointVector(
        (result.trajectory.evaluate(t + h, 2) - result.trajectory.evaluate(t - h, 2)) / (2 * h));
  };
  EXPECT_LT(largest_error(reader, 3, inside, jerk), kLineError);
}

TEST(JointProfiles, OfPointsAreTheirDividedDifferencesInTheMiddle) {
  const Problem problem = gantry_problem();
  PlanResult result;
  result.mode = Mode::graph_only;
  for (const Waypoint& waypoint : problem.task.waypoints) {
    result.path.times.push_back(waypoint.time);
    result.path.positions.push_back(swing(waypoint.time));
  }
  const PlotReader reader = Plotted(problem, result).read("joints.svg");
  EXPECT_EQ(reader.lines("x velocity"), std::vector<std::string>{"graph-only"});
  const auto line = reader.line("tilt velocity", "graph-only", "tilt velocity");
  const double pixel = std::abs(reader.value_axis("tilt velocity").per_pixel);
  const JointPath& path = result.path;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double speed =
        (path.positions[i + 1][3] - path.positions[i][3]) / (path.times[i + 1] - path.times[i]);
    EXPECT_NEAR(test::at(line, 0.5 * (path.times[i] + path.times[i + 1]), 1e-3), speed, pixel);
  }
}

TEST(JointProfiles, DrawLimitsThatAreNearAndWriteAll) {
  Problem problem = gantry_problem();
  const PlanResult result = swinging_result(problem);
  const PlotReader reader = Plotted(problem, result).read("joints.svg");
  // x runs at 250 of 500 mm/s, forwards only.
  const auto near = reader.limits("x velocity");
  ASSERT_EQ(near.size(), 1U);
  EXPECT_NEAR(near[0], 500, 1);
  const auto texts = reader.texts(reader.panel("x velocity"));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "50% of limit 500"), texts.end());
  EXPECT_NE(std::find(texts.begin(), texts.end(), "x, mm/s"), texts.end());
  EXPECT_TRUE(reader.limits("tilt velocity").empty());  // 0.6 of 50 rad/s
  const auto far = reader.texts(reader.panel("tilt velocity"));
  EXPECT_NE(std::find(far.begin(), far.end(), "1.2% of limit 50"), far.end());
  EXPECT_NE(std::find(far.begin(), far.end(), "tilt, rad/s"), far.end());
  EXPECT_TRUE(reader.limits("y velocity").empty());
  const auto none = reader.texts(reader.panel("y velocity"));
  EXPECT_NE(std::find(none.begin(), none.end(), "no limit"), none.end());
  const auto range = reader.texts(reader.panel("x position"));
  EXPECT_NE(std::find(range.begin(), range.end(), "limits -2000 to 2000"), range.end());
}

TEST(JointProfiles, ShowALimitThatIsExceeded) {
  Problem problem = gantry_problem();
  Robot::Parts parts = problem.robot->parts();
  parts.joints[0].max_velocity = 0.2;
  problem.robot = gantry::robot(parts);
  const PlotReader reader = Plotted(problem, swinging_result(problem)).read("joints.svg");
  ASSERT_EQ(reader.limits("x velocity").size(), 1U);
  const auto texts = reader.texts(reader.panel("x velocity"));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "125% of limit 200"), texts.end());
}

TEST(JointProfiles, PutBehindWhatTheResultIsComparedWith) {
  const Problem problem = gantry_problem();
  PlanResult result = swinging_result(problem);
  using Names = std::vector<std::string>;
  EXPECT_EQ(Plotted(problem, result).read("joints.svg").lines("x jerk"),
            (Names{"graph-only", "two-stage"}));
  PlanResult graph;
  graph.mode = Mode::graph_only;
  graph.path = gantry::path_along(problem.task);
  result.seeds.clear();
  EXPECT_EQ(Plotted(problem, result).read("joints.svg").lines("x jerk"), Names{"two-stage"});
  EXPECT_EQ(Plotted(problem, result, &graph).read("joints.svg").lines("x jerk"),
            (Names{"graph-only", "two-stage"}));
  result.mode = Mode::smooth;
  result.before = {gantry::path_along(problem.task), {}};
  EXPECT_EQ(Plotted(problem, result).read("joints.svg").lines("x jerk"),
            (Names{"as given", "smoothed"}));
}

TEST(JointProfiles, ShadeRunInAndRunOut) {
  Problem problem = gantry_problem();
  for (std::size_t i : {0, 1, 2, 20}) problem.task.waypoints[i].welding = false;
  const PlotReader reader = Plotted(problem, swinging_result(problem)).read("joints.svg");
  const auto shaded = reader.filled("tilt velocity", plot::kShade);
  ASSERT_EQ(shaded.size(), 2U);
  const auto time = reader.time_axis("tilt velocity");
  const auto end = [&](std::size_t i) {
    return time.value(PlotReader::number(shaded[i], "x") + PlotReader::number(shaded[i], "width"));
  };
  EXPECT_NEAR(time.value(PlotReader::number(shaded[0], "x")), 0, 1e-3);
  EXPECT_NEAR(end(0), 0.6, 1e-2);  // waypoint 3 is the first that welds
  EXPECT_NEAR(time.value(PlotReader::number(shaded[1], "x")), 3.8, 1e-2);
  EXPECT_NEAR(end(1), 4, 1e-2);
  EXPECT_TRUE(Plotted(gantry_problem(), swinging_result(gantry_problem()))
                  .read("joints.svg")
                  .filled("x velocity", plot::kShade)
                  .empty());
}

/// A chain of slides and turns in turn.
Problem problem_with_joints(int count) {
  Problem problem = gantry_problem();
  Robot::Parts parts = gantry::parts();
  const Joint slide = parts.joints[0], turn = parts.joints[3];
  parts.joints.clear();
  for (int j = 0; j < count; ++j) {
    parts.joints.push_back(j % 2 == 0 ? turn : slide);
    parts.joints.back().name = "a_joint_with_quite_a_long_name_" + std::to_string(j + 1);
    parts.joints.back().max_velocity = 2;
  }
  parts.links[0].joint = 0;
  problem.robot = gantry::robot(parts);
  return problem;
}

TEST(JointProfiles, HaveALineOfPanelsForEachOfOneToSixteenJoints) {
  for (const int count : {1, 7, 8, 16}) {
    const Problem problem = problem_with_joints(count);
    PlanResult result;
    for (const double t : test::times_of(problem.task)) {
      result.path.times.push_back(t);
      result.path.positions.push_back(JointVector::LinSpaced(count, 0, 1) * t);
    }
    const Plotted plotted(problem, result);
    const PlotReader reader = plotted.read("joints.svg");
    const double width = PlotReader::number(reader.root(), "width");
    const double height = PlotReader::number(reader.root(), "height");
    double last_bottom = 0;
    for (const Joint& joint : problem.robot->joints()) {
      for (const std::string& name : kNames) {
        const std::string panel_name = joint.name + " " + name;
        ASSERT_NE(reader.panel(panel_name), nullptr) << panel_name;
        EXPECT_LE(reader.frame(panel_name, "x") + reader.frame(panel_name, "width"), width);
        EXPECT_LE(reader.frame(panel_name, "y") + reader.frame(panel_name, "height"), height - 20);
        EXPECT_GT(reader.frame(panel_name, "y"), last_bottom);
      }
      last_bottom =
          reader.frame(joint.name + " jerk", "y") + reader.frame(joint.name + " jerk", "height");
    }
  }
}

TEST(JointProfiles, OfOneWaypointAreADotAndSayThatDerivativesNeedMore) {
  Problem problem = gantry_problem();
  problem.task.waypoints.resize(1);
  PlanResult result;
  result.mode = Mode::graph_only;
  result.path = {{0}, {swing(0)}};
  const PlotReader reader = Plotted(problem, result).read("joints.svg");
  ASSERT_EQ(reader.runs("z position", "graph-only").size(), 1U);
  const auto dot = reader.line("z position", "graph-only", "tilt position");
  ASSERT_EQ(dot.size(), 1U);
  EXPECT_NEAR(dot[0].value, 1000, 0.1);
  EXPECT_NEAR(dot[0].time, 0, 1e-6);
  const auto texts = reader.texts(reader.panel("z velocity"));
  EXPECT_NE(std::find(texts.begin(), texts.end(), "too few points"), texts.end());
}

TEST(JointProfiles, OfAPartOfTheWayEndWhereItEnds) {
  const Problem problem = gantry_problem();
  PlanResult result;
  result.status = Status::infeasible;
  result.mode = Mode::graph_only;
  result.path = gantry::path_along(problem.task);
  result.path.times.resize(8);
  result.path.positions.resize(8);
  const PlotReader reader = Plotted(problem, result).read("joints.svg");
  const auto line = reader.line("x position", "graph-only", "tilt position");
  EXPECT_NEAR(line.back().time, 1.4, 1e-2);
  const auto time = reader.time_axis("tilt position");
  EXPECT_NEAR(
      time.value(reader.frame("tilt position", "x") + reader.frame("tilt position", "width")),
      kDuration, 1e-2);
  EXPECT_EQ(reader.texts(reader.root())[0], "gantry: infeasible, a part of the way only");
}

TEST(JointProfiles, BreakTheLineWhereAValueIsMissing) {
  const Problem problem = gantry_problem();
  PlanResult result;
  result.mode = Mode::graph_only;
  result.path = gantry::path_along(problem.task);
  result.path.positions[10][0] = std::nan("");
  result.path.positions[15][0] = std::numeric_limits<double>::infinity();
  const Plotted plotted(problem, result);
  EXPECT_EQ(plotted.text("joints.svg").find("nan"), std::string::npos);
  EXPECT_EQ(plotted.text("joints.svg").find("inf"), std::string::npos);
  const PlotReader reader = plotted.read("joints.svg");
  EXPECT_EQ(reader.runs("x position", "graph-only").size(), 3U);
  EXPECT_EQ(reader.runs("y position", "graph-only").size(), 1U);
}

TEST(JointProfiles, OfManyRowsAreSmallAndKeepTheirPeaks) {
  Problem problem = gantry_problem();
  PlanResult result;
  result.mode = Mode::graph_only;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 1e-3);
  constexpr int kRows = 100000;
  for (int i = 0; i < kRows; ++i) {
    result.path.times.push_back(kDuration * i / (kRows - 1));
    JointVector q = swing(result.path.times.back());
    for (Eigen::Index j = 0; j < 4; ++j) q[j] += noise(random);
    result.path.positions.push_back(q);
  }
  result.path.positions[61234][3] = 2.5;  // one row of many
  PlanResult behind = result;
  const Plotted plotted(problem, result, &behind);
  for (const std::string& name : plotted.names)
    EXPECT_LT(plotted.text(name).size(), 500000U) << name;
  const PlotReader reader = plotted.read("joints.svg");
  const auto line = reader.line("tilt position", "graph-only", "tilt position");
  const auto peak = std::max_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  EXPECT_NEAR(peak->value, 2.5, 0.1 * std::abs(reader.value_axis("tilt position").per_pixel));
  EXPECT_NEAR(peak->time, result.path.times[61234], 0.02);
}

TEST(JointProfiles, OfACurveWithManyRowsAreSmallAndRight) {
  const Problem problem = gantry_problem();
  std::vector<double> times;
  for (int i = 0; i < 100000; ++i) times.push_back(kDuration * i / 99999);
  PlanResult result;
  result.trajectory = test::swinging(times);
  result.path = result.trajectory.waypoints();
  const Plotted plotted(problem, result);
  for (const std::string& name : plotted.names)
    EXPECT_LT(plotted.text(name).size(), 100000U) << name;
  const std::vector<double> some = {0, 0.3, 1.1, 2.2, 3.7, 4};
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(
        largest_error(plotted.read("joints.svg"), k, some, [&](double t) { return swing(t, k); }),
        kLineError);
}

}  // namespace
}  // namespace wristwise
