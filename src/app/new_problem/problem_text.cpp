#include "app/new_problem/problem_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>

extern "C" {
extern const char wristwise_problem_template[];      // template_bytes.S
extern const char wristwise_problem_template_end[];  // likewise
}

namespace wristwise::app {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kPlateThickness = 0.01, kPlateMargin = 0.05;  // m
constexpr int kIntervals = 20;

std::string_view problem_template() {
  return {wristwise_problem_template,
          static_cast<std::size_t>(wristwise_problem_template_end - wristwise_problem_template)};
}

std::string number(double value) {
  const std::string text = fmt::format("{:.9g}", std::abs(value) < 1e-12 ? 0.0 : value);
  return text == "-0" ? "0" : text;
}

std::string list_text(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(number(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string vector_text(const Eigen::Vector3d& v) { return list_text({v.x(), v.y(), v.z()}); }

/// A YAML scalar: quoted where it could be anything but a plain word.
std::string scalar(const std::string& text) {
  const bool is_plain = !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
                        text.find_first_not_of(
                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                            "0123456789_./-") == std::string::npos;
  const bool is_path = text.rfind("../", 0) == 0 || (!text.empty() && text[0] == '/');
  const bool has_odd = text.find_first_of(":#'\"\\ {}[],&*?|<>=!%@`\t") != std::string::npos;
  if (is_plain || (is_path && !has_odd)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

/// Fixed-axis roll, pitch and yaw of a rotation.
Eigen::Vector3d rpy_of(const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d angles = euler_angles(rotation.transpose());
  return -angles;
}

std::string limits_line(const std::string& limits) {
  if (limits.empty())
    return "  # limits: FILE with acceleration and jerk limits (MoveIt's joint_limits.yaml); "
           "without "
           "it only speeds hold";
  return "  limits: " + scalar(limits) +
         "   # MoveIt's joint_limits.yaml; default: the URDF's speeds";
}

/// Rounded inwards, so that it stays inside the limits.
std::string range_text(const Joint& joint) {
  constexpr double kDigits = 1e4;
  const bool turns = joint.type == JointType::continuous;
  const double lower = std::ceil((turns ? -kPi : joint.lower) * kDigits) / kDigits;
  const double upper = std::floor((turns ? kPi : joint.upper) * kDigits) / kDigits;
  if (lower >= upper) return list_text({joint.lower, joint.upper});
  return list_text({lower, upper});
}

std::string ranges(const Robot& robot) {
  std::string text;
  for (const Joint& joint : robot.joints())
    text += fmt::format("{}  #  {}: {}   # {}", text.empty() ? "" : "\n", scalar(joint.name),
                        range_text(joint), joint.type == JointType::prismatic ? "m" : "rad");
  return text;
}

std::string objects(const NewProblem& problem, const Robot& robot) {
  const SeamPlace& place = problem.place;
  const double width = place.length + 2 * kPlateMargin;
  const Eigen::Vector3d down(0, 0, -problem.plate_gap.value_or(0) - 0.5 * kPlateThickness);
  const std::string link =
      robot.part_link() == robot.base_link() ? "" : "link: " + scalar(robot.part_link()) + ", ";
  const std::string plate = fmt::format("{{name: plate, {}box: {}, xyz: {}}}", link,
                                        list_text({width, width, kPlateThickness}),
                                        vector_text(place.frame.translation() + down));
  if (!problem.plate_gap)
    return "  #objects: [" + plate + "]   # in base_link, or link: of the robot";
  return "  objects:   # in base_link, or fixed to a link: of the robot; default none\n    - " +
         plate;
}

std::string link_line(const Robot& robot) {
  const bool stands = robot.part_link() == robot.base_link();
  return fmt::format(
      "  {}link: {}   # that carries the part, such as a positioner's table; default: "
      "base_link",
      stands ? "#" : "", scalar(robot.part_link()));
}

std::string segments(const NewProblem& problem) {
  const SeamPlace& place = problem.place;
  const std::string rpy = place.torch_down ? "rpy: [0, 180 deg, 0]" : "rpy: [0, 0, 0]";
  if (!problem.poses.empty())
    return "    - poses: " + scalar(problem.poses) + "   # columns x,y,z (m), qw,qx,qy,qz";
  if (problem.shape == SeamShape::arc)
    return fmt::format(
        "    - arc:\n"
        "        from: {{xyz: {}, {}}}\n"
        "        center: [0, 0, 0]\n"
        "        axis: [0, 0, -1]   # right-handed\n"
        "        angle: {:.4g} deg",
        list_text({-arc_radius(place), 0, 0}), rpy, place.angle * 180 / kPi);
  const Eigen::Vector3d half = 0.5 * place.length * Eigen::Vector3d::Unit(place.axis);
  return fmt::format(
      "    - line:\n"
      "        from: {{xyz: {}, {}}}\n"
      "        to: {{xyz: {}, {}}}",
      vector_text(-half), rpy, vector_text(half), rpy);
}

std::string tolerance(Freedom freedom) {
  const bool tilts = freedom == Freedom::tilt_and_spin;
  return fmt::format(
      "    travel_angle: {}   # rad: about x, leaning along the weld\n"
      "    work_angle: {}   # rad: about y, leaning across it\n"
      "    spin: {}   # rad: about the torch's axis",
      tilts ? "10 deg" : "0", tilts ? "5 deg" : "0", freedom == Freedom::none ? "0" : "free");
}

std::string samples(Freedom freedom) {
  const std::string tilt =
      freedom == Freedom::tilt_and_spin ? "travel_angle: 10 deg, work_angle: 5 deg, " : "";
  return "  samples: {" + tilt +
         "spin: 30 deg}   # m, rad: steps\n"
         "  # Default: ends and nominal, 10 deg where free. Instead: automatic_samples: 200, about "
         "so "
         "many a waypoint.";
}

std::string filled(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [name, value] : values) {
    const std::string mark = "{{" + name + "}}";
    for (std::size_t at = text.find(mark); at != std::string::npos;
         at = text.find(mark, at + value.size()))
      text.replace(at, mark.size(), value);
  }
  return text;
}

std::vector<double> rounded_posture(const SeamPlace& place) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(place.posture.size()));
  for (const double value : place.posture) values.push_back(std::round(value * 1000) / 1000);
  return values;
}

}  // namespace

std::string problem_text(const NewProblem& problem, const Robot& robot) {
  const SeamPlace& place = problem.place;
  const std::vector<double> ones(static_cast<std::size_t>(robot.joint_count()), 1.0);
  return filled(std::string(problem_template()),
                {{"TITLE", problem.name + ": a seam for " + robot.name() + ", to start from"},
                 {"FILE", problem.name + ".yaml"},
                 {"NAME", scalar(problem.name)},
                 {"URDF", scalar(problem.urdf)},
                 {"BASE", scalar(robot.base_link())},
                 {"TIP", scalar(robot.tip_link())},
                 {"LIMITS", limits_line(problem.limits)},
                 {"RANGES", ranges(robot)},
                 {"OBJECTS", objects(problem, robot)},
                 {"LINK", link_line(robot)},
                 {"XYZ", vector_text(place.frame.translation())},
                 {"RPY", vector_text(rpy_of(place.frame.linear()))},
                 {"SPACING", number(1000 * place.length / kIntervals) + " mm"},
                 {"SEGMENTS", segments(problem)},
                 {"TOLERANCE", tolerance(problem.freedom)},
                 {"SAMPLES", samples(problem.freedom)},
                 {"ONES", list_text(ones)},
                 {"POSTURE", list_text(rounded_posture(place))}});
}

std::string poses_text(const SeamPlace& place) {
  constexpr int kRows = 5;
  std::string text = "x,y,z,qw,qx,qy,qz\n";
  for (int i = 0; i < kRows; ++i) {
    const double along = place.length * (static_cast<double>(i) / (kRows - 1) - 0.5);
    const Eigen::Vector3d position = along * Eigen::Vector3d::Unit(place.axis);
    text += fmt::format("{},{},{},{}\n", number(position.x()), number(position.y()),
                        number(position.z()), place.torch_down ? "0,0,1,0" : "1,0,0,0");
  }
  return text;
}

}  // namespace wristwise::app
