#include "bindings.hpp"
#include "wristwise/seam.hpp"

namespace wristwise::python {

namespace {

void expect_waypoints(const Task& task) {
  if (task.waypoints.empty()) throw InvalidInput("task.waypoints", "none", "at least two");
}

/// Frames joined by lines, a waypoint at each.
Task task_through(const std::vector<Pose>& frames, const std::vector<double>& times,
                  const ToleranceBox& tolerance) {
  if (frames.size() != times.size() || frames.size() < 2)
    throw InvalidInput(
        "Task.through",
        std::to_string(frames.size()) + " frames and " + std::to_string(times.size()) + " times",
        "two or more frames, and a time for each");
  tolerance.validate("Task.through: tolerance");
  std::vector<SeamPiece> pieces;
  Task task;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Waypoint waypoint;
    waypoint.time = times[i];
    waypoint.frame = frames[i];
    waypoint.tolerance = tolerance;
    task.waypoints.push_back(waypoint);
    if (i == 0) continue;
    SeamPiece piece;
    piece.from = frames[i - 1];
    piece.to = frames[i];
    piece.start_time = times[i - 1];
    piece.end_time = times[i];
    pieces.push_back(piece);
  }
  task.seam = Seam(std::move(pieces));
  return task;
}

void bind_waypoint(py::module_& module) {
  StructBinding<JointBox>(module, "JointBox",
                          "A range for each joint, rad or m, in chain order. Frozen.",
                          Access::frozen)
      .field("lower", &JointBox::lower, "shape (joints,)")
      .required()
      .field("upper", &JointBox::upper, "shape (joints,)")
      .required()
      .checked([](const JointBox& box) {
        if (box.lower.size() != box.upper.size())
          throw InvalidInput("JointBox", "bounds of different sizes", "one of each per joint");
      })
      .done()
      .def("nominal", &JointBox::nominal,
           "The middle of every range; the posture itself where the box holds only one.");
  StructBinding<Waypoint>(module, "Waypoint",
                          "A point of the seam that the planner must pass. Frozen.", Access::frozen)
      .field("time", &Waypoint::time, "s")
      .field("frame", &Waypoint::frame,
             "path frame, in base: z along the torch towards the part, y along the weld")
      .field("tolerance", &Waypoint::tolerance, "ToleranceBox, also for the stretch that ends here")
      .field("joints", &Waypoint::joints, "JointBox of a joint waypoint, or None")
      .field("welding", &Waypoint::welding, "False: of the run-in or the run-out")
      .field("sampled", &Waypoint::sampled,
             "ToleranceBox, the part that stage 1 samples; None: all")
      .done();
}

}  // namespace

void bind_task(py::module_& module) {
  py::enum_<SpeedPolicy>(module, "SpeedPolicy",
                         "What to do where a joint can't keep up with the weld speed.")
      .value("hold", SpeedPolicy::hold, "keep the weld speed")
      .value("slow", SpeedPolicy::slow, "run slower there");
  bind_waypoint(module);
  StructBinding<Task>(
      module, "Task",
      "What is to be done: the seam, its waypoints and what is allowed between them.",
      Access::writable)
      .field(
          "seam", [](const Task& task) { return task.seam; },
          [](Task& task, Seam seam) { task.seam = std::move(seam); }, "Seam")
      .field("waypoints", &Task::waypoints, "Waypoint, in order of time")
      .field("between_position", &Task::between_position,
             "m, added to the tolerance box between waypoints")
      .field("between_angle", &Task::between_angle,
             "rad, added to the tolerance box between waypoints")
      .field("speed_policy", &Task::speed_policy, "SpeedPolicy")
      .field("rest_at_start", &Task::rest_at_start,
             "all joints stand still at the first waypoint's time")
      .field("rest_at_end", &Task::rest_at_end,
             "all joints stand still at the last waypoint's time")
      .done()
      .def_static("through", &task_through, py::arg("frames"), py::arg("times"),
                  py::arg("tolerance"),
                  "Frames, shape (N, 4, 4), joined by straight lines, with a waypoint at each; "
                  "times (s) of shape (N,). Raises InvalidInput where the times do not increase.")
      .def(
          "weld_start",
          [](const Task& task) {
            expect_waypoints(task);
            return task.weld_start();
          },
          "s, when the first welding waypoint is passed.")
      .def(
          "weld_end",
          [](const Task& task) {
            expect_waypoints(task);
            return task.weld_end();
          },
          "s, when the last welding waypoint is passed.")
      .def(
          "retimed",
          [](const Task& task, const Trajectory& law) {
            expect_waypoints(task);
            return task.retimed(law);
          },
          py::arg("seam_time"), "The same waypoints at the times at which the retimed seam passes.")
      .def(
          "with_waypoints_at",
          [](const Task& task, const std::vector<double>& times) {
            expect_waypoints(task);
            return task.with_waypoints_at(times);
          },
          py::arg("times"), "The same seam with waypoints at other times (s), shape (N,).");
}

}  // namespace wristwise::python
