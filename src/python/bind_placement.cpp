#include "bindings.hpp"
#include "planner_run.hpp"
#include "wristwise/placement.hpp"

namespace wristwise::python {

namespace {

void bind_request(py::module_& module) {
  py::enum_<Placed>(module, "Placed", "What stands elsewhere when a placement is tried.")
      .value("part", Placed::part)
      .value("robot", Placed::robot);
  StructBinding<PlacementOptions>(module, "PlacementOptions", "Where to look, and for what.",
                                  Access::writable)
      .field("placed", &PlacementOptions::placed, "Placed.part or Placed.robot")
      .field("with_", &PlacementOptions::with, "names of the objects that move along")
      .field("lower", &PlacementOptions::lower,
             "of the region: offsets x, y, z (m), rx, ry, rz (rad), shape (6,)")
      .field("upper", &PlacementOptions::upper, "of the region, shape (6,)")
      .field("speed_weight", &PlacementOptions::speed_weight,
             "of the peak of |joint speed| / limit")
      .field("singularity_weight", &PlacementOptions::singularity_weight,
             "of what is missing of the margin, as a share of it")
      .field("clearance_weight", &PlacementOptions::clearance_weight, "likewise")
      .field("singularity_margin", &PlacementOptions::singularity_margin,
             "wished for distance from a singular posture, 0 to 1")
      .field("clearance_margin", &PlacementOptions::clearance_margin,
             "m, wished for beyond the scene's clearance")
      .field("evaluations", &PlacementOptions::evaluations,
             "placements that the search measures at most; 0: chosen")
      .field("seed", &PlacementOptions::seed, "of the search")
      .field("map_points", &PlacementOptions::map_points, "along each side of the map; 0: no map")
      .field("time_limit", &PlacementOptions::time_limit, "s, of search and map; inf: none")
      .done();
  py::class_<PlacementRequest>(module, "PlacementRequest",
                               "A problem whose part, or robot, may stand elsewhere.")
      .def_readwrite("problem", &PlacementRequest::problem, "as it is given")
      .def_readonly("part_frame", &PlacementRequest::part_frame, "of the part, in base")
      .def_readwrite("options", &PlacementRequest::options, "PlacementOptions");
}

void bind_measure(py::module_& module) {
  StructBinding<PlacementMeasure>(module, "PlacementMeasure", "What a placement is worth. Frozen.",
                                  Access::frozen)
      .field("feasible", &PlacementMeasure::feasible, "planned, and verified")
      .field("value", &PlacementMeasure::value, "what is minimised")
      .field("obstacle", &PlacementMeasure::obstacle, "where not feasible: the reason")
      .field("waypoints_share", &PlacementMeasure::waypoints_share,
             "of the waypoints, in the longest piece that stage 1 can pass")
      .field("speed_ratio", &PlacementMeasure::speed_ratio, "peak of |joint speed| / limit")
      .field("singularity_distance", &PlacementMeasure::singularity_distance, "the least, 0 to 1")
      .field("clearance", &PlacementMeasure::clearance, "m, least; None: no pair counts")
      .done(false);
  StructBinding<Placement>(module, "Placement", "An offset and its measure. Frozen.",
                           Access::frozen)
      .field("offset", &Placement::offset, "x, y, z (m), rx, ry, rz (rad), shape (6,)")
      .field("measure", &Placement::measure, "PlacementMeasure")
      .done(false);
  StructBinding<PlacementMap>(module, "PlacementMap",
                              "The measure on a grid over two coordinates. Frozen.", Access::frozen)
      .field("axes", &PlacementMap::axes, "coordinates, 0 to 5; none, one or two")
      .field("points", &PlacementMap::points, "along each axis")
      .field("samples", &PlacementMap::samples, "Placement; the first axis varies fastest")
      .done(false);
}

void bind_outcome(py::module_& module) {
  StructBinding<PlacedProblem>(module, "PlacedProblem",
                               "The problem as it is with part, or robot, elsewhere. Frozen.",
                               Access::frozen)
      .field("problem", &PlacedProblem::problem, "in the frame of the base where it then is")
      .field("part_frame", &PlacedProblem::part_frame, "of the part")
      .field("motion", &PlacedProblem::motion, "new pose = motion * old pose")
      .field("moved", &PlacedProblem::moved, "names of objects")
      .done(false);
  StructBinding<PlacementPlans>(module, "PlacementPlans",
                                "A placement, planned in both modes. Frozen.", Access::frozen)
      .field("placed", &PlacementPlans::placed, "PlacedProblem")
      .field("graph_only", &PlacementPlans::graph_only, "PlanResult")
      .field("two_stage", &PlacementPlans::two_stage, "PlanResult")
      .done(false);
  StructBinding<PlacementResult>(module, "PlacementResult", "What place() returns. Frozen.",
                                 Access::frozen)
      .field("status", &PlacementResult::status, "Status")
      .field("given", &PlacementResult::given, "Placement with offset zero")
      .field("found", &PlacementResult::found, "Placement; where infeasible: with least missing")
      .field("before", &PlacementResult::before, "PlacementPlans of the given one")
      .field("after", &PlacementResult::after, "PlacementPlans of the one found")
      .field("map", &PlacementResult::map, "PlacementMap")
      .field("evaluations", &PlacementResult::evaluations, "placements measured")
      .field("obstacles", &PlacementResult::obstacles, "reason -> placements; \"\" where feasible")
      .field("out_of_time", &PlacementResult::out_of_time, "whether the time limit ended it")
      .field("seconds", &PlacementResult::seconds, "that it took")
      .field("diagnosis", &PlacementResult::diagnosis, "Diagnosis")
      .done(false);
}

}  // namespace

void bind_placement(py::module_& module) {
  bind_request(module);
  bind_measure(module);
  bind_outcome(module);
  module.def(
      "load_placement",
      [](const std::filesystem::path& file, const LoadOptions& options) {
        const LoadOptions copy = options;
        const py::gil_scoped_release unlocked;
        return load_placement(file, copy);
      },
      py::arg("file"), py::arg("options") = LoadOptions(),
      "Reads a problem file with its `placement` section. Raises InvalidInput.");
  module.def(
      "place",
      [](const PlacementRequest& request, const PythonPlanOptions& options) {
        PlannerRun run(options);
        PlacementRequest copy = request;
        copy.problem = run.guarded(request.problem);
        return run([&] { return place(copy, run.options()); });
      },
      py::arg("request"), py::arg("options") = PythonPlanOptions(),
      "Looks for the placement with the least measure. Ctrl-C stops it. Raises InvalidInput.");
  module.def("placed", &placed, py::arg("request"), py::arg("offset"),
             "What moving by an offset, shape (6,), m and rad, makes of the problem.");
}

}  // namespace wristwise::python
