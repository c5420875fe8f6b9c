#include "io/path_section.hpp"

#include "io/problem_sections.hpp"
#include "task/moved_seam.hpp"

namespace wristwise {

namespace {

void read_between(const ConfigReader& reader, PathSection& path) {
  const auto parts = reader.items(2, "[position in m, angle in rad]");
  path.between_position = parts[0].not_negative(Quantity::length);
  path.between_angle = parts[1].not_negative(Quantity::angle);
}

SeamDescription read_description(const ConfigReader& reader, const Pose& part,
                                 const ToleranceBox& tolerance, const Robot& robot,
                                 const ExportOptions& exports) {
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
  const ConfigReader segments = reader.at("segments");
  const SegmentContext context{robot, part, tolerance, exports, description.speed.has_value()};
  for (const ConfigReader& item : segments.items())
    for (Segment& segment : read_segments(item, context))
      description.segments.push_back(std::move(segment));
  if (description.segments.empty()) segments.fail("no segments", "at least one");
  return description;
}

}  // namespace

PathSection read_path(const ConfigReader& reader, const Robot& robot,
                      const ExportOptions& exports) {
  reader.expect_keys({"link", "frame", "speed", "speed_policy", "spacing", "waypoints", "segments",
                      "corners", "run_in", "run_out", "tolerance"});
  PathSection path;
  if (const auto frame = reader.find("frame")) path.part = read_pose(*frame);
  const auto tolerance_key = reader.find("tolerance");
  const ToleranceBox tolerance =
      tolerance_key ? read_tolerance(*tolerance_key, {"between"}) : ToleranceBox();
  path.seam = read_description(reader, path.part, tolerance, robot, exports);
  if (const auto policy = reader.find("speed_policy"))
    path.speed_policy =
        policy->choice({"hold", "slow"}) == "slow" ? SpeedPolicy::slow : SpeedPolicy::hold;
  if (!tolerance_key) return path;
  if (const auto between = tolerance_key->find("between")) read_between(*between, path);
  return path;
}

Task task_after(const Pose& motion, const PathSection& path, const Robot& robot) {
  Task task = build_task(robot, moved(path.seam, motion));
  task.speed_policy = path.speed_policy;
  task.between_position = path.between_position;
  task.between_angle = path.between_angle;
  return task;
}

}  // namespace wristwise
