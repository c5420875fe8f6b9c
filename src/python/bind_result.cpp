#include "bindings.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::python {

namespace {

void bind_enums(py::module_& module) {
  py::enum_<Mode>(module, "Mode", "What was asked for.")
      .value("two_stage", Mode::two_stage, "plan()")
      .value("graph_only", Mode::graph_only, "plan_graph_only()")
      .value("smooth", Mode::smooth, "smooth()");
  py::enum_<Status>(module, "Status", "What came of it.")
      .value("solved", Status::solved, "and the independent check passed")
      .value("infeasible", Status::infeasible, "no trajectory meets the problem; see the diagnosis")
      .value("failed", Status::failed, "something was found, but it does not pass the check")
      .value("interrupted", Status::interrupted, "cancelled by the caller");
}

void bind_parts(py::module_& module) {
  StructBinding<Seed>(module, "Seed", "A path of stage 1, to start stage 2 from. Frozen.",
                      Access::frozen)
      .field("path", &Seed::path, "JointPath")
      .field("cost", &Seed::cost, "of stage 1")
      .field("differs_at", &Seed::differs_at, "waypoint at which it differs from those before")
      .field("refinement", &Seed::refinement, "what stage 2 made of it: how it ended")
      .field("objective", &Seed::objective, "of stage 2, where all constraints hold, or None")
      .done(false);
  StructBinding<SlowedStretch>(module, "SlowedStretch",
                               "A stretch of the weld that is run slower than the problem's times. "
                               "Frozen.",
                               Access::frozen)
      .field("from_", &SlowedStretch::from, "s")
      .field("to", &SlowedStretch::to, "s")
      .field("least_ratio", &SlowedStretch::least_ratio, "of the problem's speed")
      .field("joint", &SlowedStretch::joint, "index of the one that is nearest to its limits there")
      .done(false);
  StructBinding<Timing>(module, "Timing", "How long each stage took, s. Frozen.", Access::frozen)
      .field("load", &Timing::load, "s")
      .field("sampling", &Timing::sampling, "s")
      .field("search", &Timing::search, "s")
      .field("refine", &Timing::refine, "s")
      .field("verify", &Timing::verify, "s")
      .field("total", &Timing::total, "s")
      .done(false);
  StructBinding<GivenPath>(module, "GivenPath",
                           "A joint path as it was given, its jumps by whole turns undone. Frozen.",
                           Access::frozen)
      .field("path", &GivenPath::path, "JointPath")
      .field("verification", &GivenPath::verification, "what the check says of it")
      .done(false);
}

}  // namespace

void bind_result(py::module_& module) {
  bind_enums(module);
  bind_parts(module);
  StructBinding<PlanResult>(module, "PlanResult",
                            "What plan(), plan_graph_only() and smooth() return. Frozen.",
                            Access::frozen)
      .field("status", &PlanResult::status, "Status")
      .field("mode", &PlanResult::mode, "Mode")
      .field("seeds", &PlanResult::seeds, "Seed, of stage 1, the best first")
      .field("path", &PlanResult::path,
             "JointPath at the waypoints; may be partial where there is no solution")
      .field("trajectory", &PlanResult::trajectory, "the curve; empty in graph-only mode")
      .field("seam_time", &PlanResult::seam_time,
             "the time law it runs the seam by; empty: that of the problem")
      .field("slowed", &PlanResult::slowed, "SlowedStretch, in order")
      .field("graph", &PlanResult::graph, "GraphStatistics")
      .field("refine", &PlanResult::refine, "RefineStatistics")
      .field("verification", &PlanResult::verification, "Verification")
      .field("before", &PlanResult::before, "GivenPath that smooth() started from, or None")
      .field("diagnosis", &PlanResult::diagnosis, "Diagnosis; none where it is solved")
      .field("warnings", &PlanResult::warnings, "one line each")
      .field("permanent_contacts", &PlanResult::permanent_contacts,
             "pairs of names left out of the check")
      .field("inverse_kinematics", &PlanResult::inverse_kinematics, "what was recognised")
      .field("timing", &PlanResult::timing, "Timing")
      .done(false);
}

}  // namespace wristwise::python
