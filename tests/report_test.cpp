#include "report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gantry.hpp"
#include "report/json_array.hpp"
#include "report/page_template.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using json::Json;

constexpr double kDuration = 4;  // s
constexpr double kBall = 0.05;   // m
const std::string kBadName = "</script><b>\"&";

/// A weld of 1 m along x at z = 1 m, over a floor whose top is at z = 0.9 m.
Problem problem_over_a_floor() {
  Problem problem;
  problem.name = "gantry";
  Robot::Parts parts = gantry::parts(kBall);
  parts.joints[0].name = kBadName;
  parts.joints[1].max_velocity = 0.5;
  problem.robot = gantry::robot(parts);
  problem.scene.find_permanent_contacts = false;
  problem.scene.clearance = 0.02;
  problem.scene.objects = {gantry::obstacle(Box{{10, 10, 0.2}}, 0, 0, 0.8)};
  problem.scene.objects[0].name = kBadName + "floor";
  problem.task = gantry::task({{0, 0, 1}, {1, 0, 1}}, kDuration, 8, gantry::box(0.01, 0.1));
  problem.task.between_position = 0.001;
  return problem;
}

/// Along the weld, `rise` above it at its end.
Trajectory rising(const Task& task, double rise) {
  std::vector<double> times;
  std::vector<JointVector> positions, velocities, accelerations;
  for (const Waypoint& waypoint : task.waypoints) {
    const double t = waypoint.time;
    times.push_back(t);
    positions.push_back(gantry::posture(t / kDuration, 0, 1 + rise * t / kDuration));
    velocities.push_back(gantry::posture(1 / kDuration, 0, rise / kDuration));
    accelerations.push_back(gantry::posture(0, 0, 0));
  }
  return {times, positions, velocities, accelerations};
}

PlanResult solved(const Problem& problem, double rise) {
  PlanResult result;
  result.status = Status::solved;
  result.trajectory = rising(problem.task, rise);
  result.path = result.trajectory.waypoints();
  result.seeds.push_back({gantry::path_along(problem.task)});
  return result;
}

Json data_of(const Problem& problem, const PlanResult& result) {
  return Json::parse(report_data({problem, result, nullptr, {{"seam.csv", 3, "abc"}}}));
}

TEST(Report, HoldsTheRowsOfTheTrajectory) {
  const Problem problem = problem_over_a_floor();
  const PlanResult result = solved(problem, 0.005);
  const Json knots = data_of(problem, result)["motions"][0]["knots"];
  const Trajectory& curve = result.trajectory;
  ASSERT_EQ(knots["time"].size(), curve.times().size());
  for (std::size_t i = 0; i < curve.times().size(); ++i) {
    EXPECT_NEAR(knots["time"][i].get<double>(), curve.times()[i], 1e-9);
    for (std::size_t j = 0; j < 4; ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      EXPECT_NEAR(knots["position"][j][i].get<double>(), curve.positions()[i][index], 1e-9);
      EXPECT_NEAR(knots["velocity"][j][i].get<double>(), curve.velocities()[i][index], 1e-9);
      EXPECT_NEAR(knots["acceleration"][j][i].get<double>(), curve.accelerations()[i][index], 1e-9);
    }
  }
}

// The ball's lowest point is 5 cm below the TCP, the floor's top at 0.9 m.
TEST(Report, ClearanceAndToleranceOverTimeAreThoseOfClosedForm) {
  const Problem problem = problem_over_a_floor();
  const double rise = 0.02;
  const Json motion = data_of(problem, solved(problem, rise))["motions"][0];
  const Json& samples = motion["samples"];
  ASSERT_GT(samples["time"].size(), 400U);
  bool beyond = false;
  for (std::size_t i = 0; i < samples["time"].size(); ++i) {
    const double up = rise * samples["time"][i].get<double>() / kDuration;
    EXPECT_NEAR(samples["clearance"]["distance"][i].get<double>(), 0.1 - kBall + up, 2e-6);
    EXPECT_NEAR(samples["deviation"][2][i].get<double>(), up, 1e-6);
    const double use = samples["use"][2][i];
    EXPECT_NEAR(use, up <= 0.01 ? up / 0.01 : std::max(1.0, up / 0.011), 2e-3);
    beyond = beyond || use > 1;
  }
  EXPECT_TRUE(beyond);
  EXPECT_EQ(samples["clearance"]["pairs"],
            Json::array({Json::array({"ball", kBadName + "floor"})}));
  EXPECT_EQ(samples["seam"][2], 1.0);
}

TEST(Report, PutsTheSeedBehindTheResultAndChecksIt) {
  const Problem problem = problem_over_a_floor();
  const Json motions = data_of(problem, solved(problem, 0.005))["motions"];
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[0]["name"], "two-stage");
  EXPECT_EQ(motions[1]["name"], "graph-only");
  EXPECT_FALSE(motions[1]["curve"]);
  EXPECT_TRUE(motions[1]["verification"]["passed"]);
  EXPECT_FALSE(motions[1]["knots"].contains("velocity"));
}

TEST(Report, PutsTheGivenPathBehindTheSmoothedOne) {
  const Problem problem = problem_over_a_floor();
  PlanResult result = solved(problem, 0.005);
  result.mode = Mode::smooth;
  result.before = {gantry::path_along(problem.task), {}};
  const Json motions = data_of(problem, result)["motions"];
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[0]["name"], "smoothed");
  EXPECT_EQ(motions[1]["name"], "as given");
}

