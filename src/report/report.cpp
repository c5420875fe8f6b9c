#include "report/report.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/json_verification.hpp"
#include "io/result_file.hpp"
#include "io/text_file.hpp"
#include "report/json_array.hpp"
#include "report/json_motion.hpp"
#include "report/json_robot.hpp"
#include "report/page_template.hpp"
#include "report/shown_motions.hpp"

namespace wristwise {

namespace {

using json::Json;

constexpr std::size_t kSamples = 800;  // of a motion, about
constexpr std::string_view kPlaceOfData = "\"wristwise data\"";

Json inputs(const std::vector<InputFile>& files) {
  Json json = Json::array();
  for (const InputFile& file : files)
    json.push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  return json;
}

Json waypoints(const Task& task) {
  Json time = Json::array(), point = Json::array(), torch = Json::array(), weld = Json::array();
  for (const Waypoint& waypoint : task.waypoints) {
    time.push_back(json::rounded(waypoint.time, json::kExact));
    const Eigen::Vector3d position = waypoint.frame.translation();
    const Eigen::Vector3d axis = waypoint.frame.linear().col(2);
    for (const double x : position) point.push_back(json::rounded(x, json::kShown));
    for (const double x : axis) torch.push_back(json::rounded(x, 4));
    weld.push_back(waypoint.welding ? 1 : 0);
  }
  return {{"time", std::move(time)},
          {"point", std::move(point)},
          {"torch", std::move(torch)},
          {"welding", std::move(weld)}};
}

/// What the check says of a motion; where it was not checked yet, now.
Verification verification_of(const ShownMotion& motion, const Problem& problem,
                             const std::shared_ptr<const ClearanceModel>& clearance) {
  if (motion.verification != nullptr) return *motion.verification;
  VerificationOptions options;
  options.clearance_epsilon = problem.refine.clearance_epsilon;
  return verify(problem.task, clearance, motion.path, options);
}

Json motion_json(const ShownMotion& motion, const Problem& problem,
                 const std::shared_ptr<const ClearanceModel>& clearance) {
  const auto checked = checked_motion(motion);
  return {
      {"name", motion.name},
      {"curve", checked->is_curve()},
      {"weld", {json::number(motion.weld_start), json::number(motion.weld_end)}},
      {"knots", checked->is_curve() ? json::knots(motion.trajectory) : json::knots(motion.path)},
      {"samples",
       json::samples(sample_motion(motion.task, clearance, *checked, kSamples), *clearance)},
      {"verification", json::verification(verification_of(motion, problem, clearance), problem)}};
}

/// The waypoints that a diagnosis counts: of a smoothed path its rows.
Task counted_task(const PlanResult& result, const Problem& problem) {
  const Task task = task_as_run(result, problem);
  return result.before ? task.with_waypoints_at(result.before->path.times) : task;
}

/// '<' stands in JSON inside texts only, where it may be written as its code.
std::string without_markup(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

}  // namespace

std::string report_data(const ReportContents& contents) {
  const Problem& problem = contents.problem;
  Json data = {{"name", problem.name},
               {"result", Json::parse(result_json(contents.result, problem))},
               {"inputs", inputs(contents.inputs)}};
  if (contents.graph_only != nullptr)
    data["graph_only"] = Json::parse(result_json(*contents.graph_only, problem));
  if (problem.robot) {
    const auto clearance = std::make_shared<const ClearanceModel>(problem.robot, problem.scene);
    Json motions = Json::array();
    for (const ShownMotion& motion : shown_motions(problem, contents.result, contents.graph_only))
      motions.push_back(motion_json(motion, problem, clearance));
    data["clearance"] = problem.scene.scope == CollisionScope::off
                            ? Json(nullptr)
                            : json::number(problem.scene.clearance);
    data["between"] = {problem.task.between_position, problem.task.between_angle};
    data["robot"] = json::robot(*problem.robot);
    data["bodies"] = json::bodies(*clearance, problem.scene.objects.size());
    data["seam"] = waypoints(counted_task(contents.result, problem));
    data["motions"] = std::move(motions);
  }
  return without_markup(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string report_html(const ReportContents& contents) {
  const std::string_view page = page_template();
  const std::size_t place = page.find(kPlaceOfData);
  if (place == std::string_view::npos) throw std::logic_error("the page has no place for its data");
  std::string html(page.substr(0, place));
  html += report_data(contents);
  return html.append(page.substr(place + kPlaceOfData.size()));
}

void write_report(const std::filesystem::path& folder, const ReportContents& contents) {
  write_text(folder / "report.html", report_html(contents));
}

}  // namespace wristwise
