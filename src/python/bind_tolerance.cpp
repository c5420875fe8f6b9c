#include "bindings.hpp"
#include "wristwise/tolerance.hpp"

namespace wristwise::python {

namespace {

void bind_box(py::module_& module) {
  StructBinding<ToleranceBox>(
      module, "ToleranceBox",
      "How far the TCP may deviate from a waypoint's frame. The deviation is (x, y, z, rx, ry, "
      "rz), m and rad: the position in the tolerance frame, and Euler angles about the moving axes "
      "x, y, z. Frozen; replace() makes another.",
      Access::frozen)
      .field("frame", &ToleranceBox::frame,
             "ToleranceFrame.path: measured in the waypoint's frame; base: along the base axes")
      .field("lower", &ToleranceBox::lower, "shape (6,), m and rad; -inf where a rotation is free")
      .field("upper", &ToleranceBox::upper, "shape (6,), m and rad; inf where a rotation is free")
      .done()
      .def(
          "is_free",
          [](const ToleranceBox& box, int coordinate) {
            expect_index("coordinate", coordinate, 6);
            return box.is_free(coordinate);
          },
          py::arg("coordinate"), "Whether coordinate 0 to 5 is a rotation without bounds.")
      .def("sequence", &ToleranceBox::sequence,
           "The Euler sequence of the box: the free angle comes last, a bounded one in the middle.")
      .def("validate", &ToleranceBox::validate, py::arg("where"),
           "Raises InvalidInput, with `where` in its message, where lower > upper, a position is "
           "unbounded, a rotation is bounded on one side only, or the middle angle's bound is 90 "
           "deg or more.")
      .def("widened", &ToleranceBox::widened, py::arg("position"), py::arg("angle"),
           "The same box, wider by `position` (m) and `angle` (rad) on each side.");
}

}  // namespace

void bind_tolerance(py::module_& module) {
  py::enum_<ToleranceFrame>(module, "ToleranceFrame", "What a tolerance is measured along.")
      .value("path", ToleranceFrame::path, "the waypoint's frame")
      .value("base", ToleranceFrame::base, "the base frame");
  bind_box(module);
  module.def("deviation", &deviation, py::arg("box"), py::arg("path_frame"), py::arg("tcp"),
             "The deviation of a TCP pose from the path frame: shape (6,), m and rad.");
  module.def("pose_at_deviation", &pose_at_deviation, py::arg("box"), py::arg("path_frame"),
             py::arg("deviation"), "The pose that deviates so from the path frame.");
  module.def("box_excess", &box_excess, py::arg("box"), py::arg("deviation"),
             "How far a deviation lies outside the box, coordinate by coordinate, >= 0: shape "
             "(6,), m and rad.");
}

}  // namespace wristwise::python
