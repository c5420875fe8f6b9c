#pragma once

#include <memory>
#include <string>
#include <vector>

#include "array_casters.hpp"
#include "wristwise/inverse_kinematics.hpp"

namespace wristwise::python {

/// A Python subclass of InverseKinematics as C++ sees it. Takes the interpreter lock.
class PythonInverseKinematics : public InverseKinematics {
 public:
  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override;
  void solve_beside(const Pose& tcp, const JointVector& posture,
                    std::vector<JointVector>& branches) const override;
  std::size_t samples() const override;
  bool meets_every_pose() const override;
  void solve_near(const ToleranceSample& sample, std::vector<JointVector>& branches) const override;
  std::string description() const override;
};

/// The solver behind a Python object, which lives as long as the solver is used; null for None.
/// @throws TypeError where it is no InverseKinematics
std::shared_ptr<const InverseKinematics> solver_of(const py::object& object);
/// The Python object of a solver; None for null.
py::object object_of(const std::shared_ptr<const InverseKinematics>& solver);

}  // namespace wristwise::python
