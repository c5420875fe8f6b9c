#include "app/comparison_table.hpp"

#include <fmt/format.h>

#include <array>

#include "app/excess_rows.hpp"
#include "app/text_table.hpp"
#include "app/verification_table.hpp"
#include "io/peaks.hpp"
#include "io/result_file.hpp"

namespace wristwise::app {

namespace {

constexpr std::array<const char*, 3> kDerivativeNames = {"velocity", "acceleration", "jerk"};

double joint_motion_l1(const JointPath& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += (path.positions[i] - path.positions[i - 1]).lpNorm<1>();
  return sum;
}

TableRow number_row(const std::string& name, double first, double second) {
  return {name, short_number(first), short_number(second),
          first > 0 ? short_number(second / first) : "-"};
}

void append_peaks(const PlanResult& first, const PlanResult& second, const Robot& robot,
                  std::vector<TableRow>& rows) {
  for (int order = 1; order <= 3; ++order) {
    const auto first_peak = peak_derivative(first.path, order);
    const auto second_peak = peak_derivative(second.path, order);
    if (!first_peak || !second_peak) continue;
    for (int j = 0; j < robot.joint_count(); ++j) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      rows.push_back(
          number_row(fmt::format("peak {} of {}",
                                 kDerivativeNames[static_cast<std::size_t>(order - 1)], joint.name),
                     (*first_peak)[j], (*second_peak)[j]));
    }
  }
}

std::string clearance_text(const Verification& verification) {
  return verification.clearance ? short_number(*verification.clearance) : "-";
}

}  // namespace

std::string comparison_table(const PlanResult& graph_only, const PlanResult& two_stage,
                             const Problem& problem, const Paint& paint) {
  const Verification& first = graph_only.verification;
  const Verification& second = two_stage.verification;
  std::vector<TableRow> rows = {
      {paint.bold(problem.name), mode_name(graph_only.mode), mode_name(two_stage.mode), "ratio"},
      {"status", status_name(graph_only.status), status_name(two_stage.status)},
      {"check", checked_text(first, paint), checked_text(second, paint)}};
  if (graph_only.path.size() > 1 && two_stage.path.size() > 1) {
    rows.push_back(number_row("joint motion (L1)", joint_motion_l1(graph_only.path),
                              joint_motion_l1(two_stage.path)));
    append_peaks(graph_only, two_stage, *problem.robot, rows);
  }
  append_excess_rows(first, second, rows);
  rows.push_back({"clearance, m", clearance_text(first), clearance_text(second)});
  rows.push_back(number_row("joint speed / limit", first.velocity_ratio, second.velocity_ratio));
  rows.push_back(number_row("time, s", graph_only.timing.total, two_stage.timing.total));
  return aligned(rows, 0) + "peaks in rad (m of a sliding joint) and s\n";
}

}  // namespace wristwise::app
