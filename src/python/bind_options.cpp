#include "bindings.hpp"
#include "python_costs.hpp"
#include "wristwise/options.hpp"

namespace wristwise::python {

namespace {

void bind_enums(py::module_& module) {
  py::enum_<Turns>(module, "Turns", "Which copies of a posture by whole turns are vertices.")
      .value("all", Turns::all, "all inside the joint limits")
      .value("principal", Turns::principal, "the one in (-pi, pi]");
  py::enum_<SingularityMeasure>(module, "SingularityMeasure",
                                "How far a posture is from a singular one, 0 (singular) to 1.")
      .value("wrist", SingularityMeasure::wrist,
             "sine of the angle between the last joint's axis and the last but two's")
      .value("manipulability", SingularityMeasure::manipulability,
             "Yoshikawa's measure, relative to the largest in the robot's workspace");
  py::enum_<CollisionChecks>(module, "CollisionChecks", "When stage 1 measures clearances.")
      .value("lazy", CollisionChecks::lazy, "only where a best path needs it")
      .value("eager", CollisionChecks::eager, "for every sample");
  py::enum_<Planner>(module, "Planner", "Which waypoints stage 1 plans.")
      .value("dense", Planner::dense, "all of them")
      .value("sparse", Planner::sparse, "a few, with joint interpolation between them");
}

void bind_cost(py::module_& module) {
  StructBinding<CostOptions>(module, "CostOptions", "What is minimised, in both stages.",
                             Access::writable)
      .field("joint_motion", &CostOptions::joint_motion,
             "weight of |q'|^2 (stage 2) and of the L1 step (stage 1)")
      .field("acceleration", &CostOptions::acceleration, "weight of tau^2 |q''|^2")
      .field("jerk", &CostOptions::jerk, "weight of tau^4 |q'''|^2")
      .field("euler_graph", &CostOptions::euler_graph,
             "rad of joint motion per rad of deviation at each vertex")
      .field("euler_refine", &CostOptions::euler_refine,
             "weight of (eta^2 alpha^2 + beta^2) / tau^2")
      .field("euler_eta", &CostOptions::euler_eta, "alpha's share against beta's")
      .field("position_graph", &CostOptions::position_graph,
             "rad of joint motion per m of |x| + |y| + |z| at each vertex")
      .field("position_refine", &CostOptions::position_refine,
             "weight of (x^2 + y^2 + z^2) / tau^2, rad^2 / m^2")
      .field("squared_steps", &CostOptions::squared_steps,
             "stage 1: the sum of squared joint steps instead of absolute ones")
      .field("singularity_graph", &CostOptions::singularity_graph,
             "rad of joint motion at each vertex that is singular; less where it is farther")
      .field("singularity_measure", &CostOptions::singularity_measure, "SingularityMeasure")
      .field("singularity_refine", &CostOptions::singularity_refine,
             "stage 2: weight of cos^8(wrist) / tau^2")
      .field("posture", &CostOptions::posture, "stage 2: weight of |q - preferred|^2 / tau^2")
      .field("preferred_posture", &CostOptions::preferred_posture,
             "rad or m, shape (joints,); empty: none")
      .field("vertex_cost", &CostOptions::vertex_cost,
             "own cost of a posture: f(waypoint, q) -> rad of joint motion, >= 0, added to the "
             "rest in stage 1; inf: not allowed. q has shape (joints,). Called from several "
             "threads, one at a time")
      .field("edge_cost", &CostOptions::edge_cost,
             "own cost of a move in the interval after a waypoint: f(interval, from, to) -> as "
             "vertex_cost")
      .field("posture_residuals", &CostOptions::posture_residuals,
             "own residuals of stage 2, f(time, q) -> (r, dr/dq): each adds the integral of r^2; "
             "time in s, q and dr/dq of shape (joints,), r smooth in both. Called from several "
             "threads, one at a time")
      .field("joint_weights", &CostOptions::joint_weights,
             "of each joint's step or derivatives, shape (joints,); empty: ones")
      .done();
}

void bind_graph(py::module_& module) {
  StructBinding<GraphOptions>(module, "GraphOptions", "Stage 1, the ladder graph.",
                              Access::writable)
      .field("step", &GraphOptions::step,
             "sampling step of x, y, z (m), rx, ry, rz (rad), shape (6,); 0: the ends and the "
             "nominal, 10 deg for a free one")
      .field("joint_step", &GraphOptions::joint_step,
             "sampling step of joint waypoints' ranges, rad or m, shape (joints,); empty: all 0")
      .field("redundancy", &GraphOptions::redundancy,
             "steps (rad or m) by name of joints to spare, which are sampled; 0: the default")
      .field("automatic_samples", &GraphOptions::automatic_samples,
             "> 0: steps are chosen so that a waypoint has about so many samples")
      .field("coarse_to_fine", &GraphOptions::coarse_to_fine,
             "sample again, ever finer, around the best path until the cost settles")
      .field("planner", &GraphOptions::planner, "Planner")
      .field("sparse_deviation", &GraphOptions::sparse_deviation,
             "rad or m; sparse: how far an interpolated posture may be from one in tolerance")
      .field("try_relaxations", &GraphOptions::try_relaxations,
             "where there is no path, look for the smallest relaxation that would help")
      .field("seeds", &GraphOptions::seeds,
             "distinct paths to look for, the best first; each is refined")
      .field("spare_seeds", &GraphOptions::spare_seeds,
             "so many more are tried where none of those can be refined")
      .field("seed_separation", &GraphOptions::seed_separation,
             "rad or m; postures that differ by less in every joint are neighbours")
      .field("turns", &GraphOptions::turns, "Turns")
      .field("max_stray", &GraphOptions::max_stray,
             "m; no edge on which the TCP strays farther from the seam; inf: any")
      .field("check_moves", &GraphOptions::check_moves,
             "False: moves are not swept for clearance and stray, only postures are checked")
      .field("max_tcp_step", &GraphOptions::max_tcp_step, "m, from waypoint to waypoint")
      .field("max_tcp_turn", &GraphOptions::max_tcp_turn, "rad, from waypoint to waypoint")
      .field("collision_checks", &GraphOptions::collision_checks, "CollisionChecks")
      .done();
}

void bind_refine(py::module_& module) {
  StructBinding<RefineOptions>(module, "RefineOptions", "Stage 2, the refinement.",
                               Access::writable)
      .field("smoothing_time", &RefineOptions::smoothing_time,
             "tau, s: motion is ironed over about this long")
      .field("knot_spacing", &RefineOptions::knot_spacing, "s between knots; 0: chosen")
      .field("max_rounds", &RefineOptions::max_rounds, "of the augmented Lagrangian")
      .field("max_iterations", &RefineOptions::max_iterations, "of the inner solver in a round")
      .field("constraint_tolerance", &RefineOptions::constraint_tolerance, "m and rad")
      .field("clearance_epsilon", &RefineOptions::clearance_epsilon,
             "m kept in hand, so that the clearance holds for all t")
      .field("try_speeds", &RefineOptions::try_speeds,
             "where the weld speed can't be held, find the highest uniform speed that works")
      .field("time_limit", &RefineOptions::time_limit,
             "s; after it the best motion so far is taken; inf: none")
      .done();
}

}  // namespace

void bind_options(py::module_& module) {
  bind_enums(module);
  bind_cost(module);
  bind_graph(module);
  bind_refine(module);
}

}  // namespace wristwise::python
