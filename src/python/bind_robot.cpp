#include "bindings.hpp"
#include "wristwise/urdf.hpp"

namespace wristwise::python {

namespace {

void bind_parts(py::module_& module, py::class_<Robot, std::shared_ptr<Robot>>& robot) {
  StructBinding<Joint>(module, "Joint", "A movable joint of the chain. Frozen.", Access::frozen)
      .field("name", &Joint::name, "as in the URDF")
      .field("type", &Joint::type, "revolute, continuous or prismatic")
      .field("origin", &Joint::origin, "pose at zero, in the previous joint's frame")
      .field("axis", &Joint::axis, "unit vector in the joint's own frame, shape (3,)")
      .field("lower", &Joint::lower, "rad or m; -inf if continuous")
      .field("upper", &Joint::upper, "rad or m; inf if continuous")
      .field("max_velocity", &Joint::max_velocity, "rad/s or m/s")
      .field("max_acceleration", &Joint::max_acceleration, "rad/s^2 or m/s^2; inf where unknown")
      .field("max_jerk", &Joint::max_jerk, "rad/s^3 or m/s^3; inf where unknown")
      .done();
  StructBinding<Link>(module, "Link",
                      "A link with collision shapes, fixed to the joint that moves it. Frozen.",
                      Access::frozen)
      .field("name", &Link::name, "as in the URDF")
      .field("joint", &Link::joint, "index into joints; -1: fixed to the chain's first link")
      .field("pose", &Link::pose, "of the link, in that joint's frame (base frame for -1)")
      .field("collision", &Link::collision, "Shape, with poses in the link frame")
      .done();
  StructBinding<Robot::Parts>(robot, "Parts", "What a Robot is made of.", Access::writable)
      .field("name", &Robot::Parts::name, "of the robot")
      .field("base_link", &Robot::Parts::base_link, "stands still; objects are placed in it")
      .field("tip_link", &Robot::Parts::tip_link, "the last link")
      .field("joints", &Robot::Parts::joints, "Joint, from the base to the tip")
      .field("links", &Robot::Parts::links, "Link")
      .field("tcp", &Robot::Parts::tcp, "pose of the TCP, in the last joint's frame")
      .field("adjacent_links", &Robot::Parts::adjacent_links,
             "pairs of indices into links that a joint connects directly")
      .field("warnings", &Robot::Parts::warnings, "what the reader should know")
      .field("part_link", &Robot::Parts::part_link, "carries the part; empty: the base link")
      .done();
}

void bind_class(py::class_<Robot, std::shared_ptr<Robot>>& robot) {
  robot
      .def(py::init<Robot::Parts>(), py::arg("parts"),
           "Raises InvalidInput for no joints, too many, NaN, zero axes or inverted limits.")
      .def_property_readonly("joint_count", &Robot::joint_count, "number of movable joints")
      .def_property_readonly("parts", &Robot::parts, py::return_value_policy::copy,
                             "a copy of what it is made of")
      .def_property_readonly("name", &Robot::name, "of the robot")
      .def_property_readonly("base_link", &Robot::base_link, "the link that stands still")
      .def_property_readonly("tip_link", &Robot::tip_link, "the last link")
      .def_property_readonly("part_link", &Robot::part_link, "the chain's first link")
      .def_property_readonly("joints", &Robot::joints, "Joint, from the base to the tip")
      .def_property_readonly("links", &Robot::links, "Link")
      .def_property_readonly("tcp", &Robot::tcp, "pose of the TCP, in the last joint's frame")
      .def_property_readonly("warnings", &Robot::warnings, "one line each")
      .def_property_readonly("lower_limits", &Robot::lower_limits, "rad or m, shape (joints,)")
      .def_property_readonly("upper_limits", &Robot::upper_limits, "rad or m, shape (joints,)")
      .def_property_readonly("velocity_limits", &Robot::velocity_limits,
                             "rad/s or m/s, shape (joints,)")
      .def_property_readonly("acceleration_limits", &Robot::acceleration_limits,
                             "rad/s^2 or m/s^2, shape (joints,); inf where unknown")
      .def_property_readonly("jerk_limits", &Robot::jerk_limits,
                             "rad/s^3 or m/s^3, shape (joints,); inf where unknown")
      .def("__repr__",
           [](const Robot& self) {
             return "<Robot " + self.name() + ", " + self.part_link() + " to " + self.tip_link() +
                    ", " + std::to_string(self.joint_count()) + " joints>";
           })
      .def(py::pickle([](const Robot& self) { return py::make_tuple(self.parts()); },
                      [](const py::tuple& state) {
                        return std::make_shared<Robot>(state[0].cast<Robot::Parts>());
                      }));
}

void bind_source(py::module_& module) {
  StructBinding<RobotSource>(module, "RobotSource", "Where a robot is read from.", Access::writable)
      .field("urdf", &RobotSource::urdf, "file")
      .field("base_link", &RobotSource::base_link, "stands still; empty: the root of the tree")
      .field("tip_link", &RobotSource::tip_link,
             "empty: the leaf with the longest chain of movable joints")
      .field("tool", &RobotSource::tool, "pose of the TCP in tip_link")
      .field("limits", &RobotSource::limits, "MoveIt's joint_limits.yaml; None: what the URDF says")
      .field("srdf", &RobotSource::srdf, "for `group` and warnings; None: none")
      .field("group", &RobotSource::group, "of the SRDF: gives base_link and tip_link")
      .field("packages", &RobotSource::packages,
             "folders searched for package://, before ROS_PACKAGE_PATH")
      .field("require_velocity_limits", &RobotSource::require_velocity_limits,
             "False for a first look at a description")
      .field("read_collision_shapes", &RobotSource::read_collision_shapes,
             "False: links have none, meshes may be missing")
      .field("part_link", &RobotSource::part_link,
             "carries the part: the chain runs from it to the tip; empty: base_link")
      .field("visual_as_collision", &RobotSource::visual_as_collision,
             "links without collision shapes take their visual ones")
      .field("meshes", &RobotSource::meshes, "MeshOptions for the links")
      .done();
}

}  // namespace

void bind_robot(py::module_& module) {
  py::enum_<JointType>(module, "JointType", "How a joint moves.")
      .value("revolute", JointType::revolute)
      .value("continuous", JointType::continuous)
      .value("prismatic", JointType::prismatic);
  py::class_<Robot, std::shared_ptr<Robot>> robot(
      module, "Robot",
      "A serial chain with its limits and collision geometry, from the link that carries the part "
      "to the TCP. Immutable. *Base frame* means the frame of the chain's first link.");
  bind_parts(module, robot);
  bind_class(robot);
  bind_source(module);
  module.def(
      "load_robot",
      [](const RobotSource& source) {
        const RobotSource copy = source;
        const py::gil_scoped_release unlocked;
        return std::make_shared<Robot>(load_robot(copy));
      },
      py::arg("source"),
      "Reads a serial chain from a URDF. Raises InvalidInput for a missing or malformed file, no "
      "such link, group or chain, a joint without limits, or a mesh that cannot be read.");
  module.def("load_disabled_collisions", &load_disabled_collisions, py::arg("srdf"),
             py::arg("robot"), "The pairs of the robot's links that an SRDF says need no check.");
}

}  // namespace wristwise::python
