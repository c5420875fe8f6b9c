#include <fmt/format.h>

#include <array>
#include <cmath>

#include "import/unit_quaternion.hpp"
#include "io/csv.hpp"
#include "io/path_section.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

/// A column, and what its numbers are multiplied by or divided by to be in SI units.
struct Column {
  std::size_t index = 0;
  double numerator = 1, denominator = 1;
};

struct Unit {
  const char* name;
  double numerator, denominator;
};

constexpr double kPi = 3.14159265358979323846;
constexpr std::array<Unit, 3> kLengths = {{{"m", 1, 1}, {"cm", 1, 100}, {"mm", 1, 1000}}};
constexpr std::array<Unit, 2> kAngles = {{{"rad", 1, 1}, {"deg", kPi, 180}}};
constexpr std::array<Unit, 2> kTimes = {{{"s", 1, 1}, {"ms", 1, 1000}}};
constexpr std::array<Unit, 1> kNumbers = {{{"", 1, 1}}};

template <std::size_t N>
std::vector<std::string> names(const std::array<Unit, N>& units) {
  std::vector<std::string> names(N);
  for (std::size_t i = 0; i < N; ++i) names[i] = units[i].name;
  return names;
}

template <std::size_t N>
Unit read_unit(const ConfigReader& reader, const std::string& key,
               const std::array<Unit, N>& units) {
  const auto value = reader.find(key);
  if (!value) return units[0];
  const std::string name = value->choice(names(units));
  for (const Unit& unit : units)
    if (unit.name == name) return unit;
  return units[0];
}

/// What a problem says of a file of poses.
struct PoseFile {
  std::filesystem::path file;
  std::vector<std::string> columns;  ///< empty: the file has a header
  Unit length = kLengths[0], angle = kAngles[0];
};

PoseFile read_pose_file(const ConfigReader& reader) {
  PoseFile result;
  if (!reader.is_map()) {
    result.file = reader.existing_file();
    return result;
  }
  reader.expect_keys({"file", "columns", "length_unit", "angle_unit"});
  result.file = reader.at("file").existing_file();
  result.length = read_unit(reader, "length_unit", kLengths);
  result.angle = read_unit(reader, "angle_unit", kAngles);
  if (const auto columns = reader.find("columns")) {
    for (const ConfigReader& column : columns->items()) result.columns.push_back(column.text());
    if (result.columns.empty()) columns->fail("no columns", "their names in the file's order");
  }
  return result;
}

/// The columns of a table that hold poses.
class PoseColumns {
 public:
  PoseColumns(const CsvTable& table, const PoseFile& file) : table_(table) {
    for (std::size_t k = 0; k < 3; ++k)
      position_[k] = required(kPositions[k], kLengths, file.length);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto angle = find(kAngleNames[k], kAngles, file.angle);
      if (!angle) continue;
      turned_by_angles_ = true;
      angles_[k] = *angle;
    }
    if (turned_by_angles_) {
      for (std::size_t k = 0; k < 3; ++k) required(kAngleNames[k], kAngles, file.angle);
      for (const char* name : kQuaternion)
        if (table.find_column(name))
          throw InvalidInput(table.where(), fmt::format("both rx, ry, rz and {}", name), "either");
    } else {
      for (std::size_t k = 0; k < 4; ++k)
        quaternion_[k] = required(kQuaternion[k], kNumbers, kNumbers[0]);
    }
    time_ = find("time", kTimes, kTimes[0]);
  }

  bool has_time() const { return time_.has_value(); }
  double time(std::size_t row) const { return value(row, *time_); }

  Pose pose(std::size_t row) const {
    const Eigen::Vector3d xyz = vector(row, position_);
    if (turned_by_angles_) return pose_from_xyz_rpy(xyz, vector(row, angles_));
    Pose pose = Pose::Identity();
    pose.translation() = xyz;
    pose.linear() =
        unit_quaternion(value(row, quaternion_[0]), value(row, quaternion_[1]),
                        value(row, quaternion_[2]), value(row, quaternion_[3]), table_.where(row))
            .toRotationMatrix();
    return pose;
  }

 private:
  static constexpr std::array<const char*, 3> kPositions = {"x", "y", "z"};
  static constexpr std::array<const char*, 3> kAngleNames = {"rx", "ry", "rz"};
  static constexpr std::array<const char*, 4> kQuaternion = {"qw", "qx", "qy", "qz"};

  /// `name` in the unit `plain`, or `name_unit` in that unit.
  template <std::size_t N>
  std::optional<Column> find(const std::string& name, const std::array<Unit, N>& units,
                             const Unit& plain) const {
    std::optional<Column> found;
    std::string found_name;
    const auto look = [&](const std::string& column, const Unit& unit) {
      const auto index = table_.find_column(column);
      if (!index) return;
      if (found)
        throw InvalidInput(table_.where(), fmt::format("both {} and {}", found_name, column),
                           "one of them");
      found = Column{*index, unit.numerator, unit.denominator};
      found_name = column;
    };
    look(name, plain);
    for (const Unit& unit : units)
      if (*unit.name != 0) look(name + "_" + unit.name, unit);
    return found;
  }

  template <std::size_t N>
  Column required(const std::string& name, const std::array<Unit, N>& units,
                  const Unit& plain) const {
    if (const auto column = find(name, units, plain)) return *column;
    return {table_.column(name), 1, 1};  // says that there is none
  }

  double value(std::size_t row, const Column& column) const {
    return table_.number(row, column.index) * column.numerator / column.denominator;
  }

  Eigen::Vector3d vector(std::size_t row, const std::array<Column, 3>& columns) const {
    return {value(row, columns[0]), value(row, columns[1]), value(row, columns[2])};
  }

  const CsvTable& table_;
  std::array<Column, 3> position_, angles_;
  std::array<Column, 4> quaternion_;
  bool turned_by_angles_ = false;
  std::optional<Column> time_;
};

}  // namespace

PoseListSegment read_pose_list(const ConfigReader& reader, const Pose& part) {
  const PoseFile file = read_pose_file(reader);
  const CsvTable table(file.file, file.columns);
  const PoseColumns columns(table, file);
  PoseListSegment list;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    list.poses.push_back(part * columns.pose(row));
    list.where.push_back(table.where(row));
    if (!columns.has_time()) continue;
    list.times.push_back(columns.time(row));
    if (row > 0 && list.times[row] <= list.times[row - 1])
      throw InvalidInput(table.where(row), "time does not increase");
  }
  if (list.poses.empty()) throw InvalidInput(table.where(), "no poses", "at least one row");
  return list;
}

}  // namespace wristwise
