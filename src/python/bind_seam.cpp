#include "bindings.hpp"
#include "wristwise/seam.hpp"

namespace wristwise::python {

namespace {

void expect_pieces(const Seam& seam) {
  if (seam.pieces().empty()) throw InvalidInput("seam", "no pieces", "at least one");
}

/// `f` of a seam that has pieces.
template <class F>
auto of_pieces(const F& f) {
  return [f](const Seam& seam) {
    expect_pieces(seam);
    return f(seam);
  };
}
template <class F>
auto of_pieces_at(const F& f) {
  return [f](const Seam& seam, double t) {
    expect_pieces(seam);
    return f(seam, t);
  };
}

void bind_piece(py::module_& module) {
  py::class_<SeamCurve, std::shared_ptr<SeamCurve>>(
      module, "SeamCurve", "A rounded corner, a run-in or a run-out, as a problem file makes them.")
      .def("length", &SeamCurve::length, "m, of the TCP's path.")
      .def("frame_at", &SeamCurve::frame_at, py::arg("fraction"),
           "In the base frame, at a share of its time, 0 to 1.");
  StructBinding<SeamPiece> piece(module, "SeamPiece",
                                 "One piece of the nominal TCP path, run in a given time. Frozen.",
                                 Access::frozen);
  py::enum_<SeamPiece::Kind>(piece.python_class(), "Kind", "What a piece is.")
      .value("line", SeamPiece::Kind::line, "straight, turning at a constant rate about one axis")
      .value("arc", SeamPiece::Kind::arc, "the first pose turned rigidly about an axis")
      .value("move", SeamPiece::Kind::move, "to or from a joint waypoint: no path is prescribed")
      .value("curve", SeamPiece::Kind::curve, "a rounded corner, a run-in or a run-out");
  piece.field("kind", &SeamPiece::kind, "SeamPiece.Kind")
      .field("from_", &SeamPiece::from, "first pose")
      .field("to", &SeamPiece::to, "last pose")
      .field("center", &SeamPiece::center, "arc: a point on its axis, m, shape (3,)")
      .field("axis", &SeamPiece::axis, "arc: unit, shape (3,)")
      .field("angle", &SeamPiece::angle, "arc: rad, right-handed")
      .field(
          "curve",
          [](const SeamPiece& self) { return std::const_pointer_cast<SeamCurve>(self.curve); },
          [](SeamPiece& self, std::shared_ptr<SeamCurve> curve) { self.curve = std::move(curve); },
          "SeamCurve; None unless the kind is curve")
      .field("start_time", &SeamPiece::start_time, "s")
      .field("end_time", &SeamPiece::end_time, "s")
      .checked([](const SeamPiece& self) {
        if (self.kind == SeamPiece::Kind::curve && !self.curve)
          throw InvalidInput("SeamPiece.curve", "None", "a SeamCurve");
      })
      .done()
      .def("length", &SeamPiece::length, "m, of the TCP's path.")
      .def("frame_at", &SeamPiece::frame_at, py::arg("fraction"),
           "At a share of its time, 0 to 1.");
}

void bind_seam_class(py::module_& module) {
  py::class_<Seam>(
      module, "Seam",
      "The nominal TCP path over time, in the base frame. Immutable. Where it is stood "
      "still on or run slower, a time law gives the nominal time at each real time.")
      .def(py::init<>(), "Without pieces.")
      .def(py::init<std::vector<SeamPiece>>(), py::arg("pieces"),
           "Pieces in order, each starting when the one before it ends. Raises InvalidInput for no "
           "pieces or gaps in time.")
      .def("__repr__",
           [](const Seam& seam) {
             return "<Seam of " + std::to_string(seam.pieces().size()) + " pieces>";
           })
      .def_property_readonly("pieces", &Seam::pieces, "SeamPiece")
      .def_property_readonly("start_time", of_pieces([](const Seam& s) { return s.start_time(); }),
                             "s, real")
      .def_property_readonly("end_time", of_pieces([](const Seam& s) { return s.end_time(); }),
                             "s, real")
      .def_property_readonly("length", of_pieces([](const Seam& s) { return s.length(); }), "m")
      .def_property_readonly("is_retimed", &Seam::is_retimed, "whether there is a time law")
      .def_property_readonly("seam_time", &Seam::seam_time,
                             "the time law as a Trajectory of one joint, s over s; empty: none")
      .def(
          "retimed",
          [](const Seam& seam, const Trajectory& law) {
            expect_pieces(seam);
            return seam.retimed(law);
          },
          py::arg("seam_time"),
          "The same pieces under another time law. Raises InvalidInput where it decreases or does "
          "not run from the start to the end.")
      .def("nominal_time", of_pieces_at([](const Seam& s, double t) { return s.nominal_time(t); }),
           py::arg("t"), "s, at real time t.")
      .def("real_time", of_pieces_at([](const Seam& s, double t) { return s.real_time(t); }),
           py::arg("nominal"), "s, the earliest at which that nominal time is reached.")
      .def("speed_ratio", of_pieces_at([](const Seam& s, double t) { return s.speed_ratio(t); }),
           py::arg("t"), "The speed at real time t as a share of the piece's own.")
      .def("piece_at",
           of_pieces_at([](const Seam& s, double t) { return SeamPiece(s.piece_at(t)); }),
           py::arg("t"), "The piece that is run at real time t.")
      .def("frame_at", of_pieces_at([](const Seam& s, double t) { return s.frame_at(t); }),
           py::arg("t"), "The path frame at real time t (s), shape (4, 4).")
      .def(py::pickle(
          [](const Seam& seam) { return py::make_tuple(seam.pieces(), seam.seam_time()); },
          [](const py::tuple& state) {
            const auto pieces = state[0].cast<std::vector<SeamPiece>>();
            if (pieces.empty()) return Seam();
            const auto law = state[1].cast<Trajectory>();
            return law.empty() ? Seam(pieces) : Seam(pieces).retimed(law);
          }));
}

}  // namespace

void bind_seam(py::module_& module) {
  bind_piece(module);
  bind_seam_class(module);
  bind_task(module);
}

}  // namespace wristwise::python
