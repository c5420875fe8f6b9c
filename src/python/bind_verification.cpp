#include "bindings.hpp"
#include "planner_run.hpp"
#include "wristwise/verification.hpp"

namespace wristwise::python {

namespace {

void bind_verification_options(py::module_& module) {
  StructBinding<VerificationOptions>(module, "VerificationOptions",
                                     "What \"passed\" means, in numbers.", Access::writable)
      .field("position_tolerance", &VerificationOptions::position_tolerance,
             "m, beyond the box at waypoints")
      .field("angle_tolerance", &VerificationOptions::angle_tolerance,
             "rad, beyond the box at waypoints")
      .field("joint_limit_tolerance", &VerificationOptions::joint_limit_tolerance, "rad or m")
      .field("clearance_tolerance", &VerificationOptions::clearance_tolerance, "m, at waypoints")
      .field("clearance_epsilon", &VerificationOptions::clearance_epsilon,
             "m, of the claim for all t; a problem's own counts in its place")
      .field("samples_per_interval", &VerificationOptions::samples_per_interval,
             "further samples in each interval, as a cross-check")
      .done();
}

void bind_outcome(py::module_& module) {
  StructBinding<TimeRange>(module, "TimeRange", "A stretch of time. Frozen.", Access::frozen)
      .field("from_", &TimeRange::from, "s")
      .field("to", &TimeRange::to, "s")
      .done();
  StructBinding<UnshownClearance>(module, "UnshownClearance",
                                  "Where a clearance could not be shown. Frozen.", Access::frozen)
      .field("range", &UnshownClearance::range, "TimeRange")
      .field("pair", &UnshownClearance::pair, "names of the two bodies")
      .done(false);
  StructBinding<Verification>(module, "Verification",
                              "The outcome of the independent check. Frozen.", Access::frozen)
      .field("run", &Verification::run, "whether it was made")
      .field("passed", &Verification::passed, "whether all holds that must")
      .field("curve", &Verification::curve, "checked as a curve; else as points joined by moves")
      .field("range", &Verification::range, "TimeRange of the motion")
      .field("position_error", &Verification::position_error,
             "m, largest distance from the nominal TCP at waypoints, less the box's own width")
      .field("tolerance_excess", &Verification::tolerance_excess,
             "beyond the box at waypoints, m and rad, shape (6,)")
      .field("tolerance_excess_between", &Verification::tolerance_excess_between,
             "beyond the widened box between waypoints, m and rad, shape (6,)")
      .field("deviation_shown", &Verification::deviation_shown,
             "inside the widened box for all t, to within the tolerances")
      .field("deviation_not_shown", &Verification::deviation_not_shown, "TimeRange")
      .field("path_error", &Verification::path_error,
             "m: for all t the TCP is no farther from its place on the seam")
      .field("angle_error", &Verification::angle_error,
             "rad: for all t no angle that is not free deviates more")
      .field("joint_limit_excess", &Verification::joint_limit_excess, "rad or m")
      .field("clearance", &Verification::clearance, "m, the least of all t; None: no pair counts")
      .field("clearance_bound", &Verification::clearance_bound,
             "m, shown for all t; None where it is not shown")
      .field("clearance_not_shown", &Verification::clearance_not_shown, "UnshownClearance")
      .field("clearance_pair", &Verification::clearance_pair, "names of the two bodies")
      .field("clearance_time", &Verification::clearance_time, "s")
      .field("velocity_ratio", &Verification::velocity_ratio, "largest |q'| / limit")
      .field("acceleration_ratio", &Verification::acceleration_ratio, "largest |q''| / limit")
      .field("jerk_ratio", &Verification::jerk_ratio, "largest |q'''| / limit")
      .field("velocity_joint", &Verification::velocity_joint, "index, where that is; -1: none")
      .field("acceleration_joint", &Verification::acceleration_joint, "index; -1: none")
      .field("jerk_joint", &Verification::jerk_joint, "index; -1: none")
      .field("velocity_time", &Verification::velocity_time, "s")
      .field("samples", &Verification::samples, "postures looked at")
      .field("distance_queries", &Verification::distance_queries, "exact ones")
      .field("failures", &Verification::failures, "one line each: what, where, by how much")
      .field("warnings", &Verification::warnings, "reported, but no reason to fail")
      .done(false);
}

void expect_complete(const Task& task) {
  if (task.waypoints.size() < 2)
    throw InvalidInput("task.waypoints", std::to_string(task.waypoints.size()) + " given",
                       "at least two");
  if (task.seam.pieces().empty()) throw InvalidInput("task.seam", "no pieces", "at least one");
}

template <class Motion>
void def_verify(py::module_& module, const char* motion_name, const char* doc) {
  module.def(
      "verify",
      [](const Task& task, const std::shared_ptr<ClearanceModel>& clearance, const Motion& motion,
         const VerificationOptions& options) {
        expect_complete(task);
        const auto model = shared(clearance, "clearance");
        const Task copy = task;
        const VerificationOptions options_copy = options;
        PlannerRun run{PythonPlanOptions()};
        return run([&] { return verify(copy, model, motion, options_copy); });
      },
      py::arg("task"), py::arg("clearance"), py::arg(motion_name),
      py::arg("options") = VerificationOptions(), doc);
}

}  // namespace

void bind_verification(py::module_& module) {
  bind_verification_options(module);
  bind_outcome(module);
  def_verify<JointPath>(module, "path", "Checks points joined by straight joint-space moves.");
  def_verify<Trajectory>(module, "trajectory", "Checks a curve, at waypoints and between them.");
  module.def(
      "violations_of", &violations_of, py::arg("verification"),
      "Everything that is beyond a limit, a tolerance or a clearance, reason to fail or not.");
}

}  // namespace wristwise::python
