#include "bindings.hpp"
#include "planner_run.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::python {

namespace {

void bind_monitor(py::module_& module) {
  py::enum_<LogLevel>(module, "LogLevel", "Of a line for the log.")
      .value("info", LogLevel::info)
      .value("warning", LogLevel::warning);
  StructBinding<PythonMonitor>(module, "Monitor",
                               "How the caller watches and stops a run. What a callback raises "
                               "stops the run and comes out of the call.",
                               Access::writable)
      .field("progress", &PythonMonitor::progress,
             "f(stage, fraction): \"sampling\", \"search\", \"refine\" (of several seeds "
             "\"refine seed 2 of 3\") or \"verify\", and the "
             "share of it that is done; called from the thread that called plan()")
      .field("log", &PythonMonitor::log,
             "f(level, line), called from the thread that called plan()")
      .field("cancel", &PythonMonitor::cancel,
             "a threading.Event: set it to stop at the next chance, with Status.interrupted")
      .done();
  StructBinding<PythonPlanOptions>(module, "PlanOptions", "How a plan is made.", Access::writable)
      .field("threads", &PythonPlanOptions::threads,
             "0: one per core; the result does not depend on it")
      .field("monitor", &PythonPlanOptions::monitor, "Monitor")
      .field("verification", &PythonPlanOptions::verification, "VerificationOptions")
      .done();
}

using PlanFunction = PlanResult (*)(const Problem&, const PlanOptions&);

auto planning(PlanFunction function) {
  return [function](const Problem& problem, const PythonPlanOptions& options) {
    PlannerRun run(options);
    const Problem guarded = run.guarded(problem);
    return run([&] { return function(guarded, run.options()); });
  };
}

PlanResult smoothed(const Problem& problem, const JointPath& path,
                    const PythonPlanOptions& options) {
  PlannerRun run(options);
  const Problem guarded = run.guarded(problem);
  return run([&] { return smooth(guarded, path, run.options()); });
}

template <class Motion>
void def_check(py::module_& module, const char* motion_name, const char* doc) {
  module.def(
      "check",
      [](const Problem& problem, const Motion& motion, const PythonPlanOptions& options) {
        PlannerRun run(options);
        const Problem copy = problem;
        return run([&] { return check(copy, motion, run.options()); });
      },
      py::arg("problem"), py::arg(motion_name), py::arg("options") = PythonPlanOptions(), doc);
}

}  // namespace

void bind_plan(py::module_& module) {
  bind_monitor(module);
  module.def("plan", planning(&plan), py::arg("problem"), py::arg("options") = PythonPlanOptions(),
             "Both stages: ladder graph, refinement, verification. No solution is a result, with a "
             "diagnosis. Ctrl-C stops it. Raises InvalidInput.");
  module.def("plan_graph_only", planning(&plan_graph_only), py::arg("problem"),
             py::arg("options") = PythonPlanOptions(),
             "Stage 1 alone, verified: what a Descartes-style planner gives.");
  module.def("smooth", &smoothed, py::arg("problem"), py::arg("path"),
             py::arg("options") = PythonPlanOptions(),
             "Stage 2 alone on an existing JointPath, whose times become the waypoints. Raises "
             "InvalidInput where the path does not fit the robot or the seam.");
  def_check<JointPath>(module, "path",
                       "The independent check of points joined by straight joint-space moves.");
  def_check<Trajectory>(module, "trajectory", "The independent check of a curve.");
  def_check<TrajectoryFile>(module, "file",
                            "The independent check of what a file holds, its time law included.");
}

}  // namespace wristwise::python
