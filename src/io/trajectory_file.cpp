#include "wristwise/trajectory_file.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "io/csv.hpp"
#include "io/text_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

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

void append_header(const std::vector<std::string>& joints, bool curve, std::string& text) {
  text += "time";
  for (const std::string& joint : joints) text += "," + joint;
  if (curve) {
    for (const std::string& joint : joints) text += "," + joint + "_velocity";
    for (const std::string& joint : joints) text += "," + joint + "_acceleration";
  }
  text += '\n';
}

}  // namespace

TrajectoryFile read_trajectory(const std::filesystem::path& file,
                               const std::vector<std::string>& joint_names) {
  const CsvTable table(file);
  TrajectoryFile result;
  result.path = read_path(table, joint_names);
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
                const JointPath& path) {
  std::string text;
  append_header(joint_names, false, text);
  for (std::size_t i = 0; i < path.size(); ++i) {
    append_number(path.times[i], text);
    append_joints(path.positions[i], text);
    text += '\n';
  }
  write_text(file, text);
}

void write_trajectory(const std::filesystem::path& file,
                      const std::vector<std::string>& joint_names, const Trajectory& trajectory) {
  std::string text;
  append_header(joint_names, true, text);
  for (std::size_t i = 0; i < trajectory.times().size(); ++i) {
    append_number(trajectory.times()[i], text);
    append_joints(trajectory.positions()[i], text);
    append_joints(trajectory.velocities()[i], text);
    append_joints(trajectory.accelerations()[i], text);
    text += '\n';
  }
  write_text(file, text);
}

void write_dense(const std::filesystem::path& file, const std::vector<std::string>& joint_names,
                 const Trajectory& trajectory, double period) {
  if (!(period > 0) || !std::isfinite(period))
    throw InvalidInput("period", std::to_string(period) + " s", "a positive time");
  std::string text;
  append_header(joint_names, true, text);
  const auto append_row = [&](double t) {
    append_number(t, text);
    for (int derivative = 0; derivative <= 2; ++derivative)
      append_joints(trajectory.evaluate(t, derivative), text);
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
