#include "import/rapid_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "import/unit_quaternion.hpp"

namespace wristwise {

namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kNoAxis = 8.9e9;  // 9E9: no such external axis
constexpr std::size_t kDeepest = 4;

/// What a type is made of: how many numbers.
std::size_t size_of(const std::string& type) {
  if (type == "JOINTTARGET") return 12;
  if (type == "ROBTARGET") return 17;
  return type == "SPEEDDATA" ? 4 : 0;
}

/// Numbers of nested brackets, one after the other.
void read_list(TokenReader& reader, std::vector<double>& numbers, std::size_t depth = 0) {
  if (depth > kDeepest) reader.fail("brackets too deep", "a target");
  reader.expect_symbol('[');
  do {
    if (reader.at_symbol('['))
      read_list(reader, numbers, depth + 1);
    else
      numbers.push_back(reader.number("in brackets"));
  } while (reader.accept_symbol(','));
  reader.expect_symbol(']');
}

/// v100, vmax: the TCP's speed in m/s.
std::optional<double> standard_speed(const std::string& name) {
  if (name.size() < 2 || name[0] != 'V') return std::nullopt;
  int speed = 0;
  const auto parsed = std::from_chars(name.data() + 1, name.data() + name.size(), speed);
  if (parsed.ec != std::errc() || parsed.ptr != name.data() + name.size() || speed <= 0)
    return std::nullopt;
  return speed * kMillimetre;
}

}  // namespace

bool RapidValues::has(const std::string& name) const { return types_.count(name) > 0; }

void RapidValues::read_data(TokenReader& reader) {
  const std::string type = reader.word("a type");
  const std::string name = reader.word("a name");
  if (size_of(type) == 0) {
    reader.skip_past(';');
    return;
  }
  if (reader.at_symbol('{')) reader.not_understood("targets one by one, no arrays");
  types_[name] = type;
  if (reader.at_symbol(':')) assign(name, type, reader);
  reader.expect_symbol(';');
}

void RapidValues::assign(TokenReader& reader) {
  const std::string name = reader.word("a name");
  assign(name, types_.at(name), reader);
  reader.expect_symbol(';');
}

void RapidValues::assign(const std::string& name, const std::string& type, TokenReader& reader) {
  reader.expect_symbol(':');
  reader.expect_symbol('=');
  values_[name] = numbers(reader, type);
}

RapidValues::Numbers RapidValues::numbers(TokenReader& reader, const std::string& type) const {
  if (reader.at_symbol('[')) {
    Numbers numbers;
    read_list(reader, numbers);
    if (numbers.size() != size_of(type))
      reader.fail(fmt::format("{} numbers", numbers.size()),
                  fmt::format("the {} of a {}", size_of(type), type));
    return numbers;
  }
  const std::string name = reader.peek().text;
  const auto found = types_.find(name);
  if (reader.peek().kind != Token::Kind::word || found == types_.end() || found->second != type ||
      values_.count(name) == 0)
    reader.not_understood("a " + type + " that has a value in this file, or [...]");
  reader.next();
  return values_.at(name);
}

void RapidValues::read_joint_target(TokenReader& reader, ProgramMove& move) const {
  const Numbers values = numbers(reader, "JOINTTARGET");
  AxisValues axes = no_axes();
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (values[axis] < kNoAxis) axes[axis] = values[axis];
  move.axes = axes;
}

void RapidValues::read_pose_target(TokenReader& reader, ProgramMove& move) const {
  const std::string where = reader.where();
  const Numbers values = numbers(reader, "ROBTARGET");
  Pose pose = Pose::Identity();
  pose.translation() = kMillimetre * Eigen::Vector3d(values[0], values[1], values[2]);
  pose.linear() =
      unit_quaternion(values[3], values[4], values[5], values[6], where).toRotationMatrix();
  move.pose = pose;
}

void RapidValues::read_speed(TokenReader& reader, ProgramMove& move) const {
  if (reader.peek().kind == Token::Kind::word && !has(reader.peek().text)) {
    if (reader.at_word("VMAX"))
      move.percent = all_percent(100);
    else
      move.speed = standard_speed(reader.peek().text);
    if (!move.percent && !move.speed) reader.not_understood("speeddata");
    reader.next();
  } else {
    move.speed = numbers(reader, "SPEEDDATA")[0] * kMillimetre;
  }
  while (reader.accept_symbol('\\')) {
    const std::string name = reader.word("a switch");
    reader.expect_symbol(':');
    reader.expect_symbol('=');
    const double value = reader.number("above zero");
    if (name == "T")
      move.time = value;
    else if (name == "V")
      move.speed = value * kMillimetre;
    else
      reader.fail("the switch \\" + name + " is not understood", "\\V or \\T");
  }
  if ((move.time && *move.time <= 0) || (move.speed && *move.speed <= 0))
    reader.fail("a time or speed that is not above zero", "above zero");
}

}  // namespace wristwise
