#include <algorithm>

#include "export/controller_axes.hpp"
#include "io/problem_sections.hpp"

namespace wristwise {

namespace {

constexpr std::size_t kLongestWord = 80;

int read_axis_number(const ConfigReader& reader) {
  std::vector<std::string> names;
  for (std::size_t axis = 0; axis < kRobotAxes + kExternalAxes; ++axis)
    names.push_back(axis_name(axis));
  const std::string word = reader.choice(names);
  return static_cast<int>(std::find(names.begin(), names.end(), word) - names.begin());
}

/// An axis, or an axis with sign and offset.
ControllerAxis read_axis(const ConfigReader& reader, Quantity quantity) {
  if (!reader.is_map()) return {read_axis_number(reader)};
  reader.expect_keys({"axis", "sign", "offset"});
  ControllerAxis axis{read_axis_number(reader.at("axis"))};
  if (const auto sign = reader.find("sign")) {
    axis.sign = sign->quantity(Quantity::number);
    if (axis.sign != 1 && axis.sign != -1) sign->fail("'" + sign->text() + "'", "1 or -1");
  }
  if (const auto offset = reader.find("offset")) axis.offset = offset->quantity(quantity);
  return axis;
}

std::vector<ControllerAxis> read_axes(const ConfigReader& reader, const Robot& robot) {
  const std::vector<std::string> names = robot.joint_names();
  reader.expect_keys(names);
  std::vector<ControllerAxis> axes;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const ConfigReader joint = reader.at(names[j]);
    axes.push_back(read_axis(joint, joint_quantity(robot, j)));
    for (std::size_t i = 0; i < j; ++i)
      if (axes[i].number == axes[j].number)
        joint.fail("the axis of " + names[i], "an axis of its own for each joint");
  }
  return axes;
}

/// One line of a program: printable, not too long.
std::string read_line(const ConfigReader& reader) {
  std::string text = reader.text();
  const bool printable =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (text.empty() || text.size() > kLongestWord || !printable)
    reader.fail("'" + text + "'", "1 to 80 printable ASCII characters");
  return text;
}

/// A line, or a list of lines; an empty list for none.
void read_lines(const ConfigReader& reader, const std::string& key,
                std::vector<std::string>& lines) {
  const auto value = reader.find(key);
  if (!value) return;
  lines.clear();
  if (!value->is_list()) {
    lines.push_back(read_line(*value));
    return;
  }
  for (const ConfigReader& item : value->items()) lines.push_back(read_line(item));
}

void read_word(const ConfigReader& reader, const std::string& key, std::string& word) {
  if (const auto value = reader.find(key)) word = read_line(*value);
}

void read_number(const ConfigReader& reader, const std::string& key, int most, int& number) {
  const auto value = reader.find(key);
  if (!value) return;
  number = value->whole_number(0);
  if (number > most) value->fail("too large", "at most " + std::to_string(most));
}

ExportOptions::Krl read_krl(const ConfigReader& reader) {
  reader.expect_keys({"tool", "base", "weld_on", "weld_off"});
  ExportOptions::Krl krl;
  read_number(reader, "tool", 128, krl.tool);
  read_number(reader, "base", 128, krl.base);
  read_word(reader, "weld_on", krl.weld_on);
  read_word(reader, "weld_off", krl.weld_off);
  return krl;
}

ExportOptions::Rapid read_rapid(const ConfigReader& reader) {
  reader.expect_keys({"tool", "wobj", "zone", "weld_on", "weld_off"});
  ExportOptions::Rapid rapid;
  read_word(reader, "tool", rapid.tool);
  read_word(reader, "wobj", rapid.wobj);
  read_word(reader, "zone", rapid.zone);
  read_lines(reader, "weld_on", rapid.weld_on);
  read_lines(reader, "weld_off", rapid.weld_off);
  return rapid;
}

ExportOptions::Ls read_ls(const ConfigReader& reader) {
  reader.expect_keys({"tool", "frame", "cnt", "j3_coupling", "weld_on", "weld_off"});
  ExportOptions::Ls ls;
  read_number(reader, "tool", 29, ls.tool);
  read_number(reader, "frame", 29, ls.frame);
  read_number(reader, "cnt", 100, ls.cnt);
  if (const auto coupling = reader.find("j3_coupling"))
    ls.j3_coupling = std::stoi(coupling->choice({"-1", "0", "1"}));
  read_lines(reader, "weld_on", ls.weld_on);
  read_lines(reader, "weld_off", ls.weld_off);
  return ls;
}

void read_points(const ConfigReader& reader, ExportOptions& options) {
  if (const auto deviation = reader.find("max_deviation")) {
    const auto parts = deviation->items(2, "[position in m, angle in rad]");
    options.max_deviation = parts[0].positive(Quantity::length);
    options.max_angle_deviation = parts[1].positive(Quantity::angle);
  }
  const auto period = reader.find("period");
  if (!period) return;
  if (reader.find("max_deviation")) period->fail("max_deviation is given too", "one of the two");
  options.period = period->positive(Quantity::time);
  if (*options.period < 1e-3) period->fail("less than 1 ms", "at least 1 ms");
}

}  // namespace

ExportOptions read_export(const ConfigReader& reader, const Robot& robot) {
  reader.expect_keys({"name", "joints", "max_deviation", "period", "approach_percent", "weld",
                      "krl", "rapid", "ls"});
  ExportOptions options;
  read_word(reader, "name", options.name);
  if (const auto joints = reader.find("joints")) options.axes = read_axes(*joints, robot);
  read_points(reader, options);
  if (const auto percent = reader.find("approach_percent")) {
    options.approach_percent = percent->whole_number(1);
    if (options.approach_percent > 100) percent->fail("above 100", "1 to 100");
  }
  if (const auto weld = reader.find("weld"))
    options.weld = weld->choice({"true", "false"}) == "true";
  if (const auto krl = reader.find("krl")) options.krl = read_krl(*krl);
  if (const auto rapid = reader.find("rapid")) options.rapid = read_rapid(*rapid);
  if (const auto ls = reader.find("ls")) options.ls = read_ls(*ls);
  return options;
}

}  // namespace wristwise
