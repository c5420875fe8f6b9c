#include "bindings.hpp"
#include "wristwise/trajectory.hpp"

namespace pybind11::detail {

/// Only towards Python.
template <>
struct type_caster<wristwise::Trajectory::Polynomials> {
  static constexpr auto name = const_name("Array[joints, 6]");
  static handle cast(const wristwise::Trajectory::Polynomials& rows, return_value_policy, handle) {
    return wristwise::python::matrix_to_numpy(rows).release();
  }
};

}  // namespace pybind11::detail

namespace wristwise::python {

namespace {

void expect_curve(const Trajectory& trajectory) {
  if (trajectory.empty()) throw InvalidInput("trajectory", "empty", "one with pieces");
}

void expect_derivative(int derivative, int highest) {
  expect_index("derivative", derivative, static_cast<std::size_t>(highest) + 1);
}

void expect_piece(const Trajectory& trajectory, std::size_t piece) {
  expect_curve(trajectory);
  expect_index("piece", static_cast<long long>(piece), trajectory.times().size() - 1);
}

void bind_path(py::module_& module) {
  StructBinding<JointPath>(
      module, "JointPath",
      "Joint positions at given times, taken as joined by straight joint-space moves. Frozen.",
      Access::frozen)
      .field("times", &JointPath::times, "s, strictly increasing, shape (N,)")
      .field("positions", &JointPath::positions, "rad or m, shape (N, joints)")
      .checked([](const JointPath& path) {
        if (path.times.size() != path.positions.size())
          throw InvalidInput("JointPath",
                             std::to_string(path.times.size()) + " times and " +
                                 std::to_string(path.positions.size()) + " positions",
                             "as many positions as times");
      })
      .done()
      .def("__len__", &JointPath::size);
}

void bind_curve(py::module_& module) {
  using Rows = std::vector<JointVector>;
  py::class_<Trajectory>(module, "Trajectory",
                         "A piecewise quintic through positions, velocities and accelerations at "
                         "given times. Immutable; len() is the number of times.")
      .def(py::init<>(), "An empty one.")
      .def(py::init<std::vector<double>, Rows, Rows, Rows>(), py::arg("times"),
           py::arg("positions"), py::arg("velocities"), py::arg("accelerations"),
           "Times (s) of shape (N,), the others of shape (N, joints). Raises InvalidInput for "
           "fewer than two times, times that do not increase, or sizes that differ.")
      .def("__len__", [](const Trajectory& self) { return self.times().size(); })
      .def("__repr__",
           [](const Trajectory& self) {
             return "<Trajectory at " + std::to_string(self.times().size()) + " times>";
           })
      .def_property_readonly("times", &Trajectory::times, "s, shape (N,)")
      .def_property_readonly("positions", &Trajectory::positions, "rad or m, shape (N, joints)")
      .def_property_readonly("velocities", &Trajectory::velocities,
                             "rad/s or m/s, shape (N, joints)")
      .def_property_readonly("accelerations", &Trajectory::accelerations,
                             "rad/s^2 or m/s^2, shape (N, joints)")
      .def("waypoints", &Trajectory::waypoints, "Its times and positions as a JointPath.")
      .def(
          "evaluate",
          [](const Trajectory& self, double t, int derivative) {
            expect_curve(self);
            expect_derivative(derivative, 5);
            return self.evaluate(t, derivative);
          },
          py::arg("t"), py::arg("derivative") = 0,
          "The derivative of order 0 to 5 at time t (s), held at the ends outside: shape "
          "(joints,).")
      .def(
          "sample",
          [](const Trajectory& self, const std::vector<double>& times, int derivative) {
            expect_curve(self);
            expect_derivative(derivative, 5);
            Rows rows;
            for (const double t : times) rows.push_back(self.evaluate(t, derivative));
            return rows;
          },
          py::arg("times"), py::arg("derivative") = 0,
          "evaluate() at many times (s), shape (N,): shape (N, joints).")
      .def(
          "extremes",
          [](const Trajectory& self, std::size_t piece, int derivative) {
            expect_piece(self, piece);
            expect_derivative(derivative, 3);
            std::pair<JointVector, JointVector> range;
            self.extremes(piece, derivative, range.first, range.second);
            return range;
          },
          py::arg("piece"), py::arg("derivative"),
          "The least and the largest value of each joint's derivative of order 0 to 3 over "
          "[times[piece], times[piece + 1]]: two arrays of shape (joints,).")
      .def(
          "polynomials",
          [](const Trajectory& self, std::size_t piece) {
            expect_piece(self, piece);
            return self.polynomials(piece);
          },
          py::arg("piece"),
          "The piece in powers of s, which runs from -1 to 1 over it: shape (joints, 6), column k "
          "the coefficient of the k-th power.")
      .def(py::pickle(
          [](const Trajectory& self) {
            return py::make_tuple(self.times(), self.positions(), self.velocities(),
                                  self.accelerations());
          },
          [](const py::tuple& state) {
            const auto times = state[0].cast<std::vector<double>>();
            if (times.empty()) return Trajectory();
            return Trajectory(times, state[1].cast<Rows>(), state[2].cast<Rows>(),
                              state[3].cast<Rows>());
          }));
}

}  // namespace

void bind_trajectory(py::module_& module) {
  bind_path(module);
  bind_curve(module);
  module.def(
      "divided_differences",
      [](const JointPath& path, int order) {
        if (order < 1 || order > 3) throw InvalidInput("order", std::to_string(order), "1, 2 or 3");
        return divided_differences(path, order);
      },
      py::arg("path"), py::arg("order"),
      "Divided differences of order k (1, 2, 3) over uneven times, an estimate of the k-th "
      "derivative: shape (N - k, joints).");
}

}  // namespace wristwise::python
