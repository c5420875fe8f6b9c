#include "app/smoothing_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/excess_rows.hpp"
#include "app/text_table.hpp"
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
    for (int j = 0; j < robot.joint_count(); ++j) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      rows.push_back(
          {fmt::format("peak {} of {}", kNames[static_cast<std::size_t>(order - 1)], joint.name),
           before ? short_number((*before)[j]) : "-", short_number(after[j]),
           limit_text(limit[j])});
    }
  }
}

std::string clearance_text(const Verification& verification) {
  return verification.clearance ? short_number(*verification.clearance) : "-";
}

void append_excesses(const Verification& before, const Verification& after, const Problem& problem,
                     std::vector<TableRow>& rows) {
  const std::size_t excesses = rows.size();
  append_excess_rows(before, after, rows);
  for (std::size_t i = excesses; i < rows.size(); ++i) rows[i].push_back("0");
  rows.push_back({"beyond joint limits", short_number(before.joint_limit_excess),
                  short_number(after.joint_limit_excess), "0"});
  rows.push_back({"clearance, m", clearance_text(before), clearance_text(after),
                  short_number(problem.scene.clearance)});
}

std::string violations(const std::string& when, const std::vector<std::string>& lines,
                       const Paint& paint) {
  const std::string heading = paint.bold("violated " + when + ":");
  if (lines.empty()) return heading + " nothing\n";
  std::string text = heading + "\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

}  // namespace

std::string smoothing_table(const PlanResult& result, const Problem& problem, const Paint& paint) {
  if (!result.before || result.trajectory.empty()) return {};
  const Verification& before = result.before->verification;
  std::vector<TableRow> rows = {{"rad, m, s", "before", "after", "limit"}};
  append_peaks(result, *problem.robot, rows);
  append_excesses(before, result.verification, problem, rows);
  return aligned(rows, 0) + violations("before", violations_of(before), paint) +
         violations("now", violations_of(result.verification), paint);
}

}  // namespace wristwise::app
