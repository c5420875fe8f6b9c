#include "app/smoothing_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/text_table.hpp"
#include "app/verification_table.hpp"
#include "io/peaks.hpp"

namespace wristwise::app {

namespace {

constexpr std::array<const char*, 3> kNames = {"velocity", "acceleration", "jerk"};

std::string limit_text(double limit) { return std::isfinite(limit) ? short_number(limit) : "-"; }

void append_peaks(const PlanResult& result, const Robot& robot, std::vector<TableRow>& rows) {
  for (int order = 1; order <= 3; ++order) {
    const auto before = peak_derivative(result.before->path, order);
    const JointVector after = peak_derivative(result.trajectory, order);
    const JointVector limit = derivative_limits(robot, order);
    for (int j = 0; j < robot.joint_count(); ++j)
      rows.push_back({fmt::format("peak {} of {}", kNames[static_cast<std::size_t>(order - 1)],
                                  robot.joints()[static_cast<std::size_t>(j)].name),
                      before ? short_number((*before)[j]) : "-", short_number(after[j]),
                      limit_text(limit[j])});
  }
}

std::string clearance_text(const Verification& verification) {
  return verification.clearance ? short_number(*verification.clearance) + " m" : "-";
}

void append_excesses(const Verification& before, const Verification& after, const Problem& problem,
                     std::vector<TableRow>& rows) {
  rows.push_back({"outside the tolerance at waypoints", excess_text(before.tolerance_excess),
                  excess_text(after.tolerance_excess), "0"});
  rows.push_back({"outside it between waypoints", excess_text(before.tolerance_excess_between),
                  excess_text(after.tolerance_excess_between), "0"});
  rows.push_back({"beyond joint limits", short_number(before.joint_limit_excess),
                  short_number(after.joint_limit_excess), "0"});
  rows.push_back({"clearance", clearance_text(before), clearance_text(after),
                  short_number(problem.scene.clearance) + " m"});
}

std::string violations(const std::string& when, const std::vector<std::string>& lines) {
  if (lines.empty()) return fmt::format("violated {}: nothing\n", when);
  std::string text = fmt::format("violated {}:\n", when);
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

}  // namespace

std::string smoothing_table(const PlanResult& result, const Problem& problem) {
  if (!result.before || result.trajectory.empty()) return {};
  const Verification& before = result.before->verification;
  std::vector<TableRow> rows = {{"", "before", "after", "limit"}};
  append_peaks(result, *problem.robot, rows);
  append_excesses(before, result.verification, problem, rows);
  return aligned(rows, 0) + violations("before", violations_of(before)) +
         violations("now", violations_of(result.verification));
}

}  // namespace wristwise::app
