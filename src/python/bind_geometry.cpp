#include "bindings.hpp"
#include "wristwise/geometry.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise::python {

namespace {

void bind_shapes(py::module_& module) {
  StructBinding<Box>(module, "Box", "A box about its origin. Frozen.", Access::frozen)
      .field("size", &Box::size, "full edge lengths, m, shape (3,)")
      .required()
      .done();
  StructBinding<Sphere>(module, "Sphere", "A sphere about its origin. Frozen.", Access::frozen)
      .field("radius", &Sphere::radius, "m")
      .required()
      .done();
  StructBinding<Cylinder>(module, "Cylinder", "A cylinder along z about its origin. Frozen.",
                          Access::frozen)
      .field("radius", &Cylinder::radius, "m")
      .required()
      .field("length", &Cylinder::length, "m")
      .required()
      .done();
  StructBinding<ConvexHull>(module, "ConvexHull",
                            "A convex polyhedron; made by convex_hull(). Frozen.", Access::frozen)
      .field("vertices", &ConvexHull::vertices, "m, shape (N, 3)")
      .required()
      .field("triangles", &ConvexHull::triangles,
             "indices of vertices, outward, counter-clockwise, shape (M, 3)")
      .required()
      .checked([](const ConvexHull& hull) {
        for (const auto& triangle : hull.triangles)
          for (const int corner : triangle)
            expect_index("ConvexHull.triangles", corner, hull.vertices.size());
      })
      .done();
  StructBinding<Shape>(module, "Shape",
                       "A geometry placed in the frame of the body that carries it. Frozen.",
                       Access::frozen)
      .field("geometry", &Shape::geometry, "a Box, Sphere, Cylinder or ConvexHull")
      .required()
      .field("pose", &Shape::pose, "of the geometry, in the body's frame")
      .done();
}

void bind_meshes(py::module_& module) {
  StructBinding<MeshOptions>(module, "MeshOptions", "How meshes are read.", Access::writable)
      .field("convex_error", &MeshOptions::convex_error,
             "concave parts are cut into convex pieces that reach at most so far (m) beyond the "
             "part; None: the convex hull of each connected part")
      .field("sheet", &MeshOptions::sheet, "only the surface is material, though the mesh be open")
      .field("turn_up_axis", &MeshOptions::turn_up_axis, "COLLADA: turn the file's up axis to z")
      .field("cache", &MeshOptions::cache, "folder for results of earlier runs; None: no cache")
      .done();
  StructBinding<MeshBody>(module, "MeshBody",
                          "A mesh as convex pieces, which together contain it. Frozen.",
                          Access::frozen)
      .field("pieces", &MeshBody::pieces, "ConvexHull")
      .field("error", &MeshBody::error,
             "m, no point of a piece is farther from the part; None where nobody asked")
      .field("warnings", &MeshBody::warnings, "one line each")
      .done(false);
  module.def(
      "load_mesh",
      [](const std::filesystem::path& file, const Eigen::Vector3d& scale,
         const MeshOptions& options) {
        const py::gil_scoped_release unlocked;
        return load_mesh(file, scale, options);
      },
      py::arg("file"), py::arg("scale"), py::arg("options") = MeshOptions(),
      "Reads a mesh (STL, OBJ, DAE ...) as convex pieces; scale (m per unit of the file) has shape "
      "(3,). Raises InvalidInput where the file is missing, unreadable or empty.");
  module.def(
      "convex_hull", &convex_hull, py::arg("points"), py::arg("where") = "points",
      "The convex hull of points (m), shape (N, 3). Raises InvalidInput, with `where` in its "
      "message, where they have no volume.");
}

}  // namespace

void bind_geometry(py::module_& module) {
  bind_shapes(module);
  bind_meshes(module);
  module.def("support_point", &support_point, py::arg("geometry"), py::arg("direction"),
             "The point (m) of the geometry that lies farthest along a direction, in the "
             "geometry's own frame: shape (3,).");
  module.def("bounding_radius", &bounding_radius, py::arg("geometry"),
             "Radius (m) of the least sphere about the geometry's origin that holds it.");
}

}  // namespace wristwise::python
