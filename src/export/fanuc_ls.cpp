// Fanuc TP programs as text (LS). FANUC, R-30iB Operator's Manual (motion instructions, sec and
// msec as feed rates of joint motion) and Arc Tool Operator's Manual (Arc Start, Arc End). J3 and
// J2: ROS-Industrial, fanuc_driver, linkage_transform, J3_out = J3_in - J23_factor * J2_in to the
// robot.

#include <fmt/format.h>

#include "export/controller_axes.hpp"
#include "export/fixed_number.hpp"
#include "export/program_lines.hpp"

namespace wristwise {

namespace {

constexpr double kClockUnit = 1e-3;     // s
constexpr double kLongestMsec = 32;     // s; longer moves are given in sec,
constexpr std::int64_t kSecStep = 100;  // in tenths of a second

class LsWriter {
 public:
  LsWriter(const RobotProgram& program, const Problem& problem)
      : program_(program), options_(problem.exports), axes_(*problem.robot, problem.exports.axes) {}

  std::string text() {
    instruction(fmt::format("  !{} points ;", program_.points.size()));
    instruction(fmt::format("  !off the plan by {:.3f} mm ;", program_.deviation * 1e3));
    instruction(fmt::format("  UFRAME_NUM={} ;", options_.ls.frame));
    instruction(fmt::format("  UTOOL_NUM={} ;", options_.ls.tool));
    instruction(fmt::format("J P[1] {}% FINE    ;", fixed_number(options_.approach_percent, 0)));
    weld(0);
    const std::size_t last = program_.points.size() - 1;
    for (std::size_t i = 1; i <= last; ++i) {
      const std::string stop = i == last ? "FINE" : fmt::format("CNT{}", options_.ls.cnt);
      instruction(fmt::format("J P[{}] {} {}    ;", i + 1, duration(i), stop));
      weld(i);
    }
    return header() + instructions_ + "/POS\n" + positions() + "/END\n";
  }

 private:
  std::string duration(std::size_t i) {
    const double time = program_.points[i].time;
    if (time - program_.points[i - 1].time < kLongestMsec)
      return fmt::format("{}msec", clock_.advance_to(time));
    return fixed_number(static_cast<double>(clock_.advance_to(time, kSecStep)) * kClockUnit, 1) +
           "sec";
  }

  void instruction(const std::string& text) {
    instructions_ += fmt::format("{:4}:{}\n", ++line_count_, text);
  }

  void weld(std::size_t i) {
    if (weld_ends_at(program_, i)) lines(options_.ls.weld_off);
    if (weld_starts_at(program_, i)) lines(options_.ls.weld_on);
  }

  void lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) instruction("  " + line + " ;");
  }

  std::string header() const {
    return fmt::format(
        "/PROG  {}\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"wristwise\";\nPROG_SIZE\t= 0;\n"
        "FILE_NAME\t= ;\nVERSION\t\t= 0;\nLINE_COUNT\t= {};\nMEMORY_SIZE\t= 0;\n"
        "PROTECT\t\t= READ_WRITE;\nTCD:  STACK_SIZE\t= 0,\n      TASK_PRIORITY\t= 50,\n"
        "      TIME_SLICE\t= 0,\n      BUSY_LAMP_OFF\t= 0,\n      ABORT_REQUEST\t= 0,\n"
        "      PAUSE_REQUEST\t= 0;\nDEFAULT_GROUP\t= 1,*,*,*,*;\n"
        "CONTROL_CODE\t= 00000000 00000000;\n/MN\n",
        program_name(ProgramFormat::ls, program_.name), line_count_);
  }

  std::string positions() const {
    std::string text;
    for (std::size_t i = 0; i < program_.points.size(); ++i) {
      text += fmt::format("P[{}]{{\n   GP1:\n\tUF : {}, UT : {},\n", i + 1, options_.ls.frame,
                          options_.ls.tool);
      text += axis_lines(coupled(axes_.values(program_.points[i].joints), options_.ls.j3_coupling));
      text += "};\n";
    }
    return text;
  }

  /// Three to a line.
  std::string axis_lines(const AxisValues& values) const {
    std::string text;
    int count = 0;
    for (std::size_t axis = 0; axis < values.size(); ++axis) {
      if (!axes_.has(axis)) continue;
      if (count > 0) text += count % 3 == 0 ? ",\n" : ",";
      const std::string name = axis < kRobotAxes ? fmt::format("J{}", axis + 1) : axis_name(axis);
      text += fmt::format("\t{}= {:>11} {}", name, fixed_number(values[axis], 4),
                          axes_.slides(axis) ? " mm" : "deg");
      ++count;
    }
    return text + "\n";
  }

  const RobotProgram& program_;
  const ExportOptions& options_;
  ControllerAxes axes_;
  RoundedClock clock_{kClockUnit};
  int line_count_ = 0;
  std::string instructions_;
};

}  // namespace

std::string ls_text(const RobotProgram& program, const Problem& problem) {
  return LsWriter(program, problem).text();
}

}  // namespace wristwise
