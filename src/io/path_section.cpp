#include "io/path_section.hpp"

#include "io/problem_sections.hpp"

namespace wristwise {

namespace {

void read_between(const ConfigReader& reader, Task& task) {
  const auto parts = reader.items(2, "[position in m, angle in rad]");
  task.between_position = parts[0].not_negative(Quantity::length);
  task.between_angle = parts[1].not_negative(Quantity::angle);
}

SeamDescription read_description(const ConfigReader& reader, const ToleranceBox& tolerance,
                                 const Robot& robot) {
  SeamDescription description;
  description.where = reader.where();
  if (const auto speed = reader.find("speed")) description.speed = speed->positive(Quantity::speed);
  if (const auto spacing = reader.find("spacing"))
    description.spacing = spacing->positive(Quantity::length);
  if (const auto waypoints = reader.find("waypoints"))
    description.waypoints = waypoints->whole_number(2);
  if (const auto corners = reader.find("corners")) description.corners = read_corners(*corners);
  if (const auto run_in = reader.find("run_in")) description.run_in = read_run(*run_in, "approach");
  if (const auto run_out = reader.find("run_out"))
    description.run_out = read_run(*run_out, "retract");
  const auto frame = reader.find("frame");
  const Pose part = frame ? read_pose(*frame) : Pose::Identity();
  const ConfigReader segments = reader.at("segments");
  for (const ConfigReader& item : segments.items())
    description.segments.push_back(read_segment(item, part, tolerance, robot));
  if (description.segments.empty()) segments.fail("no segments", "at least one");
  return description;
}

}  // namespace

Task read_task(const ConfigReader& reader, const Robot& robot) {
  reader.expect_keys({"link", "frame", "speed", "speed_policy", "spacing", "waypoints", "segments",
                      "corners", "run_in", "run_out", "tolerance"});
  const auto tolerance_key = reader.find("tolerance");
  const ToleranceBox tolerance =
      tolerance_key ? read_tolerance(*tolerance_key, {"between"}) : ToleranceBox();
  Task task = build_task(robot, read_description(reader, tolerance, robot));
  if (const auto policy = reader.find("speed_policy"))
    task.speed_policy =
        policy->choice({"hold", "slow"}) == "slow" ? SpeedPolicy::slow : SpeedPolicy::hold;
  if (!tolerance_key) return task;
  if (const auto between = tolerance_key->find("between")) read_between(*between, task);
  return task;
}

}  // namespace wristwise
