#include "bindings.hpp"
#include "wristwise/scene.hpp"

namespace wristwise::python {

void bind_scene(py::module_& module) {
  py::enum_<CollisionScope>(module, "CollisionScope", "Which distances count.")
      .value("all", CollisionScope::all, "robot against objects and against itself")
      .value("off", CollisionScope::off, "none")
      .value("pairs", CollisionScope::pairs, "only the pairs listed");
  StructBinding<SceneObject>(module, "SceneObject", "What the robot must keep clear of. Frozen.",
                             Access::frozen)
      .field("name", &SceneObject::name, "each object has its own")
      .required()
      .field("shapes", &SceneObject::shapes, "Shape, with poses in the frame of `link`")
      .required()
      .field("link", &SceneObject::link, "of the robot, to which it is fixed; empty: the base link")
      .field("convex_error", &SceneObject::convex_error,
             "of a mesh cut into convex pieces: m, no point of a shape is farther from the object")
      .done();
  StructBinding<Scene>(module, "Scene", "All that the robot must keep clear of.", Access::writable)
      .field("objects", &Scene::objects, "SceneObject")
      .field("scope", &Scene::scope, "CollisionScope")
      .field("pairs", &Scene::pairs,
             "names of links or objects, by two; used with CollisionScope.pairs")
      .field("disabled", &Scene::disabled, "pairs of names that are never measured")
      .field("find_permanent_contacts", &Scene::find_permanent_contacts,
             "find the pairs that are in contact at every sampled posture, and leave them out")
      .field("clearance", &Scene::clearance, "m, the least signed distance that is accepted")
      .field("warnings", &Scene::warnings, "what the reader of the scene should know")
      .done();
}

}  // namespace wristwise::python
