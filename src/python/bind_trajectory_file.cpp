#include "bindings.hpp"
#include "wristwise/program_file.hpp"
#include "wristwise/trajectory_file.hpp"

namespace wristwise::python {

namespace {

void expect_names(const std::vector<std::string>& names, const std::vector<JointVector>& rows) {
  if (!rows.empty() && names.size() != static_cast<std::size_t>(rows.front().size()))
    throw InvalidInput("joint_names", std::to_string(names.size()),
                       std::to_string(rows.front().size()) + ", one for each joint");
}

}  // namespace

void bind_trajectory_file(py::module_& module) {
  StructBinding<TrajectoryFile>(module, "TrajectoryFile", "What a trajectory.csv holds. Frozen.",
                                Access::frozen)
      .field("path", &TrajectoryFile::path, "JointPath, the points")
      .field("trajectory", &TrajectoryFile::trajectory,
             "Trajectory, where there are velocity and acceleration columns")
      .field("seam_time", &TrajectoryFile::seam_time,
             "the time law of the seam (s), where there are its columns")
      .done(false);
  py::class_<SeamColumns>(module, "SeamColumns",
                          "What a trajectory file says about the seam, beside the joints.")
      .def(py::init<>(), "Nothing.")
      .def(py::init([](const Task& task) {
             if (task.waypoints.empty())
               throw InvalidInput("task.waypoints", "none", "at least one");
             return SeamColumns(task);
           }),
           py::arg("task"),
           "`welding` where the task has a run-in or run-out, `seam_time...` where it is retimed.")
      .def_property_readonly("names", &SeamColumns::names, "of the columns");

  module.def("read_trajectory", &read_trajectory, py::arg("file"), py::arg("joint_names"),
             "Reads a CSV file `time,<joint>,...` (s, rad or m), extra columns ignored. Raises "
             "InvalidInput with file and line.");
  module.def(
      "write_path",
      [](const std::filesystem::path& file, const std::vector<std::string>& joint_names,
         const JointPath& path, const SeamColumns& seam) {
        expect_names(joint_names, path.positions);
        write_path(file, joint_names, path, seam);
      },
      py::arg("file"), py::arg("joint_names"), py::arg("path"), py::arg("seam") = SeamColumns(),
      "Writes a JointPath as CSV, with as many digits as give the same numbers back.");
  module.def(
      "write_trajectory",
      [](const std::filesystem::path& file, const std::vector<std::string>& joint_names,
         const Trajectory& trajectory, const SeamColumns& seam) {
        expect_names(joint_names, trajectory.positions());
        write_trajectory(file, joint_names, trajectory, seam);
      },
      py::arg("file"), py::arg("joint_names"), py::arg("trajectory"),
      py::arg("seam") = SeamColumns(),
      "Writes a Trajectory as CSV: times, positions, velocities, accelerations.");
  module.def(
      "write_dense",
      [](const std::filesystem::path& file, const std::vector<std::string>& joint_names,
         const Trajectory& trajectory, double period, const SeamColumns& seam) {
        if (!(period > 0)) throw InvalidInput("period", std::to_string(period), "more than 0 s");
        if (trajectory.empty()) throw InvalidInput("trajectory", "empty", "one with pieces");
        expect_names(joint_names, trajectory.positions());
        write_dense(file, joint_names, trajectory, period, seam);
      },
      py::arg("file"), py::arg("joint_names"), py::arg("trajectory"), py::arg("period"),
      py::arg("seam") = SeamColumns(),
      "The curve sampled every `period` s, and at its end, as CSV.");
}

}  // namespace wristwise::python
