#pragma once

// The module, concept by concept. What a signature names is bound before it.

#include <pybind11/pybind11.h>

#include "struct_binding.hpp"
#include "wristwise/problem.hpp"

namespace wristwise::python {

void bind_pose(py::module_& module);
void bind_tolerance(py::module_& module);
void bind_geometry(py::module_& module);
void bind_robot(py::module_& module);
void bind_kinematics(py::module_& module);
void bind_inverse_kinematics(py::module_& module);
void bind_scene(py::module_& module);
void bind_clearance(py::module_& module);
void bind_trajectory(py::module_& module);
void bind_seam(py::module_& module);
void bind_task(py::module_& module);
void bind_seam_description(py::module_& module);
void bind_trajectory_file(py::module_& module);
void bind_options(py::module_& module);
void bind_export_options(py::module_& module);
void bind_problem(py::module_& module);
void bind_verification(py::module_& module);
void bind_statistics(py::module_& module);
void bind_result(py::module_& module);
void bind_plan(py::module_& module);
void bind_smoothing(py::module_& module);
void bind_placement(py::module_& module);
void bind_robot_program(py::module_& module);

/// @throws InvalidInput for another number of joint values than the robot has joints
void expect_joints(const Robot& robot, const JointVector& q);
/// @throws InvalidInput unless 0 <= index < count; `where` names it
void expect_index(const char* where, long long index, std::size_t count);

/// @throws InvalidInput for a problem without a robot
void expect_robot(const Problem& problem);

/// As C++ shares it. @throws InvalidInput for null
template <class T>
std::shared_ptr<const T> shared(const std::shared_ptr<T>& object, const char* where) {
  if (!object) throw InvalidInput(where, "None", "an object");
  return object;
}

}  // namespace wristwise::python
