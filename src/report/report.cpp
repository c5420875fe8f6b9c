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
#include "verify/row_waypoints.hpp"

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

/// The motions of a report, each looked at over time.
class Motions {
 public:
  explicit Motions(const Problem& problem)
      : problem_(problem),
        clearance_(std::make_shared<const ClearanceModel>(problem.robot, problem.scene)) {}

  const ClearanceModel& clearance() const { return *clearance_; }
  Json json() { return std::move(json_); }

  Verification check(const Task& task, const JointPath& path) const {
    VerificationOptions options;
    options.clearance_epsilon = problem_.refine.clearance_epsilon;
    return verify(task, clearance_, path, options);
  }

  void add(const std::string& name, const PlanResult& result) {
    const Task task = task_as_run(result, problem_);
    if (result.trajectory.empty()) return add_path(name, task, result.path, result.verification);
    add_motion(name, task, CurveMotion(result.trajectory), json::knots(result.trajectory),
               result.verification);
  }

  void add_path(const std::string& name, const Task& task, const JointPath& path,
                const Verification& verification) {
    if (path.size() == 0) return;
    add_motion(name, task, PointMotion(path), json::knots(path), verification);
  }

 private:
  void add_motion(const std::string& name, const Task& given, const CheckedMotion& motion,
                  Json knots, const Verification& verification) {
    if (given.waypoints.empty()) return;
    const bool is_motion = motion.times().size() > 1;
    const Task task = is_motion ? row_waypoints(given, motion.times()).task : given;
    json_.push_back(
        {{"name", name},
         {"curve", motion.is_curve()},
         {"weld", {json::number(given.weld_start()), json::number(given.weld_end())}},
         {"knots", std::move(knots)},
         {"samples", json::samples(sample_motion(task, clearance_, motion, kSamples), *clearance_)},
         {"verification", json::verification(verification, problem_)}});
  }

  const Problem& problem_;
  std::shared_ptr<const ClearanceModel> clearance_;
  Json json_ = Json::array();
};

/// The waypoints that a diagnosis counts: of a smoothed path its rows.
Task counted_task(const PlanResult& result, const Problem& problem) {
  const Task task = task_as_run(result, problem);
  return result.before ? task.with_waypoints_at(result.before->path.times) : task;
}

/// The result, and behind it what it is to be compared with.
void add_motions(const ReportContents& contents, Motions& motions) {
  const PlanResult& result = contents.result;
  motions.add(result.mode == Mode::smooth ? "smoothed" : mode_name(result.mode), result);
  if (contents.graph_only != nullptr) {
    motions.add("graph-only", *contents.graph_only);
  } else if (result.before) {
    motions.add_path("as given", contents.problem.task, result.before->path,
                     result.before->verification);
  } else if (result.mode == Mode::two_stage && !result.trajectory.empty() &&
             !result.seeds.empty()) {
    const JointPath& seed = result.seeds.front().path;
    motions.add_path("graph-only", contents.problem.task, seed,
                     motions.check(contents.problem.task, seed));
  }
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
    Motions motions(problem);
    add_motions(contents, motions);
    data["clearance"] = problem.scene.scope == CollisionScope::off
                            ? Json(nullptr)
                            : json::number(problem.scene.clearance);
    data["between"] = {problem.task.between_position, problem.task.between_angle};
    data["robot"] = json::robot(*problem.robot);
    data["bodies"] = json::bodies(motions.clearance(), problem.scene.objects.size());
    data["seam"] = waypoints(counted_task(contents.result, problem));
    data["motions"] = motions.json();
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
