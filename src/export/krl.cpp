// KUKA Robot Language. KUKA System Software 8.3, Operating and Programming Instructions for System
// Integrators: PTP_SPLINE, SPTP, TIME_BLOCK, TRIGGER WHEN PATH, BAS.

#include <fmt/format.h>

#include "export/controller_axes.hpp"
#include "export/fixed_number.hpp"
#include "export/program_lines.hpp"

namespace wristwise {

namespace {

constexpr double kShareUnit = 1e-6;  // of a percent of the block's time

std::string target(const AxisValues& values) {
  std::string text = "{E6AXIS: ";
  const char* separator = "";
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    if (!std::isfinite(values[axis])) continue;
    text += fmt::format("{}{} {}", separator, axis_name(axis), fixed_number(values[axis], 4));
    separator = ",";
  }
  return text + "}";
}

/// A trigger at the end of the next segment; a call needs a priority.
std::string trigger(const std::string& statement) {
  const bool call = statement.find('=') == std::string::npos;
  return fmt::format("  TRIGGER WHEN PATH=0 DELAY=0 DO {}{}\n", statement, call ? " PRIO=-1" : "");
}

class KrlWriter {
 public:
  KrlWriter(const RobotProgram& program, const Problem& problem)
      : program_(program),
        options_(problem.exports),
        axes_(*problem.robot, problem.exports.axes),
        name_(program_name(ProgramFormat::krl, program.name)) {}

  std::string text() {
    header();
    text_ += "PTP " + point(0) + "\nBAS(#VEL_PTP,100)\n";
    if (weld_starts_at(program_, 0)) text_ += options_.krl.weld_on + "\n";
    text_ += "PTP_SPLINE\n  TIME_BLOCK START\n";
    const double duration = program_.points.back().time;
    RoundedClock clock(kShareUnit);
    for (std::size_t i = 1; i < program_.points.size(); ++i) {
      const bool inside = i + 1 < program_.points.size();
      if (inside && weld_ends_at(program_, i)) text_ += trigger(options_.krl.weld_off);
      if (inside && weld_starts_at(program_, i)) text_ += trigger(options_.krl.weld_on);
      const double share = 100 * program_.points[i].time / duration;
      text_ += "  SPTP " + point(i) + "\n";
      text_ +=
          fmt::format("  TIME_BLOCK PART={}\n",
                      fixed_number(static_cast<double>(clock.advance_to(share)) * kShareUnit, 6));
    }
    text_ += fmt::format("  TIME_BLOCK END={}\nENDSPLINE\n", fixed_number(duration, 6));
    if (weld_ends_at(program_, program_.points.size() - 1)) text_ += options_.krl.weld_off + "\n";
    return text_ + "END\n";
  }

 private:
  void header() {
    text_ = fmt::format(
        "&ACCESS RVP\n&REL 1\nDEF {}()\n; {}\nBAS(#INITMOV,0)\nBAS(#TOOL,{})\nBAS(#BASE,{})\n"
        "BAS(#VEL_PTP,{})\n",
        name_, points_comment(program_), options_.krl.tool, options_.krl.base,
        fixed_number(options_.approach_percent, 0));
  }

  std::string point(std::size_t i) const { return target(axes_.values(program_.points[i].joints)); }

  const RobotProgram& program_;
  const ExportOptions& options_;
  ControllerAxes axes_;
  std::string name_;
  std::string text_;
};

}  // namespace

std::string krl_text(const RobotProgram& program, const Problem& problem) {
  return KrlWriter(program, problem).text();
}

}  // namespace wristwise
