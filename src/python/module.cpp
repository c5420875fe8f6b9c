#include <utility>

#include "bindings.hpp"
#include "wristwise/error.hpp"

namespace wristwise::python {

namespace {

constexpr const char* kDoc =
    R"(Planner for arc-welding robots: a weld seam in, a smooth, collision-free, verified joint trajectory out.

Units are m, rad and s. Poses are 4 x 4 matrices [[R, p], [0, 0, 0, 1]] in the base frame, unless said
otherwise. Arrays that are attributes or results are copies, and read-only; array-likes are taken.)";

constexpr const char* kInvalidInputDoc =
    "Input that cannot be used: an unknown key, a missing file, NaN, inverted bounds, an array of "
    "another shape. One line: what is wrong, where, and what is expected.";

void translate_bad_array(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const BadArray& bad) {
    const py::object type = py::module_::import("wristwise._wristwise").attr("InvalidInput");
    PyErr_SetString(type.ptr(), InvalidInput("array", bad.problem, bad.expected).what());
  }
}

}  // namespace

void expect_joints(const Robot& robot, const JointVector& q) {
  if (q.size() != robot.joint_count())
    throw InvalidInput("joint values", std::to_string(q.size()),
                       std::to_string(robot.joint_count()) + ", one for each joint");
}

void expect_robot(const Problem& problem) {
  if (!problem.robot) throw InvalidInput("problem.robot", "None", "a Robot");
}

void expect_index(const char* where, long long index, std::size_t count) {
  if (index < 0 || static_cast<unsigned long long>(index) >= count)
    throw InvalidInput(where, std::to_string(index), "0 to less than " + std::to_string(count));
}

}  // namespace wristwise::python

PYBIND11_MODULE(_wristwise, module) {
  using namespace wristwise::python;
  module.doc() = kDoc;
  module.attr("__version__") = WRISTWISE_VERSION;
  // What people see and pickle stores is the package.
  const py::object own_name = module.attr("__name__");
  module.attr("__name__") = "wristwise";
  py::register_exception<wristwise::InvalidInput>(module, "InvalidInput", PyExc_ValueError);
  module.attr("InvalidInput").attr("__doc__") = kInvalidInputDoc;
  py::register_exception_translator(&translate_bad_array);
  bind_pose(module);
  bind_tolerance(module);
  bind_geometry(module);
  bind_robot(module);
  bind_kinematics(module);
  bind_inverse_kinematics(module);
  bind_scene(module);
  bind_clearance(module);
  bind_trajectory(module);
  bind_seam(module);
  bind_seam_description(module);
  bind_trajectory_file(module);
  bind_options(module);
  bind_export_options(module);
  bind_problem(module);
  bind_verification(module);
  bind_statistics(module);
  bind_result(module);
  bind_plan(module);
  bind_smoothing(module);
  bind_placement(module);
  bind_robot_program(module);
  module.attr("__name__") = own_name;
}
