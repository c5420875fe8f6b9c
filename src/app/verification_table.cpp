#include "app/verification_table.hpp"

#include <fmt/format.h>

#include "app/text_table.hpp"

namespace wristwise::app {

namespace {

/// "1.2e-7 m, 3e-8 rad": the largest excess of a position and of an angle.
std::string excess_text(const Vector6& excess) {
  return fmt::format("{} m, {} rad", short_number(excess.head<3>().maxCoeff()),
                     short_number(excess.tail<3>().maxCoeff()));
}

std::string ratio_text(double ratio, int joint, const Problem& problem) {
  if (joint < 0) return short_number(ratio);
  return fmt::format("{} ({})", short_number(ratio),
                     problem.robot->joints()[static_cast<std::size_t>(joint)].name);
}

std::string clearance_text(const Verification& verification, const Problem& problem) {
  if (!verification.clearance) return "no pair counts";
  return fmt::format("{} of {} m ({} - {}, {} s)", short_number(*verification.clearance),
                     problem.scene.clearance, verification.clearance_pair.first,
                     verification.clearance_pair.second, short_number(verification.clearance_time));
}

std::string range_text(const TimeRange& range) {
  return fmt::format("[{}, {}] s", short_number(range.from), short_number(range.to));
}

/// What is shown for all t, and where it is not: one row each.
std::vector<TableRow> certificate(const Verification& verification) {
  constexpr double kDegree = 0.017453292519943295;
  const std::string for_all = "for all t in " + range_text(verification.range);
  std::vector<TableRow> rows;
  if (verification.clearance_bound)
    rows.push_back(
        {for_all, "clearance >= " + short_number(*verification.clearance_bound * 1e3) + " mm"});
  for (const auto& [range, pair] : verification.clearance_not_shown)
    rows.push_back({"clearance not shown",
                    fmt::format("{} - {} in {}", pair.first, pair.second, range_text(range))});
  rows.push_back({for_all, fmt::format("path error <= {} mm, {} deg",
                                       short_number(verification.path_error * 1e3),
                                       short_number(verification.angle_error / kDegree))});
  if (!verification.deviation_not_shown.empty())
    rows.push_back(
        {"tolerance not shown",
         fmt::format("in {} places, first in {}", verification.deviation_not_shown.size(),
                     range_text(verification.deviation_not_shown.front()))});
  return rows;
}

}  // namespace

std::string checked_text(const Verification& verification, const Paint& paint) {
  if (!verification.run) return paint.warning("not run");
  return verification.passed ? paint.good("passed") : paint.bad("FAILED");
}

std::string verification_table(const Verification& verification, const Problem& problem,
                               const Paint& paint) {
  if (!verification.run) return "not checked\n";
  std::string text = fmt::format(
      "{} {} ({}, {} samples)\n", paint.bold("check"), checked_text(verification, paint),
      verification.curve ? "a curve" : "points joined by straight moves", verification.samples);
  std::vector<TableRow> rows = {
      {"outside the tolerance at waypoints", excess_text(verification.tolerance_excess)},
      {"outside it between waypoints", excess_text(verification.tolerance_excess_between)},
      {"beyond joint limits", short_number(verification.joint_limit_excess)},
      {"clearance", clearance_text(verification, problem)},
  };
  for (TableRow& row : certificate(verification)) rows.push_back(std::move(row));
  rows.push_back({"joint speed / limit",
                  ratio_text(verification.velocity_ratio, verification.velocity_joint, problem)});
  rows.push_back({"acceleration / limit", ratio_text(verification.acceleration_ratio,
                                                     verification.acceleration_joint, problem)});
  rows.push_back(
      {"jerk / limit", ratio_text(verification.jerk_ratio, verification.jerk_joint, problem)});
  text += aligned(rows, 2, Flush::left);
  for (const std::string& line : verification.failures)
    text += "  " + paint.bad("failure:") + " " + line + "\n";
  for (const std::string& line : verification.warnings)
    text += "  " + paint.warning("warning:") + " " + line + "\n";
  return text;
}

}  // namespace wristwise::app
