#include "bindings.hpp"
#include "wristwise/clearance.hpp"

namespace wristwise::python {

namespace {

/// A checker with a posture, which its measurements need.
struct CheckerAtPosture {
  explicit CheckerAtPosture(std::shared_ptr<const ClearanceModel> model)
      : checker(std::move(model)) {}

  void set_posture(const JointVector& q) {
    expect_joints(checker.model().robot(), q);
    checker.set_posture(q);
    has_posture = true;
  }

  ClearanceChecker& at_posture() {
    if (!has_posture) throw InvalidInput("ClearanceChecker", "no posture", "set_posture() before");
    return checker;
  }

  ClearanceChecker checker;
  bool has_posture = false;
};

void bind_model(py::module_& module) {
  py::class_<ClearanceModel, std::shared_ptr<ClearanceModel>>(
      module, "ClearanceModel",
      "The pairs of convex shapes of a robot and a scene whose distance counts. Immutable.")
      .def(py::init([](const std::shared_ptr<Robot>& robot, const Scene& scene) {
             return std::make_shared<ClearanceModel>(shared(robot, "robot"), scene);
           }),
           py::arg("robot"), py::arg("scene"),
           "Raises InvalidInput where a listed name is unknown, the clearance is negative, or a "
           "shape unusable.")
      .def_property_readonly("clearance", &ClearanceModel::clearance, "required, m")
      .def_property_readonly("permanent_contacts", &ClearanceModel::permanent_contacts,
                             "pairs of names that were left out")
      .def_property_readonly(
          "pair_names",
          [](const ClearanceModel& model) {
            std::vector<ClearanceModel::Names> names;
            for (std::size_t pair = 0; pair < model.pairs().size(); ++pair)
              names.push_back(model.names(static_cast<int>(pair)));
            return names;
          },
          "of each pair of shapes, the names of their bodies");
}

void bind_checker(py::module_& module) {
  py::class_<PairDistance>(module, "PairDistance", "Signed distance of a pair at one posture.")
      .def_readonly("pair", &PairDistance::pair, "index of the pair in the model")
      .def_readonly("distance", &PairDistance::distance, "m; negative: depth of penetration")
      .def_readonly("point_a", &PairDistance::point_a, "on shape a, base frame, m, shape (3,)")
      .def_readonly("point_b", &PairDistance::point_b, "on shape b, base frame, m, shape (3,)")
      .def_readonly("normal", &PairDistance::normal,
                    "unit, shape (3,); moving shape b along it increases the distance");
  py::class_<CheckerAtPosture>(module, "ClearanceChecker",
                               "Measures the pairs of a model at a posture. One per thread.")
      .def(py::init([](const std::shared_ptr<ClearanceModel>& model) {
             return CheckerAtPosture(shared(model, "model"));
           }),
           py::arg("model"), "Has no posture yet.")
      .def("set_posture", &CheckerAtPosture::set_posture, py::arg("q"),
           "Joint values, rad or m, shape (joints,).")
      .def(
          "distance",
          [](CheckerAtPosture& self, int pair) {
            expect_index("pair", pair, self.checker.model().pairs().size());
            return self.at_posture().distance(pair);
          },
          py::arg("pair"), "The signed distance, exact to 1e-6 m, in penetration too.")
      .def(
          "nearest",
          [](CheckerAtPosture& self, double cutoff) { return self.at_posture().nearest(cutoff); },
          py::arg("cutoff") = 1e9,
          "The pair with the least distance; None where there is none below the cutoff (m).");
}

}  // namespace

void bind_clearance(py::module_& module) {
  bind_model(module);
  bind_checker(module);
}

}  // namespace wristwise::python
