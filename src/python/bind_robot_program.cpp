#include "bindings.hpp"
#include "wristwise/robot_program.hpp"

namespace wristwise::python {

namespace {

/// `function` of something and a problem that has a robot.
template <class Result, class Given>
auto of_robot(Result (*function)(Given, const Problem&)) {
  return [function](Given given, const Problem& problem) {
    expect_robot(problem);
    return function(given, problem);
  };
}

void bind_program(py::module_& module) {
  py::enum_<ProgramFormat>(module, "ProgramFormat", "What a trajectory can be written as.")
      .value("krl", ProgramFormat::krl, "KUKA: <name>.src")
      .value("rapid", ProgramFormat::rapid, "ABB: <name>.mod")
      .value("ls", ProgramFormat::ls, "Fanuc: <name>.ls")
      .value("trajectory_msgs", ProgramFormat::trajectory_msgs, "ROS: joint_trajectory.yaml")
      .value("moveit", ProgramFormat::moveit, "MoveIt: robot_trajectory.yaml");
  StructBinding<ProgramPoint>(module, "ProgramPoint", "A point of a program. Frozen.",
                              Access::frozen)
      .field("time", &ProgramPoint::time, "s, from the first point")
      .field("joints", &ProgramPoint::joints, "rad or m, shape (joints,)")
      .field("welding", &ProgramPoint::welding, "on the move that ends here")
      .done(false);
  StructBinding<RobotProgram>(
      module, "RobotProgram",
      "A motion as robot controllers take it: joint-space moves at constant "
      "rates from point to point. Frozen.",
      Access::frozen)
      .field("name", &RobotProgram::name, "as in the problem")
      .field("points", &RobotProgram::points, "ProgramPoint")
      .field("deviation", &RobotProgram::deviation,
             "m, the farthest that the moves take the TCP from the curve")
      .field("angle_deviation", &RobotProgram::angle_deviation, "rad, likewise")
      .done(false);
}

}  // namespace

void bind_robot_program(py::module_& module) {
  bind_program(module);
  const py::arg result("result"), program("program"), problem("problem");
  module.def("robot_program", of_robot(&robot_program), result, problem,
             "The plan as a program: its points, or its curve thinned as problem.exports say. "
             "Raises InvalidInput where there is nothing to export.");
  module.def("krl_text", of_robot(&krl_text), program, problem,
             "The program as text of a KUKA controller.");
  module.def("rapid_text", of_robot(&rapid_text), program, problem,
             "The program as text of an ABB controller.");
  module.def("ls_text", of_robot(&ls_text), program, problem,
             "The program as text of a Fanuc controller.");
  module.def("joint_trajectory_text", of_robot(&joint_trajectory_text), result, problem,
             "The plan as trajectory_msgs/JointTrajectory, as ROS 2 prints messages.");
  module.def("robot_trajectory_text", of_robot(&robot_trajectory_text), result, problem,
             "The plan as moveit_msgs/RobotTrajectory, as ROS 2 prints messages.");
  module.def("check_export", of_robot(&check_export), py::arg("format"), problem,
             "Raises InvalidInput where a format cannot take this robot with these options.");
  module.def(
      "write_program",
      [](ProgramFormat format, const std::filesystem::path& folder, const PlanResult& plan,
         const Problem& of) {
        expect_robot(of);
        return write_program(format, folder, plan, of);
      },
      py::arg("format"), py::arg("folder"), result, problem,
      "Writes the program where the plan is solved. Returns the file; None where it is not.");
}

}  // namespace wristwise::python
