#include "bindings.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::python {

namespace {

void bind_graph(py::module_& module) {
  StructBinding<GraphStatistics>(module, "GraphStatistics", "What stage 1 did. Frozen.",
                                 Access::frozen)
      .field("vertices", &GraphStatistics::vertices, "copies by whole turns included")
      .field("postures", &GraphStatistics::postures, "copies by whole turns not included")
      .field("postures_checked", &GraphStatistics::postures_checked,
             "for clearance, before any move")
      .field("edges", &GraphStatistics::edges, "of the whole graph")
      .field("edges_evaluated", &GraphStatistics::edges_evaluated, "looked at")
      .field("collision_checks", &GraphStatistics::collision_checks,
             "exact distance queries; varies with the threads")
      .field("edges_checked", &GraphStatistics::edges_checked, "swept")
      .field("edges_if_eager", &GraphStatistics::edges_if_eager,
             "moves that an eager check would sweep")
      .field("cost", &GraphStatistics::cost, "of the best path")
      .field("joint_motion_l1", &GraphStatistics::joint_motion_l1, "rad and m")
      .field("first_turns", &GraphStatistics::first_turns,
             "whole turns of each joint from (-pi, pi], at the first waypoint")
      .field("last_turns", &GraphStatistics::last_turns, "at the last waypoint")
      .field("grid_rounds", &GraphStatistics::grid_rounds,
             "coarse to fine: searches after the first")
      .field("first_cost", &GraphStatistics::first_cost,
             "coarse to fine: on the grid of the options")
      .field("sparse_points", &GraphStatistics::sparse_points, "sparse: waypoints planned")
      .field("replans", &GraphStatistics::replans, "sparse: searches after the first")
      .field("pieces", &GraphStatistics::pieces,
             "where there is no path: first and last waypoints of the pieces that have one")
      .done(false);
}

void bind_refine(py::module_& module) {
  StructBinding<CostTerm>(module, "CostTerm", "A term of the objective. Frozen.", Access::frozen)
      .field("name", &CostTerm::name, "of the term")
      .field("initial", &CostTerm::initial, "integral over time, weighted, of the seed")
      .field("final", &CostTerm::final, "integral over time, weighted, of the result")
      .done(false);
  StructBinding<ActiveConstraint> constraint(
      module, "ActiveConstraint",
      "A constraint that the refined motion presses against, over a stretch of time. Frozen.",
      Access::frozen);
  py::enum_<ActiveConstraint::Unit>(constraint.python_class(), "Unit", "Of what is widened.")
      .value("metre", ActiveConstraint::Unit::metre)
      .value("radian", ActiveConstraint::Unit::radian)
      .value("share", ActiveConstraint::Unit::share, "of a velocity, acceleration or jerk limit");
  constraint.field("name", &ActiveConstraint::name, "coordinate, joint, or pair of bodies")
      .field("unit", &ActiveConstraint::unit, "ActiveConstraint.Unit")
      .field("from_", &ActiveConstraint::from, "s")
      .field("to", &ActiveConstraint::to, "s")
      .field("relative_gain", &ActiveConstraint::relative_gain,
             "share of the objective that widening saves, per unit")
      .field("sentence", &ActiveConstraint::sentence, "for people")
      .done(false);
  StructBinding<RefineStatistics>(module, "RefineStatistics", "What stage 2 did. Frozen.",
                                  Access::frozen)
      .field("run", &RefineStatistics::run, "whether it was run")
      .field("rounds", &RefineStatistics::rounds, "of the augmented Lagrangian")
      .field("iterations", &RefineStatistics::iterations, "of the inner solver")
      .field("evaluations", &RefineStatistics::evaluations, "of the objective")
      .field("control_points", &RefineStatistics::control_points, "of the spline")
      .field("constraint_points", &RefineStatistics::constraint_points, "in time")
      .field("termination", &RefineStatistics::termination, "how it ended")
      .field("objective", &RefineStatistics::objective, "integral over time")
      .field("max_violation", &RefineStatistics::max_violation,
             "m or rad, of the constraints at their points")
      .field("distance_queries", &RefineStatistics::distance_queries, "exact ones")
      .field("terms", &RefineStatistics::terms, "CostTerm")
      .field("active", &RefineStatistics::active, "ActiveConstraint, the most costly first")
      .done(false);
}

void bind_diagnosis(py::module_& module) {
  StructBinding<FailureCounts>(module, "FailureCounts",
                               "What became of the samples of a waypoint that cannot be passed. "
                               "Frozen.",
                               Access::frozen)
      .field("samples", &FailureCounts::samples, "poses tried")
      .field("out_of_reach", &FailureCounts::out_of_reach, "poses without a branch")
      .field("joint_limit", &FailureCounts::joint_limit, "joint -> branches that it excludes")
      .field("collision", &FailureCounts::collision, "pair of names -> postures it excludes")
      .field("usable", &FailureCounts::usable, "postures, whole turns included")
      .field("too_fast", &FailureCounts::too_fast, "moves to them that a joint can't make in time")
      .field("too_far", &FailureCounts::too_far, "moves beyond max_tcp_step or max_tcp_turn")
      .field("astray", &FailureCounts::astray, "moves beyond max_stray")
      .field("blocked", &FailureCounts::blocked, "moves that collide on the way")
      .done(false);
  StructBinding<Diagnosis>(module, "Diagnosis",
                           "Why there is no trajectory, or what is wrong with the one there is. "
                           "Frozen.",
                           Access::frozen)
      .field("waypoint", &Diagnosis::waypoint, "the first that fails, or None")
      .field("reason", &Diagnosis::reason,
             "out_of_reach, joint_limit, collision, no_edge, tolerance, ...")
      .field("detail", &Diagnosis::detail, "one sentence")
      .field("suggestion", &Diagnosis::suggestion, "what would help")
      .field("counts", &Diagnosis::counts, "FailureCounts, or None")
      .done(false);
}

}  // namespace

void bind_statistics(py::module_& module) {
  bind_graph(module);
  bind_refine(module);
  bind_diagnosis(module);
}

}  // namespace wristwise::python
