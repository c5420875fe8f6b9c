#include "wristwise/trajectory_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "io/csv.hpp"
#include "io/text_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr std::array<const char*, 3> kSeamTimeNames = {"seam_time", "seam_time_velocity",
                                                       "seam_time_acceleration"};
constexpr double kTimeTolerance = 1e-9;  // s

using Columns = std::vector<std::size_t>;

/// The columns `<joint><suffix>` of all joints; nothing where one of them is missing.
std::optional<Columns> find_columns(const CsvTable& table, const std::vector<std::string>& joints,
                                    const std::string& suffix) {
  Columns columns;
  for (const std::string& joint : joints) {
    const auto column = table.find_column(joint + suffix);
    if (!column) return std::nullopt;
    columns.push_back(*column);
  }
  return columns;
}

JointVector read_joints(const CsvTable& table, std::size_t row, const Columns& columns) {
  JointVector values(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    values[static_cast<Eigen::Index>(j)] = table.number(row, columns[j]);
  return values;
}

JointPath read_path(const CsvTable& table, const std::vector<std::string>& joints) {
  const std::size_t time = table.column("time");
  Columns columns;
  for (const std::string& joint : joints) columns.push_back(table.column(joint));
  JointPath path;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t = table.number(row, time);
    if (row > 0 && t <= path.times.back())
      throw InvalidInput(table.where(row), "time does not increase");
    path.times.push_back(t);
    path.positions.push_back(read_joints(table, row, columns));
  }
  if (path.size() < 2)
    throw InvalidInput(table.where(), std::to_string(path.size()) + " rows", "at least two");
  return path;
}

std::optional<Trajectory> read_seam_time(const CsvTable& table, const std::vector<double>& times) {
  std::array<std::vector<JointVector>, 3> derivatives;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto column = table.find_column(kSeamTimeNames[k]);
    if (!column) return std::nullopt;
    for (std::size_t row = 0; row < table.rows(); ++row)
      derivatives[k].push_back(JointVector::Constant(1, table.number(row, *column)));
  }
  return Trajectory(times, std::move(derivatives[0]), std::move(derivatives[1]),
                    std::move(derivatives[2]));
}

void append_number(double value, std::string& text) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end.ptr);
}

void append_joints(const JointVector& values, std::string& text) {
  for (const double value : values) {
    text += ',';
    append_number(value, text);
  }
}

void append_values(const std::vector<double>& values, std::string& text) {
  for (const double value : values) {
    text += ',';
    append_number(value, text);
  }
}

void append_header(const std::vector<std::string>& joints, bool curve, const SeamColumns& seam,
                   std::string& text) {
  text += "time";
  for (const std::string& joint : joints) text += "," + joint;
  if (curve) {
    for (const std::string& joint : joints) text += "," + joint + "_velocity";
    for (const std::string& joint : joints) text += "," + joint + "_acceleration";
  }
  for (const std::string& name : seam.names()) text += "," + name;
  text += '\n';
}

}  // namespace

SeamColumns::SeamColumns(const Task& task)
    : weld_start_(task.weld_start()), weld_end_(task.weld_end()), seam_(task.seam) {
  has_welding_ = std::any_of(task.waypoints.begin(), task.waypoints.end(),
                             [](const Waypoint& waypoint) { return !waypoint.welding; });
}

std::vector<std::string> SeamColumns::names() const {
  std::vector<std::string> names;
  if (has_welding_) names.emplace_back("welding");
  if (seam_.is_retimed()) names.insert(names.end(), kSeamTimeNames.begin(), kSeamTimeNames.end());
  return names;
}

std::vector<double> SeamColumns::values(double t) const {
  std::vector<double> values;
  if (has_welding_)
    values.push_back(t >= weld_start_ - kTimeTolerance && t <= weld_end_ + kTimeTolerance ? 1 : 0);
  if (seam_.is_retimed())
    for (int k = 0; k < 3; ++k) values.push_back(seam_.seam_time().evaluate(t, k)[0]);
  return values;
}

TrajectoryFile read_trajectory(const std::filesystem::path& file,
                               const std::vector<std::string>& joint_names) {
  const CsvTable table(file);
  TrajectoryFile result;
  result.path = read_path(table, joint_names);
  result.seam_time = read_seam_time(table, result.path.times);
  const auto velocity = find_columns(table, joint_names, "_velocity");
  const auto acceleration = find_columns(table, joint_names, "_acceleration");
  if (!velocity || !acceleration) return result;
  std::vector<JointVector> velocities, accelerations;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    velocities.push_back(read_joints(table, row, *velocity));
    accelerations.push_back(read_joints(table, row, *acceleration));
  }
  result.trajectory.emplace(result.path.times, result.path.positions, std::move(velocities),
                            std::move(accelerations));
  return result;
}

void write_path(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                const JointPath& path, const SeamColumns& seam) {
  std::string text;
  append_header(joint_names, false, seam, text);
  for (std::size_t i = 0; i < path.size(); ++i) {
    append_number(path.times[i], text);
    append_joints(path.positions[i], text);
    append_values(seam.values(path.times[i]), text);
    text += '\n';
  }
  write_text(file, text);
}

void write_trajectory(const std::filesystem::path& file,
                      const std::vector<std::string>& joint_names, const Trajectory& trajectory,
                      const SeamColumns& seam) {
  std::string text;
  append_header(joint_names, true, seam, text);
  for (std::size_t i = 0; i < trajectory.times().size(); ++i) {
    append_number(trajectory.times()[i], text);
    append_joints(trajectory.positions()[i], text);
    append_joints(trajectory.velocities()[i], text);
    append_joints(trajectory.accelerations()[i], text);
    append_values(seam.values(trajectory.times()[i]), text);
    text += '\n';
  }
  write_text(file, text);
}

void write_dense(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                 const Trajectory& trajectory, double period, const SeamColumns& seam) {
  if (!(period > 0) || !std::isfinite(period))
    throw InvalidInput("period", std::to_string(period) + " s", "a positive time");
  std::string text;
  append_header(joint_names, true, seam, text);
  const auto append_row = [&](double t) {
    append_number(t, text);
    for (int derivative = 0; derivative <= 2; ++derivative)
      append_joints(trajectory.evaluate(t, derivative), text);
    append_values(seam.values(t), text);
    text += '\n';
  };
  const double start = trajectory.times().front();
  const double end = trajectory.times().back();
  // The last sample before the end is left out where it is the end but for round-off.
  const double nearly_end = end - 1e-6 * period;
  for (std::size_t k = 0; start + static_cast<double>(k) * period < nearly_end; ++k)
    append_row(start + static_cast<double>(k) * period);
  append_row(end);
  write_text(file, text);
}

}  // namespace wristwise
