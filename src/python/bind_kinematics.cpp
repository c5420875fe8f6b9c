#include "bindings.hpp"
#include "wristwise/kinematics.hpp"

namespace wristwise::python {

namespace {

std::vector<Pose> frames_of(const ChainPose& chain) {
  return {chain.frames.begin(), chain.frames.begin() + chain.joint_count};
}

std::vector<Eigen::Vector3d> axes_of(const ChainPose& chain) {
  return {chain.axes.begin(), chain.axes.begin() + chain.joint_count};
}

ChainPose chain_pose(const Robot& robot, const JointVector& q) {
  expect_joints(robot, q);
  ChainPose chain;
  forward_kinematics(robot, q, chain);
  return chain;
}

void expect_chain_of(const Robot& robot, const ChainPose& chain) {
  if (chain.joint_count != robot.joint_count())
    throw InvalidInput("chain", std::to_string(chain.joint_count) + " joints",
                       "those of the robot");
}

}  // namespace

void bind_kinematics(py::module_& module) {
  py::class_<ChainPose>(module, "ChainPose",
                        "Where every joint of the chain is at one posture, in the base frame.")
      .def_readonly("joint_count", &ChainPose::joint_count, "number of joints")
      .def_property_readonly("frames", &frames_of,
                             "of each joint, after its own motion: shape (joints, 4, 4)")
      .def_property_readonly("axes", &axes_of, "of each joint, unit: shape (joints, 3)")
      .def_readonly("tcp", &ChainPose::tcp, "pose of the TCP")
      .def("__repr__", [](const ChainPose& chain) {
        return "<ChainPose of " + std::to_string(chain.joint_count) + " joints>";
      });

  module.def("forward_kinematics", &chain_pose, py::arg("robot"), py::arg("q"),
             "Where every joint is at a posture (rad or m), shape (joints,).");
  module.def(
      "tcp_pose",
      [](const Robot& robot, const JointVector& q) {
        expect_joints(robot, q);
        return tcp_pose(robot, q);
      },
      py::arg("robot"), py::arg("q"), "Pose of the TCP in the base frame, shape (4, 4).");
  module.def(
      "geometric_jacobian",
      [](const Robot& robot, const ChainPose& chain) {
        expect_chain_of(robot, chain);
        return geometric_jacobian(robot, chain);
      },
      py::arg("robot"), py::arg("chain"),
      "Of the TCP in the base frame, shape (6, joints): rows 0 to 2 linear velocity, 3 to 5 "
      "angular "
      "velocity, per unit joint speed.");
}

}  // namespace wristwise::python
