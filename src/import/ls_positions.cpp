#include "import/ls_positions.hpp"

#include <array>
#include <cmath>

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMillimetre = 1e-3;
constexpr double kMostPositions = 1e6;
constexpr std::array<const char*, 6> kFrameNames = {"X", "Y", "Z", "W", "P", "R"};

using Values = std::map<std::string, double>;

/// J1 to J6, E1 to E6 as an axis.
std::optional<std::size_t> axis_of(const std::string& name) {
  if (name.size() != 2 || name[1] < '1' || name[1] > '6') return std::nullopt;
  const auto index = static_cast<std::size_t>(name[1] - '1');
  if (name[0] == 'J') return index;
  if (name[0] == 'E') return kRobotAxes + index;
  return std::nullopt;
}

bool is_coordinate(const std::string& name) {
  for (const char* known : kFrameNames)
    if (name == known) return true;
  return false;
}

/// "= 1.5 deg": deg or mm as the quantity wants.
double read_value(TokenReader& reader, const std::string& name) {
  reader.expect_symbol('=');
  const double value = reader.number(name);
  if (!reader.accept_word("DEG") && !reader.accept_word("MM"))
    reader.not_understood("deg or mm after " + name);
  return value;
}

Pose pose_of(const Values& values, const TokenReader& reader) {
  std::array<double, 6> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto found = values.find(kFrameNames[i]);
    if (found == values.end()) reader.fail(std::string("no ") + kFrameNames[i], "X, Y, Z, W, P, R");
    v[i] = found->second;
  }
  return pose_from_xyz_rpy(kMillimetre * Eigen::Vector3d(v[0], v[1], v[2]),
                           kDegree * Eigen::Vector3d(v[3], v[4], v[5]));
}

/// What stands between the braces.
LsPosition read_body(TokenReader& reader, int j3_coupling) {
  LsPosition position;
  AxisValues axes = no_axes();
  bool has_joints = false;
  Values frame;
  while (!reader.at_symbol('}')) {
    if (reader.at_end()) reader.fail("a position without an end", "}");
    if (reader.accept_symbol(',')) continue;
    const std::string name = reader.word("GP1, UF, UT, CONFIG, J1 ... or X ...");
    if (name == "CONFIG") {
      while (!reader.at_end() && !reader.at_symbol('\'')) reader.next();
      reader.next();
      reader.skip_past('\'');
    } else if (name == "UF" || name == "UT") {
      reader.expect_symbol(':');
      (name == "UF" ? position.frame : position.tool) =
          reader.at_word("F") ? (reader.next(), 0.0) : reader.number("the number of " + name);
    } else if (name.rfind("GP", 0) == 0) {
      if (name != "GP1") reader.fail("motion group " + name.substr(0, 8), "GP1 alone");
      reader.expect_symbol(':');
    } else if (const auto axis = axis_of(name)) {
      axes[*axis] = read_value(reader, name);
      has_joints = has_joints || name[0] == 'J';
    } else if (is_coordinate(name)) {
      frame[name] = read_value(reader, name);
    } else {
      reader.fail("'" + name.substr(0, 40) + "' is not understood", "J1 ... or X ...");
    }
  }
  if (has_joints && !frame.empty()) reader.fail("axes and coordinates", "either");
  if (!has_joints && frame.empty()) reader.fail("a position without values", "J1 ... or X ...");
  if (has_joints)
    position.axes = uncoupled(axes, j3_coupling);
  else
    position.pose = pose_of(frame, reader);
  return position;
}

}  // namespace

LsPositions read_ls_positions(TokenReader& reader, int j3_coupling) {
  LsPositions positions;
  while (!reader.at_end() && !reader.at_symbol('/')) {
    if (!reader.accept_word("P")) reader.not_understood("P[...]{...};");
    reader.expect_symbol('[');
    const double number = reader.number("the number of the position");
    if (number != std::floor(number) || number < 0 || number > kMostPositions)
      reader.fail("no number of a position", "a whole number");
    if (reader.accept_symbol(':')) reader.next();  // its comment
    reader.expect_symbol(']');
    reader.expect_symbol('{');
    const LsPosition position = read_body(reader, j3_coupling);
    if (!positions.emplace(static_cast<int>(number), position).second)
      reader.fail("a position that is given twice", "once");
    reader.expect_symbol('}');
    reader.accept_symbol(';');
  }
  return positions;
}

}  // namespace wristwise
