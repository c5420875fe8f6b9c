#include "bindings.hpp"
#include "python_inverse_kinematics.hpp"
#include "wristwise/problem.hpp"

namespace wristwise::python {

void bind_problem(py::module_& module) {
  StructBinding<Problem>(module, "Problem",
                         "Everything that a problem file says. Assigning to an attribute copies; "
                         "options are changed in place: problem.cost.jerk = 2.",
                         Access::writable)
      .field("name", &Problem::name, "of the file, without its extension")
      .field(
          "robot", [](const Problem& self) { return std::const_pointer_cast<Robot>(self.robot); },
          [](Problem& self, std::shared_ptr<Robot> robot) { self.robot = std::move(robot); },
          "Robot")
      .field(
          "inverse_kinematics",
          [](const Problem& self) {
            return std::const_pointer_cast<InverseKinematics>(self.inverse_kinematics);
          },
          [](Problem& self, py::object solver) { self.inverse_kinematics = solver_of(solver); },
          "the caller's own InverseKinematics; None: what find_inverse_kinematics() finds")
      .field("scene", &Problem::scene, "Scene")
      .field("task", &Problem::task, "Task")
      .field("cost", &Problem::cost, "CostOptions")
      .field("graph", &Problem::graph, "GraphOptions")
      .field("refine", &Problem::refine, "RefineOptions")
      .field("controller_period", &Problem::controller_period, "s, spacing of trajectory_dense.csv")
      .field("exports", &Problem::exports, "ExportOptions")
      .field("files", &Problem::files, "that it was read from")
      .done();
  StructBinding<LoadOptions>(module, "LoadOptions", "How a problem file is read.", Access::writable)
      .field("mesh_cache", &LoadOptions::mesh_cache,
             "keep the pieces of meshes in .wristwise_cache beside the problem")
      .done();
  module.def(
      "load_problem",
      [](const std::filesystem::path& file, const LoadOptions& options) {
        const LoadOptions copy = options;
        const py::gil_scoped_release unlocked;
        return load_problem(file, copy);
      },
      py::arg("file"), py::arg("options") = LoadOptions(),
      "Reads a problem file (YAML). Paths in it are relative to the file. Raises InvalidInput with "
      "file, key and what was expected.");
}

}  // namespace wristwise::python
