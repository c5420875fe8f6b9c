// RAPID. ABB, Technical reference manual, RAPID Instructions, Functions and Data types
// (3HAC16581-1): MoveAbsJ, jointtarget, speeddata, SetDO.

#include <fmt/format.h>

#include "export/controller_axes.hpp"
#include "export/fixed_number.hpp"
#include "export/program_lines.hpp"

namespace wristwise {

namespace {

constexpr double kClockUnit = 1e-4;  // s

std::string axis_list(const AxisValues& values, std::size_t first, std::size_t count,
                      const std::string& missing) {
  std::string text = "[";
  for (std::size_t axis = first; axis < first + count; ++axis) {
    if (axis > first) text += ",";
    text += std::isfinite(values[axis]) ? fixed_number(values[axis], 4) : missing;
  }
  return text + "]";
}

/// An axis that the robot does not have: 0 among the robot's, 9E9 among the external ones.
std::string target(const AxisValues& values) {
  return "[" + axis_list(values, 0, kRobotAxes, "0") + "," +
         axis_list(values, kRobotAxes, kExternalAxes, "9E9") + "]";
}

class RapidWriter {
 public:
  RapidWriter(const RobotProgram& program, const Problem& problem)
      : program_(program), options_(problem.exports), axes_(*problem.robot, problem.exports.axes) {}

  std::string text() {
    const std::string name = program_name(ProgramFormat::rapid, program_.name);
    text_ =
        fmt::format("MODULE {}_mod\n  ! {}\n  PROC {}()\n", name, points_comment(program_), name);
    text_ += fmt::format("    VelSet {},5000;\n", fixed_number(options_.approach_percent, 0));
    move(0, "", "fine");
    text_ += "    VelSet 100,5000;\n";
    weld(0);
    RoundedClock clock(kClockUnit);
    const std::size_t last = program_.points.size() - 1;
    for (std::size_t i = 1; i <= last; ++i) {
      const double seconds =
          static_cast<double>(clock.advance_to(program_.points[i].time)) * kClockUnit;
      move(i, "\\T:=" + fixed_number(seconds, 4), i == last ? "fine" : options_.rapid.zone);
      weld(i);
    }
    return text_ + "  ENDPROC\nENDMODULE\n";
  }

 private:
  void move(std::size_t i, const std::string& time, const std::string& zone) {
    text_ += fmt::format("    MoveAbsJ {}\\NoEOffs,v1000{},{},{}\\WObj:={};\n",
                         target(axes_.values(program_.points[i].joints)), time, zone,
                         options_.rapid.tool, options_.rapid.wobj);
  }

  void weld(std::size_t i) {
    if (weld_ends_at(program_, i)) lines(options_.rapid.weld_off);
    if (weld_starts_at(program_, i)) lines(options_.rapid.weld_on);
  }

  void lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) text_ += "    " + line + "\n";
  }

  const RobotProgram& program_;
  const ExportOptions& options_;
  ControllerAxes axes_;
  std::string text_;
};

}  // namespace

std::string rapid_text(const RobotProgram& program, const Problem& problem) {
  return RapidWriter(program, problem).text();
}

}  // namespace wristwise
