#include "python_costs.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "wristwise/error.hpp"

namespace wristwise::python {

namespace {

double checked_cost(const py::object& answer, const char* name, std::size_t index) {
  const double cost = PyFloat_AsDouble(answer.ptr());
  const bool is_number = !(cost == -1 && PyErr_Occurred());
  if (!is_number) PyErr_Clear();
  if (is_number && cost >= 0) return cost;
  throw InvalidInput(
      name,
      "returned " + py::repr(answer).cast<std::string>() + " at index " + std::to_string(index),
      "a number >= 0, or infinity");
}

}  // namespace

double PythonCost::operator()(std::size_t waypoint, const JointVector& q) const {
  const py::gil_scoped_acquire lock;
  return checked_cost(callable.get()(waypoint, q), "vertex_cost", waypoint);
}

double PythonCost::operator()(std::size_t interval, const JointVector& from,
                              const JointVector& to) const {
  const py::gil_scoped_acquire lock;
  return checked_cost(callable.get()(interval, from, to), "edge_cost", interval);
}

double PythonResidual::operator()(double time, const JointVector& q, JointVector* gradient) const {
  const py::gil_scoped_acquire lock;
  const py::object answer = callable.get()(time, q);
  const char* expected = "a pair: a finite number, and its gradient with a finite one per joint";
  try {
    const auto [value, slope] = answer.cast<std::pair<double, JointVector>>();
    if (std::isfinite(value) && slope.size() == q.size() && slope.allFinite()) {
      if (gradient != nullptr) *gradient = slope;
      return value;
    }
  } catch (const py::cast_error&) {
  } catch (const BadArray&) {
  }
  throw InvalidInput("posture_residuals", "returned " + py::repr(answer).cast<std::string>(),
                     expected);
}

}  // namespace wristwise::python
