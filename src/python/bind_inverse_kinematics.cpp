#include "bindings.hpp"
#include "python_inverse_kinematics.hpp"
#include "wristwise/ikfast_inverse_kinematics.hpp"
#include "wristwise/numeric_inverse_kinematics.hpp"

namespace wristwise::python {

namespace {

using Branches = std::vector<JointVector>;

void bind_interface(py::module_& module) {
  StructBinding<ToleranceSample>(
      module, "ToleranceSample",
      "A sample of a tolerance box, and the part of the box that it stands for. Frozen.",
      Access::frozen)
      .field("box", &ToleranceSample::box, "ToleranceBox")
      .field("path_frame", &ToleranceSample::path_frame, "of the waypoint, in base")
      .field("deviation", &ToleranceSample::deviation, "of the sample, shape (6,), m and rad")
      .field("lower", &ToleranceSample::lower, "of the part, shape (6,), m and rad")
      .field("upper", &ToleranceSample::upper, "of the part, shape (6,), m and rad")
      .done();
  py::class_<InverseKinematics, PythonInverseKinematics, std::shared_ptr<InverseKinematics>>(
      module, "InverseKinematics",
      "All postures that bring the TCP to a pose. Subclass it, define solve() and put an instance "
      "into Problem.inverse_kinematics to bring your own. The planner calls it from several "
      "threads, one at a time; what it raises comes out of plan().")
      .def(py::init<>())
      .def(
          "solve",
          [](const InverseKinematics& self, const Pose& tcp) {
            const py::gil_scoped_release unlocked;
            Branches branches;
            self.solve(tcp, branches);
            return branches;
          },
          py::arg("tcp"),
          "Every distinct solution, rad or m, shape (solutions, joints): revolute joints in "
          "(-pi, pi], whether or not inside the joint limits, in a fixed order. Empty: out of "
          "reach.")
      .def(
          "solve_beside",
          [](const InverseKinematics& self, const Pose& tcp, const JointVector& posture) {
            Branches branches;
            self.solve_beside(tcp, posture, branches);
            return branches;
          },
          py::arg("tcp"), py::arg("posture"),
          "As solve(); where joints are sampled, with their values of this posture, shape "
          "(joints,), in place of the samples.")
      .def(
          "samples", [](const InverseKinematics& self) { return self.samples(); },
          "Combinations of samples of joints to spare, for each of which a pose is solved.")
      .def(
          "meets_every_pose", [](const InverseKinematics& self) { return self.meets_every_pose(); },
          "False for a chain that can't move its TCP in all six directions: solve_near() is asked.")
      .def(
          "solve_near",
          [](const InverseKinematics& self, const ToleranceSample& sample) {
            Branches branches;
            self.solve_near(sample, branches);
            return branches;
          },
          py::arg("sample"),
          "As solve(), for the sample; where that is out of reach, for any pose in the part of the "
          "box that it stands for. By default the sample alone.")
      .def(
          "description", [](const InverseKinematics& self) { return self.description(); },
          "One line for people. By default the name of the class.");
}

void bind_numeric(py::module_& module) {
  StructBinding<NumericIkOptions>(
      module, "NumericIkOptions",
      "How many starts the numeric inverse kinematics makes, and what it takes for two solutions.",
      Access::writable)
      .field("postures", &NumericIkOptions::postures, "of the table of starts, at most")
      .field("neighbours", &NumericIkOptions::neighbours,
             "postures of the table that are looked at for a pose")
      .field("vain_starts", &NumericIkOptions::vain_starts,
             "in a row, without a new solution, after which the search ends")
      .field("separation", &NumericIkOptions::separation,
             "rad or m; of a continuum, solutions that differ by less in every joint are one")
      .field("most_of_continuum", &NumericIkOptions::most_of_continuum,
             "solutions, where there is a continuum of them")
      .field("box_poses", &NumericIkOptions::box_poses,
             "poses of a tolerance box from which postures are led into it")
      .done();
  py::class_<NumericInverseKinematics, InverseKinematics,
             std::shared_ptr<NumericInverseKinematics>>(
      module, "NumericInverseKinematics",
      "Inverse kinematics of any chain, without a closed form. Thread-safe.")
      .def(py::init([](const std::shared_ptr<Robot>& robot, const NumericIkOptions& options) {
             return std::make_shared<NumericInverseKinematics>(shared(robot, "robot"), options);
           }),
           py::arg("robot"), py::arg("options") = NumericIkOptions(),
           "Raises InvalidInput for options that are not positive.");
}

void bind_found(py::module_& module) {
  py::class_<InverseKinematicsFound>(module, "InverseKinematicsFound",
                                     "What a search for a solver has found.")
      .def_property_readonly(
          "solver", [](const InverseKinematicsFound& found) { return object_of(found.solver); },
          "InverseKinematics; None where nothing fits")
      .def_readonly("description", &InverseKinematicsFound::description,
                    "what was found, or why nothing fits")
      .def("__repr__", [](const InverseKinematicsFound& found) {
        return "<InverseKinematicsFound: " + found.description + ">";
      });
}

}  // namespace

void bind_inverse_kinematics(py::module_& module) {
  bind_interface(module);
  bind_numeric(module);
  bind_found(module);
  module.def(
      "find_closed_form",
      [](const std::shared_ptr<Robot>& robot, double misfit) {
        return find_closed_form(shared(robot, "robot"), misfit);
      },
      py::arg("robot"), py::arg("misfit") = 1e-3,
      "The closed form of a six-axis arm, from the geometry of the chain; misfit in m and rad.");
  module.def(
      "find_inverse_kinematics",
      [](const std::shared_ptr<Robot>& robot, double misfit) {
        return find_inverse_kinematics(shared(robot, "robot"), misfit);
      },
      py::arg("robot"), py::arg("misfit") = 1e-3,
      "The closed form, or else the numeric solver of any chain, with the reason.");
  module.def(
      "load_ikfast",
      [](const std::shared_ptr<Robot>& robot, const std::filesystem::path& file,
         const JointSteps& steps) {
        return object_of(IkFastInverseKinematics::load(shared(robot, "robot"), file, steps));
      },
      py::arg("robot"), py::arg("file"), py::arg("steps") = JointSteps(),
      "An InverseKinematics from a shared object that IKFast generated; steps (rad or m) of its "
      "free joints by name. Raises InvalidInput where the file is missing or for another robot.");
}

}  // namespace wristwise::python
