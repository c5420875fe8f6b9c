#include "export/program_lines.hpp"

#include <fmt/format.h>

#include "export/fixed_number.hpp"

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;

/// Before: on the move that ends at the point. After: on the next one.
bool welding_before(const RobotProgram& program, std::size_t point) {
  return program.points[point].welding;
}
bool welding_after(const RobotProgram& program, std::size_t point) {
  return point + 1 < program.points.size() && program.points[point + 1].welding;
}

}  // namespace

bool weld_starts_at(const RobotProgram& program, std::size_t point) {
  return !welding_before(program, point) && welding_after(program, point);
}

bool weld_ends_at(const RobotProgram& program, std::size_t point) {
  return welding_before(program, point) && !welding_after(program, point);
}

std::string points_comment(const RobotProgram& program) {
  return fmt::format("{} points in {} s, off the plan by {} mm and {} deg at most",
                     program.points.size(), fixed_number(program.points.back().time, 3),
                     fixed_number(program.deviation * 1e3, 3),
                     fixed_number(program.angle_deviation / kDegree, 3));
}

}  // namespace wristwise
