#include "bindings.hpp"

namespace wristwise::python {

void bind_pose(py::module_& module) {
  py::enum_<EulerSequence>(module, "EulerSequence",
                           "Order of the three turns about moving axes; the names read R = "
                           "R_first R_second R_third.")
      .value("xyz", EulerSequence::xyz)
      .value("yzx", EulerSequence::yzx)
      .value("zxy", EulerSequence::zxy);

  module.def("euler_angles", &euler_angles, py::arg("rotation"),
             py::arg("sequence") = EulerSequence::xyz,
             "Angles (rad) of a rotation about the axes x, y, z, in this order whatever the "
             "sequence: shape (3,). The second of the sequence is in [-pi/2, pi/2], the others in "
             "(-pi, pi].");
  module.def("rotation_from_euler", &rotation_from_euler, py::arg("angles"),
             py::arg("sequence") = EulerSequence::xyz,
             "The rotation, shape (3, 3), with these angles (rad) about x, y, z.");
  module.def("pose_from_xyz_rpy", &pose_from_xyz_rpy, py::arg("xyz"), py::arg("rpy"),
             "The pose with position xyz (m) and fixed-axis roll, pitch, yaw (rad) as in URDF: "
             "R = Rz(yaw) Ry(pitch) Rx(roll).");
  module.def("wrap_angle", &wrap_angle, py::arg("angle"),
             "The angle in (-pi, pi] that differs from this one by whole turns, rad.");
}

}  // namespace wristwise::python
