#include <fmt/format.h>

#include "io/path_section.hpp"
#include "io/problem_sections.hpp"

namespace wristwise {

namespace {

const std::vector<std::string> kKinds = {"line", "arc", "poses", "joints", "program"};

LineSegment read_line(const ConfigReader& reader, const Pose& part) {
  reader.expect_keys({"from", "to"});
  LineSegment line{part * read_pose(reader.at("from"), true),
                   part * read_pose(reader.at("to"), true)};
  if ((line.to.translation() - line.from.translation()).norm() < 1e-9)
    reader.at("to").at("xyz").fail("repeated waypoint, `to` is at the place of `from`",
                                   "another place");
  return line;
}

ArcSegment read_arc(const ConfigReader& reader, const Pose& part) {
  reader.expect_keys({"from", "center", "axis", "angle"});
  const Eigen::Vector3d axis = reader.at("axis").vector(Quantity::number);
  if (axis.norm() < 1e-9) reader.at("axis").fail("the axis is zero", "a direction");
  return {part * read_pose(reader.at("from"), true),
          part * reader.at("center").vector(Quantity::length), part.linear() * axis,
          reader.at("angle").quantity(Quantity::angle)};
}

/// A value, or [lower, upper].
void read_joint_value(const ConfigReader& reader, Quantity quantity, double& lower, double& upper) {
  if (!reader.is_list()) {
    lower = upper = reader.quantity(quantity);
    return;
  }
  const auto bounds = reader.items(2, "a value or [lower, upper]");
  lower = bounds[0].quantity(quantity);
  upper = bounds[1].quantity(quantity);
  if (lower > upper) reader.fail("the lower bound is above the upper", "[lower, upper]");
}

JointListSegment read_joint_list(const ConfigReader& reader, const Robot& robot) {
  JointListSegment list;
  for (const ConfigReader& item : reader.items()) {
    const auto count = static_cast<std::size_t>(robot.joint_count());
    const auto values = item.items(count, fmt::format("{} joint values", count));
    JointBox posture(JointVector::Zero(robot.joint_count()));
    for (std::size_t j = 0; j < count; ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      read_joint_value(values[j], joint_quantity(robot, j), posture.lower[index],
                       posture.upper[index]);
    }
    list.postures.push_back(posture);
    list.where.push_back(item.where());
  }
  if (list.postures.empty()) reader.fail("no joint waypoints", "at least one");
  return list;
}

decltype(Segment::shape) read_shape(const std::string& kind, const ConfigReader& reader,
                                    const SegmentContext& context) {
  if (kind == "line") return read_line(reader, context.part);
  if (kind == "arc") return read_arc(reader, context.part);
  if (kind == "poses") return read_pose_list(reader, context.part);
  return read_joint_list(reader, context.robot);
}

}  // namespace

std::vector<Segment> read_segments(const ConfigReader& reader, const SegmentContext& context) {
  std::vector<std::string> keys = kKinds;
  keys.emplace_back("tolerance");
  reader.expect_keys(keys);
  std::vector<std::string> given;
  for (const std::string& kind : kKinds)
    if (reader.find(kind)) given.push_back(kind);
  if (given.size() != 1)
    reader.fail(given.empty() ? "no segment" : "both " + given[0] + " and " + given[1],
                "one of line, arc, poses, joints, program");

  const ConfigReader shape = reader.at(given[0]);
  SegmentContext own_context = context;
  if (const auto own = reader.find("tolerance")) {
    if (given[0] == "joints")
      own->fail("joint waypoints have no tolerance box", "a range [lower, upper] for a joint");
    own_context.tolerance = read_tolerance(*own, {});
  }
  if (given[0] == "program") return read_program_segments(shape.existing_file(), own_context);
  return {{read_shape(given[0], shape, context), own_context.tolerance, shape.where()}};
}

}  // namespace wristwise
