#include "wristwise/mesh.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "collision_samples.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

std::string path_of(const std::string& name) { return ::testing::TempDir() + name; }

std::string write_text(const std::string& name, const std::string& text) {
  std::ofstream(path_of(name)) << text;
  return path_of(name);
}

std::string write_ascii_stl(const std::string& name, const Triangles& triangles) {
  std::ostringstream text;
  text << "solid test\n";
  for (const auto& triangle : triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const auto& v : triangle) text << "vertex " << v.transpose() << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid test\n";
  return write_text(name, text.str());
}

std::string write_binary_stl(const std::string& name, const Triangles& triangles) {
  std::ofstream file(path_of(name), std::ios::binary);
  const std::string header(80, ' ');
  file.write(header.data(), 80);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  file.write(reinterpret_cast<const char*>(&count), 4);
  for (const auto& triangle : triangles) {
    std::array<float, 12> numbers{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < 3; ++i) {
        numbers[3 + 3 * c + static_cast<std::size_t>(i)] = static_cast<float>(triangle[c][i]);
      }
    }
    file.write(reinterpret_cast<const char*>(numbers.data()), 48);
    file.write("\0\0", 2);
  }
  return path_of(name);
}

/// A prism: the polygon (counter-clockwise, a fan from its first corner) from z = 0 to `height`.
Triangles prism(const std::vector<Eigen::Vector2d>& polygon, double height,
                const Eigen::Vector3d& offset = Eigen::Vector3d::Zero()) {
  Triangles triangles;
  const auto at = [&](std::size_t i, double z) {
    const Eigen::Vector2d& corner = polygon[i % polygon.size()];
    return Eigen::Vector3d(Eigen::Vector3d(corner.x(), corner.y(), z) + offset);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    triangles.push_back({at(i, 0), at(i + 1, 0), at(i + 1, height)});
    triangles.push_back({at(i, 0), at(i + 1, height), at(i, height)});
    if (i == 0 || i + 1 == polygon.size()) continue;
    triangles.push_back({at(0, 0), at(i + 1, 0), at(i, 0)});
    triangles.push_back({at(0, height), at(i, height), at(i + 1, height)});
  }
  return triangles;
}

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

void expect_invalid(const std::string& file, const std::string& part) {
  try {
    load_mesh(file, {1, 1, 1});
    FAIL() << file << " was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(LoadMesh, CubeHasItsVolumeWhateverTheFormat) {
  const Triangles cube = prism(kSquare, 1);
  std::string obj;
  for (const int z : {0, 1}) {
    for (const char* corner : {"0 0", "1 0", "1 1", "0 1"}) {
      obj += std::string("v ") + corner + " " + std::to_string(z) + "\n";
    }
  }
  obj += "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  for (const std::string& file :
       {write_ascii_stl("ww_cube_ascii.stl", cube), write_binary_stl("ww_cube_binary.stl", cube),
        write_text("ww_cube.obj", obj)}) {
    const auto hulls = load_mesh(file, {1, 1, 1}).pieces;
    ASSERT_EQ(hulls.size(), 1U) << file;
    EXPECT_EQ(hulls[0].vertices.size(), 8U) << file;
    EXPECT_NEAR(volume_of(hulls[0]), 1, 1e-9) << file;
    expect_closed_and_outward(hulls[0]);
  }
}

TEST(LoadMesh, ScaleIsPerAxisAndMayMirror) {
  const std::string file = write_binary_stl("ww_scaled.stl", prism(kSquare, 1));
  const auto hulls = load_mesh(file, {0.001, 0.002, -0.003}).pieces;
  EXPECT_NEAR(volume_of(hulls.at(0)), 6e-9, 1e-18);
  for (const auto& vertex : hulls[0].vertices) EXPECT_LE(vertex.z(), 0);
  expect_closed_and_outward(hulls[0]);
}

TEST(LoadMesh, SeparateCubesAreSeparateHulls) {
  Triangles both = prism(kSquare, 1);
  for (const auto& triangle : prism(kSquare, 2, {5, 0, 0})) both.push_back(triangle);
  const auto hulls = load_mesh(write_ascii_stl("ww_two.stl", both), {1, 1, 1}).pieces;
  ASSERT_EQ(hulls.size(), 2U);
  EXPECT_NEAR(volume_of(hulls[0]), 1, 1e-9);
  EXPECT_NEAR(volume_of(hulls[1]), 2, 1e-9);
}

TEST(LoadMesh, ConcavePieceIsFilled) {
  const auto hulls = load_mesh(write_ascii_stl("ww_l.stl", prism(kLetterL, 1)), {1, 1, 1}).pieces;
  ASSERT_EQ(hulls.size(), 1U);
  EXPECT_NEAR(volume_of(hulls[0]), 3.5, 1e-9);
}

TEST(LoadMesh, LooseTrianglesAreHeldByOneHull) {
  Triangles mesh = prism(kSquare, 1);
  mesh.push_back({Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(4, 0, 0), Eigen::Vector3d(3, 1, 0)});
  const auto hulls = load_mesh(write_ascii_stl("ww_loose.stl", mesh), {1, 1, 1}).pieces;
  ASSERT_EQ(hulls.size(), 1U);
  for (const auto& triangle : mesh) {
    for (const auto& vertex : triangle) EXPECT_TRUE(test::contains(hulls[0], vertex, 1e-9));
  }
}

TEST(LoadMesh, UnusableFilesAreNamed) {
  expect_invalid(path_of("ww_missing.stl"), "no such file");
  expect_invalid(::testing::TempDir(), "no such file");
  expect_invalid(write_text("ww_empty.stl", ""), "");
  expect_invalid(write_text("ww_noise.stl", "neither text nor triangles"), "");
  expect_invalid(write_text("ww_unknown.format", "x"), "cannot be read");
  expect_invalid(write_ascii_stl("ww_no_triangles.stl", {}), "");
  const Triangles flat{
      {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)},
      {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0)}};
  expect_invalid(write_binary_stl("ww_flat.stl", flat), "no volume");
  Triangles broken = prism(kSquare, 1);
  broken[3][1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_invalid(write_binary_stl("ww_nan.stl", broken), "");
  broken[3][1].y() = std::numeric_limits<double>::infinity();
  expect_invalid(write_binary_stl("ww_inf.stl", broken), "");
}

TEST(LoadMesh, UnusableScaleIsRefused) {
  const std::string file = write_binary_stl("ww_scale.stl", prism(kSquare, 1));
  EXPECT_THROW(load_mesh(file, {1, 0, 1}), InvalidInput);
  EXPECT_THROW(load_mesh(file, {1, std::nan(""), 1}), InvalidInput);
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
