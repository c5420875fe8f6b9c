#include "python_inverse_kinematics.hpp"

#include "python_reference.hpp"
#include "wristwise/error.hpp"

namespace wristwise::python {

namespace {

py::function override_of(const InverseKinematics* self, const char* method) {
  return py::get_override(self, method);
}

std::vector<JointVector> branches_of(const py::object& answer, const char* method) {
  try {
    if (py::isinstance<py::sequence>(answer) && py::len(answer) == 0) return {};
    return joint_vectors(answer);
  } catch (const BadArray& bad) {
    throw InvalidInput(std::string("InverseKinematics.") + method, "returned " + bad.problem,
                       bad.expected + ", one row for each solution");
  }
}

}  // namespace

void PythonInverseKinematics::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  const py::gil_scoped_acquire lock;
  const py::function own = override_of(this, "solve");
  if (!own) {
    PyErr_SetString(PyExc_NotImplementedError, "InverseKinematics.solve: to be defined");
    throw py::error_already_set();
  }
  branches = branches_of(own(tcp), "solve");
}

void PythonInverseKinematics::solve_beside(const Pose& tcp, const JointVector& posture,
                                           std::vector<JointVector>& branches) const {
  const py::gil_scoped_acquire lock;
  const py::function own = override_of(this, "solve_beside");
  if (!own) return InverseKinematics::solve_beside(tcp, posture, branches);
  branches = branches_of(own(tcp, posture), "solve_beside");
}

std::size_t PythonInverseKinematics::samples() const {
  const py::gil_scoped_acquire lock;
  const py::function own = override_of(this, "samples");
  return own ? own().cast<std::size_t>() : InverseKinematics::samples();
}

bool PythonInverseKinematics::meets_every_pose() const {
  const py::gil_scoped_acquire lock;
  const py::function own = override_of(this, "meets_every_pose");
  return own ? own().cast<bool>() : InverseKinematics::meets_every_pose();
}

void PythonInverseKinematics::solve_near(const ToleranceSample& sample,
                                         std::vector<JointVector>& branches) const {
  const py::gil_scoped_acquire lock;
  const py::function own = override_of(this, "solve_near");
  if (!own) return InverseKinematics::solve_near(sample, branches);
  branches = branches_of(own(sample), "solve_near");
}

std::string PythonInverseKinematics::description() const {
  const py::gil_scoped_acquire lock;
  const py::function own = override_of(this, "description");
  if (own) return py::str(own());
  const InverseKinematics* self = this;
  return py::str(py::type::of(py::cast(self)).attr("__qualname__"));
}

std::shared_ptr<const InverseKinematics> solver_of(const py::object& object) {
  if (object.is_none()) return nullptr;
  if (!py::isinstance<InverseKinematics>(object))
    throw py::type_error("inverse_kinematics: " + py::repr(object).cast<std::string>() +
                         "; expected an InverseKinematics or None");
  const auto* solver = object.cast<const InverseKinematics*>();
  return {solver, [keep = PythonReference(object)](const InverseKinematics*) {}};
}

py::object object_of(const std::shared_ptr<const InverseKinematics>& solver) {
  return py::cast(std::const_pointer_cast<InverseKinematics>(solver));
}

}  // namespace wristwise::python
