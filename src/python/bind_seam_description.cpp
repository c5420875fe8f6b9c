#include "bindings.hpp"
#include "wristwise/seam_description.hpp"

namespace wristwise::python {

namespace {

void bind_shapes(py::module_& module) {
  StructBinding<LineSegment>(module, "LineSegment",
                             "Straight, turning at a constant rate about one axis. Frozen.",
                             Access::frozen)
      .field("from_", &LineSegment::from, "first path frame, in base, shape (4, 4)")
      .required()
      .field("to", &LineSegment::to, "last path frame, in base, shape (4, 4)")
      .required()
      .done();
  StructBinding<ArcSegment>(module, "ArcSegment",
                            "The first pose turned rigidly about an axis through the center. "
                            "Frozen.",
                            Access::frozen)
      .field("from_", &ArcSegment::from, "first path frame, in base, shape (4, 4)")
      .required()
      .field("center", &ArcSegment::center, "m, in base, shape (3,)")
      .required()
      .field("axis", &ArcSegment::axis, "in base, of any length but zero, shape (3,)")
      .required()
      .field("angle", &ArcSegment::angle, "rad, right-handed")
      .required()
      .done();
  StructBinding<PoseListSegment>(module, "PoseListSegment", "Poses joined by lines. Frozen.",
                                 Access::frozen)
      .field("poses", &PoseListSegment::poses, "path frames, in base, shape (N, 4, 4)")
      .required()
      .field("times", &PoseListSegment::times, "s, increasing, shape (N,); empty: by the speed")
      .field("where", &PoseListSegment::where, "names each in messages; empty: its number")
      .done();
  StructBinding<JointListSegment>(module, "JointListSegment",
                                  "Joint waypoints; moves between them are timed by the nominal "
                                  "postures. Frozen.",
                                  Access::frozen)
      .field("postures", &JointListSegment::postures, "JointBox, a value or a range for each joint")
      .required()
      .field("where", &JointListSegment::where, "names each in messages; empty: its number")
      .done();
}

void bind_parts(py::module_& module) {
  StructBinding<Segment>(module, "Segment",
                         "A part of the seam; each begins where the one before it ends. Frozen.",
                         Access::frozen)
      .field("shape", &Segment::shape,
             "LineSegment, ArcSegment, PoseListSegment or JointListSegment")
      .required()
      .field("tolerance", &Segment::tolerance,
             "ToleranceBox of its waypoints, and of the stretches between them")
      .field("where", &Segment::where, "names it in messages; empty: its number")
      .done();
  StructBinding<RunDescription>(module, "RunDescription",
                                "Between rest and the weld speed, before or after the seam: "
                                "straight on along its tangent, or "
                                "from a point away from it. Frozen.",
                                Access::frozen)
      .field("length", &RunDescription::length, "m, along the tangent")
      .field("away", &RunDescription::away,
             "m, in the path frame of the seam's end, shape (3,), or None")
      .field("duration", &RunDescription::duration,
             "s, with away; None: twice the time at weld speed")
      .field("where", &RunDescription::where, "names it in messages")
      .done();
  StructBinding<CornerOptions> corners(
      module, "CornerOptions", "What becomes of the corners of a seam. Frozen.", Access::frozen);
  py::enum_<CornerOptions::Kind>(corners.python_class(), "Kind", "What happens at a corner.")
      .value("keep", CornerOptions::Kind::keep, "run at weld speed")
      .value("stop", CornerOptions::Kind::stop, "come to rest, and turn the torch while it stands")
      .value("slow", CornerOptions::Kind::slow, "run slower")
      .value("blend", CornerOptions::Kind::blend, "round off");
  corners.field("kind", &CornerOptions::kind, "CornerOptions.Kind, says which of the rest count")
      .field("ramp_time", &CornerOptions::ramp_time, "s, stop and slow: before and after")
      .field("turn_rate", &CornerOptions::turn_rate, "rad/s, stop: at most, of the frame")
      .field("speed_ratio", &CornerOptions::speed_ratio, "slow: share of the weld speed")
      .field("distance", &CornerOptions::distance, "m, blend: of its ends from the corner")
      .done();
}

}  // namespace

void bind_seam_description(py::module_& module) {
  bind_shapes(module);
  bind_parts(module);
  StructBinding<SeamDescription>(
      module, "SeamDescription",
      "A seam as a welder describes it; what path of a problem file says.", Access::writable)
      .field("segments", &SeamDescription::segments, "Segment, one or more, in order")
      .field("speed", &SeamDescription::speed, "m/s; needed where not every pose has a time")
      .field("spacing", &SeamDescription::spacing, "m, the longest interval between waypoints; or:")
      .field("waypoints", &SeamDescription::waypoints,
             "number of them, of the whole seam, without run-in and run-out")
      .field("corners", &SeamDescription::corners, "CornerOptions")
      .field("run_in", &SeamDescription::run_in, "RunDescription; None: it begins at weld speed")
      .field("run_out", &SeamDescription::run_out, "RunDescription; None: it ends at weld speed")
      .field("where", &SeamDescription::where, "names it in messages")
      .done();
  module.def(
      "build_task",
      [](const Robot& robot, const SeamDescription& description) {
        return build_task(robot, description);
      },
      py::arg("robot"), py::arg("description"),
      "The Task: joins the segments, treats their corners, gives them their times, cuts them into "
      "waypoints and adds run-in and run-out. Raises InvalidInput, naming the segment.");
}

}  // namespace wristwise::python
