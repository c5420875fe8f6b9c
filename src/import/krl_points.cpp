#include "import/krl_points.hpp"

#include <algorithm>
#include <array>

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMillimetre = 1e-3;
constexpr std::array<const char*, 6> kFrameNames = {"X", "Y", "Z", "A", "B", "C"};

bool is_axis(const std::string& name) {
  return name.size() == 2 && name[0] == 'A' && name[1] >= '1' && name[1] <= '6';
}

bool is_coordinate(const std::string& name) {
  return std::find(kFrameNames.begin(), kFrameNames.end(), name) != kFrameNames.end();
}

bool is_external(const std::string& name) {
  return name.size() == 2 && name[0] == 'E' && name[1] >= '1' && name[1] <= '6';
}

template <typename Predicate>
bool any_name(const KrlAggregate& aggregate, Predicate predicate) {
  return std::any_of(aggregate.begin(), aggregate.end(),
                     [&](const auto& entry) { return predicate(entry.first); });
}

}  // namespace

void KrlPoints::declare(TokenReader& reader) {
  const std::string name = reader.word("the name of a point");
  if (reader.at_symbol('[')) reader.not_understood("points one by one, no arrays");
  if (!reader.accept_symbol('=')) return;  // declared without a value
  if (reader.at_symbol('{')) {
    points_[name] = read_aggregate(reader);
    return;
  }
  if (!has(reader.peek().text)) reader.not_understood("{...} or a point that has a value");
  const KrlAggregate value = points_.at(reader.next().text);
  points_[name] = value;
}

KrlAggregate KrlPoints::target(TokenReader& reader) const {
  if (reader.at_symbol('{')) return read_aggregate(reader);
  if (reader.peek().kind != Token::Kind::word) reader.not_understood("a point or {...}");
  if (!has(reader.peek().text))
    reader.fail("the point '" + reader.peek().text.substr(0, 40) + "' has no value here",
                "it in this file, or in the .dat file beside it");
  return points_.at(reader.next().text);
}

void KrlPoints::read_target(TokenReader& reader, ProgramMove& move) {
  move.where = reader.where();
  const KrlAggregate given = target(reader);
  const bool axes = any_name(given, is_axis), frame = any_name(given, is_coordinate);
  if (axes && frame) reader.fail("axes and coordinates in one target", "either");
  if (frame)
    set_pose(given, reader, move);
  else if (axes || any_name(given, is_external))
    set_axes(given, reader, move);
  else
    reader.fail("a target without values", "axes A1 ... or coordinates X ...");
}

void KrlPoints::set_axes(const KrlAggregate& given, const TokenReader& reader, ProgramMove& move) {
  if (move.linear) reader.fail("a linear move to values of axes", "X, Y, Z, A, B, C");
  for (const auto& [name, value] : given)
    if (is_axis(name) || is_external(name)) axes_[name] = value;
  frame_.clear();
  AxisValues values = no_axes();
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    const auto found = axes_.find(axis_name(axis));
    if (found != axes_.end()) values[axis] = found->second;
  }
  move.axes = values;
}

void KrlPoints::set_pose(const KrlAggregate& given, const TokenReader& reader, ProgramMove& move) {
  for (const auto& [name, value] : given)
    if (is_coordinate(name)) frame_[name] = value;
  axes_.clear();
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto found = frame_.find(kFrameNames[i]);
    if (found == frame_.end())
      reader.fail(std::string("no ") + kFrameNames[i] + ", here nor in the move before",
                  "X, Y, Z, A, B, C");
    values[i] = found->second;
  }
  move.pose =
      pose_from_xyz_rpy(kMillimetre * Eigen::Vector3d(values[0], values[1], values[2]),
                        kDegree * Eigen::Vector3d(values[5], values[4],
                                                  values[3]));  // A about z, B about y, C about x
}

}  // namespace wristwise
