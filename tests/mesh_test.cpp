#include "wristwise/mesh.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "collision_samples.hpp"
#include "invalid_input.hpp"
#include "mesh_samples.hpp"

namespace wristwise {
namespace {

using test::prism;
using test::TemporaryFolder;
using test::Triangles;

const std::vector<Eigen::Vector2d> kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Eigen::Vector2d> kLetterL{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

double volume_of(const ConvexHull& hull) {
  double sixfold = 0;
  for (const auto& [i, j, k] : hull.triangles) {
    Eigen::Matrix3d corners;
    corners << hull.vertices.at(static_cast<std::size_t>(i)),
        hull.vertices.at(static_cast<std::size_t>(j)),
        hull.vertices.at(static_cast<std::size_t>(k));
    sixfold += corners.determinant();
  }
  return sixfold / 6;
}

void expect_closed_and_outward(const ConvexHull& hull) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& [i, j, k] : hull.triangles) {
    ++edges[{i, j}];
    ++edges[{j, k}];
    ++edges[{k, i}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  EXPECT_GT(volume_of(hull), 0);
}

class LoadMesh : public testing::Test {
 protected:
  MeshBody load(const std::string& name, const std::string& text,
                const Eigen::Vector3d& scale = {1, 1, 1}, const MeshOptions& options = {}) const {
    return load_mesh(folder_.write(name, text), scale, options);
  }

  void expect_invalid(const std::string& name, const std::string& text,
                      const std::string& part) const {
    const std::string message = test::invalid_input([&] { load(name, text); });
    EXPECT_TRUE(test::says(message, (folder_.path() / name).string())) << message;
    EXPECT_TRUE(test::says(message, part)) << message;
    EXPECT_FALSE(test::says(message, "\n")) << message;
  }

  TemporaryFolder folder_;
};

std::string cube_obj() {
  std::string obj = "mtllib none.mtl\n";
  for (const int z : {0, 1}) {
    for (const char* corner : {"0 0", "1 0", "1 1", "0 1"}) {
      obj += std::string("v ") + corner + " " + std::to_string(z) + "\n";
    }
  }
  return obj + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

/// A box of 1 x 2 x 3 units from the origin on, in a node that is moved by (10, 20, 30) units.
std::string box_dae(const std::string& unit, const std::string& up) {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="u" meter=")" +
         unit + R"("/><up_axis>)" + up + R"(</up_axis></asset>
 <library_geometries><geometry id="g" name="g"><mesh>
  <source id="p"><float_array id="a" count="24">0 0 0 1 0 0 1 2 0 0 2 0 0 0 3 1 0 3 1 2 3 0 2 3
  </float_array><technique_common><accessor source="#a" count="8" stride="3">
   <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
  </accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/>
   <p>0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node id="n">
  <matrix sid="transform">1 0 0 10 0 1 0 20 0 0 1 30 0 0 0 1</matrix><instance_geometry url="#g"/>
 </node></visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)";
}

Eigen::AlignedBox3d box_of(const MeshBody& body) {
  Eigen::AlignedBox3d box;
  for (const ConvexHull& piece : body.pieces) {
    for (const Eigen::Vector3d& vertex : piece.vertices) box.extend(vertex);
  }
  return box;
}

TEST_F(LoadMesh, CubeHasItsVolumeWhateverTheFormat) {
  const Triangles cube = prism(kSquare, 1);
  for (const MeshBody& body :
       {load("ascii.stl", test::ascii_stl(cube)), load("binary.STL", test::binary_stl(cube)),
        load("cube.obj", cube_obj())}) {
    ASSERT_EQ(body.pieces.size(), 1U);
    EXPECT_EQ(body.pieces[0].vertices.size(), 8U);
    EXPECT_NEAR(volume_of(body.pieces[0]), 1, 1e-9);
    EXPECT_FALSE(body.error.has_value());
    expect_closed_and_outward(body.pieces[0]);
  }
}

TEST_F(LoadMesh, ColladaHasItsOwnUnitAndUpAxis) {
  MeshOptions turned;
  turned.turn_up_axis = true;
  const Eigen::Vector3d low(10, 20, 30), high(11, 22, 33);
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    const auto box = box_of(load("as_it_is.dae", box_dae("0.0254", up), {2, 2, 2}));
    EXPECT_LT((box.min() - 0.0508 * low).norm(), 1e-6) << up;
    EXPECT_LT((box.max() - 0.0508 * high).norm(), 1e-6) << up;
  }
  const auto expect_turned = [&](const char* up, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to) {
    const auto box = box_of(load("turned.dae", box_dae("1", up), {1, 1, 1}, turned));
    EXPECT_LT((box.min() - from).norm(), 1e-5) << up << ": " << box.min().transpose();
    EXPECT_LT((box.max() - to).norm(), 1e-5) << up << ": " << box.max().transpose();
  };
  expect_turned("Z_UP", low, high);
  expect_turned("Y_UP", {10, -33, 20}, {11, -30, 22});    // (x, -z, y)
  expect_turned("X_UP", {-22, -33, 10}, {-20, -30, 11});  // (-y, -z, x)
}

TEST_F(LoadMesh, ScaleIsPerAxisAndMayMirror) {
  const auto body = load("a.stl", test::binary_stl(prism(kSquare, 1)), {0.001, 0.002, -0.003});
  EXPECT_NEAR(volume_of(body.pieces.at(0)), 6e-9, 1e-18);
  EXPECT_LE(box_of(body).max().z(), 0);
  expect_closed_and_outward(body.pieces[0]);
}

TEST_F(LoadMesh, SeparateCubesAreSeparateHulls) {
  Triangles both = prism(kSquare, 1);
  for (const auto& triangle : prism(kSquare, 2, {5, 0, 0})) both.push_back(triangle);
  const auto hulls = load("two.stl", test::ascii_stl(both)).pieces;
  ASSERT_EQ(hulls.size(), 2U);
  EXPECT_NEAR(volume_of(hulls[0]), 1, 1e-9);
  EXPECT_NEAR(volume_of(hulls[1]), 2, 1e-9);
}

TEST_F(LoadMesh, VeryManyPartsShareOneHull) {
  Triangles many;
  for (int i = 0; i < 70; ++i) {
    for (const auto& triangle : prism(kSquare, 1, {2.0 * i, 0, 0})) many.push_back(triangle);
  }
  const MeshBody body = load("many.stl", test::binary_stl(many));
  ASSERT_EQ(body.pieces.size(), 1U);
  EXPECT_NEAR(volume_of(body.pieces[0]), 139, 1e-6);
  ASSERT_EQ(body.warnings.size(), 2U);  // and it is more than 100 m long
  EXPECT_TRUE(test::says(body.warnings[1], "70 separate parts"));
}

TEST_F(LoadMesh, ConcavePieceIsFilledUnlessCut) {
  const auto hulls = load("l.stl", test::ascii_stl(prism(kLetterL, 1))).pieces;
  ASSERT_EQ(hulls.size(), 1U);
  EXPECT_NEAR(volume_of(hulls[0]), 3.5, 1e-9);
}

TEST_F(LoadMesh, LooseAndFlatTrianglesAreHeld) {
  Triangles mesh = prism(kSquare, 1);
  mesh.push_back({Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(4, 0, 0), Eigen::Vector3d(3, 1, 0)});
  mesh.push_back({Eigen::Vector3d(6, 0, 0), Eigen::Vector3d(7, 0, 0), Eigen::Vector3d(9, 0, 0)});
  const auto hulls = load("loose.stl", test::ascii_stl(mesh)).pieces;
  ASSERT_EQ(hulls.size(), 3U);
  EXPECT_LT(volume_of(hulls[1]), 1e-3);
  for (const auto& triangle : mesh) {
    for (const auto& vertex : triangle) {
      EXPECT_TRUE(std::any_of(hulls.begin(), hulls.end(), [&](const ConvexHull& hull) {
        return test::contains(hull, vertex, 1e-9);
      }));
    }
  }
}

TEST_F(LoadMesh, UnusableFilesAreNamed) {
  const Triangles cube = prism(kSquare, 1);
  const std::string binary = test::binary_stl(cube);
  EXPECT_TRUE(test::says(test::invalid_input([&] {
                           load_mesh(folder_.path() / "none.stl", {1, 1, 1});
                         }),
                         "no such file"));
  EXPECT_TRUE(test::says(test::invalid_input([&] {
                           load_mesh(folder_.path(), {1, 1, 1});
                         }),
                         "no such file"));
  expect_invalid("empty.stl", "", "the file is empty");
  expect_invalid("cut_head.stl", binary.substr(0, 60), "cut off in the header");
  expect_invalid("cut.stl", binary.substr(0, 300), "12 triangles has 300 bytes; expected 684");
  expect_invalid("noise.stl", "neither text nor triangles", "cut off");
  expect_invalid("unknown.format", "x", "cannot be read");
  expect_invalid("no_triangles.stl", test::ascii_stl({}), "");
  expect_invalid("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "");
  expect_invalid("one_point.stl",
                 test::binary_stl({{Eigen::Vector3d(1, 2, 3), {1, 2, 3}, {1, 2, 3}}}),
                 "all points are one");
  Triangles broken = cube;
  broken[3][1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_invalid("nan.stl", test::binary_stl(broken), "");
  expect_invalid("nan_text.stl", test::ascii_stl(broken), "");
  broken[3][1].y() = std::numeric_limits<double>::infinity();
  expect_invalid("inf.stl", test::binary_stl(broken), "");
  expect_invalid("no.dae", "<COLLADA><asset>", "not valid XML");
  expect_invalid("other.dae", "<robot/>", "no <COLLADA> element");
  std::string dae = box_dae("1", "Z_UP");
  expect_invalid("letters.dae", test::replaced(dae, "0 2 1 0", "0 2 x 0"), "<p> holds something");
  expect_invalid("no_count.dae", test::replaced(dae, "id=\"a\" count=\"24\"", "id=\"a\""),
                 "<float_array> has no count");
  expect_invalid("count.dae", test::replaced(dae, "count=\"24\"", "count=\"30\""),
                 "fewer numbers than its count");
  expect_invalid("wants.dae", test::replaced(dae, "count=\"8\"", "count=\"9\""),
                 "<accessor> wants more numbers");
}

TEST_F(LoadMesh, DamagedFilesNeverCrash) {
  const Triangles letter = prism(kLetterL, 1);
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.stl", test::binary_stl(letter)},
      {"t.stl", test::ascii_stl(letter)},
      {"a.obj", cube_obj()},
      {"a.dae", box_dae("0.001", "Y_UP")}};
  MeshOptions options;
  options.convex_error = 0.01;
  std::mt19937 random(33);
  int read = 0, refused = 0;
  for (int sample = 0; sample < 600; ++sample) {
    const auto& [name, sound] = files[static_cast<std::size_t>(sample) % files.size()];
    std::string text = sound;
    if (random() % 3 == 0) text.resize(random() % text.size());
    for (int flips = static_cast<int>(random() % 3); flips > 0 && !text.empty(); --flips) {
      char& c = text[random() % text.size()];
      c = static_cast<char>(c ^ static_cast<char>(1 << random() % 8));
    }
    try {
      const MeshBody body = load(name, text, {1, 1, 1}, options);
      EXPECT_FALSE(body.pieces.empty());
      ++read;
    } catch (const InvalidInput& error) {
      EXPECT_FALSE(test::says(error.what(), "\n")) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 100);
}

TEST_F(LoadMesh, UnusableScaleIsRefused) {
  const std::string text = test::binary_stl(prism(kSquare, 1));
  EXPECT_THROW(load("a.stl", text, {1, 0, 1}), InvalidInput);
  EXPECT_THROW(load("a.stl", text, {1, std::nan(""), 1}), InvalidInput);
}

TEST(ConvexHullOfPoints, HoldsThemAllAndIsClosed) {
  std::mt19937 random(31);
  for (int sample = 0; sample < 50; ++sample) {
    std::vector<Eigen::Vector3d> points;
    const int count = 4 + static_cast<int>(random() % 200);
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      points.push_back(sample % 2 ? test::random_point(random, 0.3)
                                  : Eigen::Vector3d(test::random_unit(random)));
    }
    const ConvexHull hull = convex_hull(points, "points");
    expect_closed_and_outward(hull);
    for (const auto& point : points) EXPECT_TRUE(test::contains(hull, point, 1e-9));
    if (sample % 2 == 0) {
      EXPECT_EQ(hull.vertices.size(), points.size());
    }
  }
}

TEST(ConvexHullOfPoints, GridOfCoplanarPointsIsABox) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(125);
  for (int i = 0; i < 125; ++i) points.emplace_back(i % 5, i / 5 % 5, i / 25);
  const ConvexHull hull = convex_hull(points, "grid");
  EXPECT_NEAR(volume_of(hull), 64, 1e-9);
  for (const auto& point : points) EXPECT_TRUE(test::contains(hull, point, 1e-9));
}

TEST(ConvexHullOfPoints, WithoutVolumeIsRefused) {
  std::mt19937 random(32);
  const Eigen::Matrix3d turn = test::random_pose(random, 0).linear();
  std::vector<Eigen::Vector3d> plane, line;
  for (int i = 0; i < 50; ++i) {
    Eigen::Vector3d point = test::random_point(random, 1);
    point.z() *= 1e-9;
    plane.emplace_back(turn * point);
    line.emplace_back(point.x() * turn.col(0));
  }
  EXPECT_THROW(convex_hull(plane, "plane"), InvalidInput);
  EXPECT_THROW(convex_hull(line, "line"), InvalidInput);
  EXPECT_THROW(convex_hull({}, "nothing"), InvalidInput);
  EXPECT_THROW(convex_hull(std::vector<Eigen::Vector3d>(9, {1, 2, 3}), "point"), InvalidInput);
  EXPECT_THROW(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}}, "nan"),
               InvalidInput);
}

}  // namespace
}  // namespace wristwise
