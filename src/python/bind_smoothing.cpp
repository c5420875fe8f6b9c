#include "bindings.hpp"
#include "planner_run.hpp"
#include "wristwise/smoothing.hpp"

namespace wristwise::python {

void bind_smoothing(py::module_& module) {
  StructBinding<SmoothingOptions>(module, "SmoothingOptions",
                                  "How a joint path is smoothed of which nothing else is known.",
                                  Access::writable)
      .field("position_tolerance", &SmoothingOptions::position_tolerance,
             "m, > 0: how far the TCP may be, at any time, from where the path has it")
      .field("angle_tolerance", &SmoothingOptions::angle_tolerance,
             "rad, in (0, pi): likewise the angle of the rotation between the two")
      .field("smoothing_time", &SmoothingOptions::smoothing_time, "s, > 0; None: chosen")
      .field("self_collision", &SmoothingOptions::self_collision,
             "keep the links clear of each other, but for those that touch along the path")
      .done();
  StructBinding<SmoothingProblem>(
      module, "SmoothingProblem",
      "A joint path made into a problem: the TCP path that it draws, to "
      "be kept. Frozen.",
      Access::frozen)
      .field("problem", &SmoothingProblem::problem, "Problem")
      .field("path", &SmoothingProblem::path, "JointPath: one posture for each waypoint")
      .field("warnings", &SmoothingProblem::warnings, "one line each")
      .done(false);
  module.def(
      "smoothing_problem",
      [](const std::shared_ptr<Robot>& robot, const JointPath& path,
         const SmoothingOptions& smoothing) {
        const SmoothingOptions copy = smoothing;
        PlannerRun run{PythonPlanOptions()};
        return run([&] { return smoothing_problem(shared(robot, "robot"), path, copy); });
      },
      py::arg("robot"), py::arg("path"), py::arg("smoothing") = SmoothingOptions(),
      "The problem of keeping the TCP path that a JointPath draws.");
  module.def(
      "smooth",
      [](const std::shared_ptr<Robot>& robot, const JointPath& path,
         const SmoothingOptions& smoothing, const PythonPlanOptions& options) {
        const SmoothingOptions copy = smoothing;
        PlannerRun run(options);
        return run([&] { return smooth(shared(robot, "robot"), path, copy, run.options()); });
      },
      py::arg("robot"), py::arg("path"), py::arg("smoothing"),
      py::arg("options") = PythonPlanOptions(),
      "Smooths a JointPath without a problem: the TCP path that it draws is kept, within the "
      "tolerances.");
}

}  // namespace wristwise::python
