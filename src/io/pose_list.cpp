#include <fmt/format.h>

#include <cmath>

#include "io/csv.hpp"
#include "io/path_section.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kUnitTolerance = 1e-3;  // of a quaternion's norm

Eigen::Quaterniond unit_quaternion(double w, double x, double y, double z,
                                   const std::string& where) {
  const Eigen::Quaterniond quaternion(w, x, y, z);
  if (std::abs(quaternion.norm() - 1) > kUnitTolerance)
    throw InvalidInput(where, fmt::format("the quaternion has the norm {:.6g}", quaternion.norm()),
                       "1");
  return quaternion.normalized();
}

}  // namespace

PoseListSegment read_pose_list(const std::filesystem::path& file, const Pose& part) {
  const CsvTable table(file);
  const std::size_t x = table.column("x"), y = table.column("y"), z = table.column("z");
  const std::size_t qw = table.column("qw"), qx = table.column("qx");
  const std::size_t qy = table.column("qy"), qz = table.column("qz");
  const auto time = table.find_column("time");

  PoseListSegment list;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Pose pose = Pose::Identity();
    pose.translation() << table.number(row, x), table.number(row, y), table.number(row, z);
    pose.linear() = unit_quaternion(table.number(row, qw), table.number(row, qx),
                                    table.number(row, qy), table.number(row, qz), table.where(row))
                        .toRotationMatrix();
    list.poses.push_back(part * pose);
    list.where.push_back(table.where(row));
    if (!time) continue;
    list.times.push_back(table.number(row, *time));
    if (row > 0 && list.times[row] <= list.times[row - 1])
      throw InvalidInput(table.where(row), "time does not increase");
  }
  if (list.poses.empty()) throw InvalidInput(table.where(), "no poses", "at least one row");
  return list;
}

}  // namespace wristwise
