#include "app/verification_table.hpp"

#include <fmt/format.h>

#include "app/text_table.hpp"

namespace wristwise::app {

namespace {

std::string ratio_text(double ratio, int joint, const Problem& problem) {
  if (joint < 0) return short_number(ratio);
  return fmt::format("{} ({})", short_number(ratio),
                     problem.robot->joints()[static_cast<std::size_t>(joint)].name);
}

std::string clearance_text(const Verification& verification, const Problem& problem) {
  if (!verification.clearance) return "no pair counts";
  return fmt::format("{} m of {} m ({} - {}, {} s)", short_number(*verification.clearance),
                     problem.scene.clearance, verification.clearance_pair.first,
                     verification.clearance_pair.second, short_number(verification.clearance_time));
}

}  // namespace

std::string excess_text(const Vector6& excess) {
  return fmt::format("{} m, {} rad", short_number(excess.head<3>().maxCoeff()),
                     short_number(excess.tail<3>().maxCoeff()));
}

std::string verification_table(const Verification& verification, const Problem& problem) {
  if (!verification.run) return "not checked\n";
  std::string text = fmt::format(
      "check {} ({}, {} samples)\n", verification.passed ? "passed" : "FAILED",
      verification.curve ? "a curve" : "points joined by straight moves", verification.samples);
  std::vector<TableRow> rows = {
      {"outside the tolerance at waypoints", excess_text(verification.tolerance_excess)},
      {"outside it between waypoints", excess_text(verification.tolerance_excess_between)},
      {"beyond joint limits", short_number(verification.joint_limit_excess)},
      {"clearance", clearance_text(verification, problem)},
  };
  if (verification.clearance_bound)
    rows.push_back(
        {"clearance shown for all t", short_number(*verification.clearance_bound) + " m"});
  rows.push_back({"joint speed / limit",
                  ratio_text(verification.velocity_ratio, verification.velocity_joint, problem)});
  rows.push_back({"acceleration / limit", ratio_text(verification.acceleration_ratio,
                                                     verification.acceleration_joint, problem)});
  rows.push_back(
      {"jerk / limit", ratio_text(verification.jerk_ratio, verification.jerk_joint, problem)});
  text += aligned(rows);
  for (const std::string& line : verification.failures) text += "  failure: " + line + "\n";
  for (const std::string& line : verification.warnings) text += "  warning: " + line + "\n";
  return text;
}

}  // namespace wristwise::app