TEST(Report, InfiniteLimitsAreNull) {
  const Problem problem = problem_over_a_floor();
  const Json joints = data_of(problem, solved(problem, 0))["robot"]["joints"];
  EXPECT_EQ(joints[0]["limits"], Json({nullptr, nullptr, nullptr}));
  EXPECT_EQ(joints[1]["limits"], Json({0.5, nullptr, nullptr}));
  EXPECT_EQ(joints[1]["upper"], gantry::kReach);
}

TEST(Report, SaysWhichLinkStandsStill) {
  const auto standing = [](const std::string& base_link) {
    Problem problem = problem_over_a_floor();
    Robot::Parts parts = gantry::parts(kBall);
    parts.base_link = base_link;
    parts.links[0].pose.translation().x() = 0.25;
    problem.robot = gantry::robot(parts);
    return data_of(problem, {})["robot"]["standing"];
  };
  EXPECT_EQ(standing("floor"),
            Json({{"joint", -1}, {"pose", {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}}}));
  EXPECT_EQ(standing("ball"), Json({{"joint", 3}, {"pose", {0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}}}));
}

TEST(Report, NamesCannotEndTheScript) {
  const Problem problem = problem_over_a_floor();
  const PlanResult result = solved(problem, 0);
  const std::string text = report_data({problem, result, nullptr, {{kBadName, 1, "0"}}});
  EXPECT_EQ(text.find('<'), std::string::npos);
  const Json data = Json::parse(text);
  EXPECT_EQ(data["robot"]["joints"][0]["name"], kBadName);
  EXPECT_EQ(data["bodies"].back()["name"], kBadName + "floor");
  EXPECT_EQ(data["inputs"][0]["name"], kBadName);
}

TEST(Report, TextsThatAreNoUtf8AreStillJson) {
  Problem problem = problem_over_a_floor();
  problem.name = "caf\xe9";
  EXPECT_NO_THROW(Json::parse(report_data({problem, solved(problem, 0), nullptr, {}})));
}

TEST(Report, WithoutAMotionShowsRobotSeamAndDiagnosis) {
  const Problem problem = problem_over_a_floor();
  PlanResult result;
  result.status = Status::infeasible;
  result.diagnosis.push_back({std::size_t{3}, "out_of_reach", "too far", "move the part"});
  const Json data = data_of(problem, result);
  EXPECT_TRUE(data["motions"].empty());
  EXPECT_EQ(data["result"]["diagnosis"][0]["waypoint"], 3);
  EXPECT_EQ(data["seam"]["time"].size(), problem.task.waypoints.size());
  EXPECT_EQ(data["bodies"].size(), 2U);
}

TEST(Report, APathOfOnePostureIsShown) {
  const Problem problem = problem_over_a_floor();
  PlanResult result;
  result.path = {{0.0}, {gantry::posture(0, 0, 1)}};
  const Json motions = data_of(problem, result)["motions"];
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_EQ(motions[0]["samples"]["time"].size(), 1U);
}

TEST(Report, WithoutAProblemHasTheDiagnosis) {
  PlanResult result;
  result.diagnosis.push_back({std::nullopt, "internal_error", "what", "report it"});
  const Json data = data_of(Problem(), result);
  EXPECT_FALSE(data.contains("motions"));
  EXPECT_EQ(data["result"]["diagnosis"][0]["reason"], "internal_error");
}

TEST(Report, IsThePageWithItsDataAndNothingFromElsewhere) {
  const test::TemporaryFolder folder;
  const Problem problem = problem_over_a_floor();
  write_report(folder.path(), {problem, solved(problem, 0), nullptr, {}});
  const std::string html = test::file_text(folder.path() / "report.html");
  const std::string page(page_template()), place = "\"wristwise data\"";
  const std::size_t before = page.find(place), after = page.size() - before - place.size();
  ASSERT_NE(before, std::string::npos);
  EXPECT_EQ(html.substr(0, before), page.substr(0, before));
  EXPECT_EQ(html.substr(html.size() - after), page.substr(before + place.size()));
  EXPECT_EQ(Json::parse(html.substr(before, html.size() - after - before))["name"], "gantry");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* from_elsewhere : {"src=\"", "@import", "url(http", "url(//"})
    EXPECT_EQ(page.find(from_elsewhere), std::string::npos) << from_elsewhere;
}

TEST(JsonArray, RoundsAndKeepsNothingThatIsNotFinite) {
  EXPECT_EQ(json::rounded(0.123456789, 6).dump(), "0.123457");
  EXPECT_EQ(json::rounded(-1e-12, 6).dump(), "0.0");
  EXPECT_EQ(json::rounded(1e300, 9).get<double>(), 1e300);
  EXPECT_TRUE(json::rounded(std::nan(""), 6).is_null());
  EXPECT_TRUE(json::rounded(-std::numeric_limits<double>::infinity(), 6).is_null());
}

TEST(JsonArray, PoseIsPositionAndQuaternion) {
  Pose pose(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()));
  pose.translation() << 1, 2, 3;
  const Json json = json::pose(pose);
  ASSERT_EQ(json.size(), 7U);
  EXPECT_EQ(json[1], 2.0);
  EXPECT_NEAR(json[4].get<double>(), std::sin(0.25), 1e-12);
  EXPECT_NEAR(json[6].get<double>(), std::cos(0.25), 1e-12);
}

}  // namespace
}  // namespace wristwise
