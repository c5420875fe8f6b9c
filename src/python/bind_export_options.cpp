#include "bindings.hpp"
#include "wristwise/export_options.hpp"
#include "wristwise/program_file.hpp"

namespace wristwise::python {

namespace {

void bind_languages(py::handle options) {
  StructBinding<ExportOptions::Krl>(options, "Krl", "KUKA.", Access::writable)
      .field("tool", &ExportOptions::Krl::tool, "TOOL_DATA number")
      .field("base", &ExportOptions::Krl::base, "BASE_DATA number")
      .field("weld_on", &ExportOptions::Krl::weld_on, "one statement")
      .field("weld_off", &ExportOptions::Krl::weld_off, "one statement")
      .done();
  StructBinding<ExportOptions::Rapid>(options, "Rapid", "ABB.", Access::writable)
      .field("tool", &ExportOptions::Rapid::tool, "tooldata")
      .field("wobj", &ExportOptions::Rapid::wobj, "wobjdata")
      .field("zone", &ExportOptions::Rapid::zone, "at all points but the last")
      .field("weld_on", &ExportOptions::Rapid::weld_on, "statements")
      .field("weld_off", &ExportOptions::Rapid::weld_off, "statements")
      .done();
  StructBinding<ExportOptions::Ls>(options, "Ls", "Fanuc.", Access::writable)
      .field("tool", &ExportOptions::Ls::tool, "UTOOL_NUM")
      .field("frame", &ExportOptions::Ls::frame, "UFRAME_NUM")
      .field("cnt", &ExportOptions::Ls::cnt, "0 to 100, at all points but the last")
      .field("j3_coupling", &ExportOptions::Ls::j3_coupling,
             "J3 on the controller = J3 + j3_coupling * J2")
      .field("weld_on", &ExportOptions::Ls::weld_on, "instructions")
      .field("weld_off", &ExportOptions::Ls::weld_off, "instructions")
      .done();
}

}  // namespace

void bind_export_options(py::module_& module) {
  StructBinding<ControllerAxis>(
      module, "ControllerAxis",
      "Where a joint is on the controller: axis value = sign * joint value + offset, in deg or mm. "
      "Frozen.",
      Access::frozen)
      .field("number", &ControllerAxis::number, "0 to 5: axes 1 to 6; 6 to 11: E1 to E6")
      .field("sign", &ControllerAxis::sign, "1 or -1")
      .field("offset", &ControllerAxis::offset, "rad or m")
      .done();
  StructBinding<ExportOptions> options(module, "ExportOptions",
                                       "How a trajectory becomes a program of a robot controller.",
                                       Access::writable);
  bind_languages(options.python_class());
  options.field("name", &ExportOptions::name, "of the program; empty: that of the problem")
      .field("axes", &ExportOptions::axes, "ControllerAxis, one for each joint; empty: by type")
      .field("max_deviation", &ExportOptions::max_deviation, "m, within which points are left out")
      .field("max_angle_deviation", &ExportOptions::max_angle_deviation,
             "rad, within which points are left out")
      .field("period", &ExportOptions::period, "s; given: a point every period instead")
      .field("approach_percent", &ExportOptions::approach_percent,
             "of the joint speeds, on the way to the first point; 1 to 100")
      .field("weld", &ExportOptions::weld, "False: no commands to weld")
      .field("krl", &ExportOptions::krl, "KUKA")
      .field("rapid", &ExportOptions::rapid, "ABB")
      .field("ls", &ExportOptions::ls, "Fanuc")
      .done();
  module.def(
      "read_joint_path", &read_joint_path, py::arg("file"), py::arg("robot"),
      py::arg("options") = ExportOptions(), py::arg("start_time") = 0.0,
      "Reads a joint path by the file's extension: a program of a KUKA (.src), an ABB (.mod, "
      ".prg) or a Fanuc (.ls), a message of ROS (.yaml), or else a trajectory.csv. The first "
      "target of a program is at start_time (s). Raises InvalidInput with file and line.");
}

}  // namespace wristwise::python
