// Concave meshes in convex pieces. What is inside and how far away is told by cubes on a grid, by
// counting crossings of rays, and by another library.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <cmath>

#include "collision/hull_planes.hpp"
#include "collision/signed_distance.hpp"
#include "collision_samples.hpp"
#include "invalid_input.hpp"
#include "mesh_samples.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {
namespace {

using test::Cubes;
using test::prism;
using test::says;
using test::TemporaryFolder;
using test::Triangles;

MeshBody cut(const Triangles& triangles, double error, bool sheet = false) {
  const TemporaryFolder folder;
  MeshOptions options;
  options.convex_error = error;
  options.sheet = sheet;
  return load_mesh(folder.write("part.stl", test::ascii_stl(triangles)), {1, 1, 1}, options);
}

double volume_of(const MeshBody& body) {
  double volume = 0;
  for (const ConvexHull& piece : body.pieces) volume += hull_volume(piece);
  return volume;
}

bool in_a_piece(const MeshBody& body, const Eigen::Vector3d& point, double slack) {
  return std::any_of(body.pieces.begin(), body.pieces.end(),
                     [&](const ConvexHull& piece) { return test::contains(piece, point, slack); });
}

/// A point of a hull, sometimes on its surface.
Eigen::Vector3d random_point_of(std::mt19937& random, const ConvexHull& hull) {
  const std::size_t corners = 2 + random() % 3;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    const double weight = test::uniform(random, 0, 1);
    point += weight * hull.vertices[random() % hull.vertices.size()];
    sum += weight;
  }
  return point / sum;
}

/// Whether a ray to a far point crosses the surface an odd number of times.
bool inside_by_crossings(const Triangles& triangles, const Eigen::Vector3d& point) {
  const Eigen::Vector3d ray = Eigen::Vector3d(0.5413, 0.3291, 0.7736).normalized();
  int crossings = 0;
  for (const auto& [a, b, c] : triangles) {
    Eigen::Matrix3d system;
    system << b - a, c - a, -ray;
    const Eigen::Vector3d solution = system.inverse() * (point - a);
    if (solution.x() >= 0 && solution.y() >= 0 && solution.x() + solution.y() <= 1 &&
        solution.z() > 0) {
      ++crossings;
    }
  }
  return crossings % 2 == 1;
}

Cubes random_cubes(std::mt19937& random) {
  std::set<Cubes::Cell> cells = {{0, 0, 0}};
  const std::size_t count = 3 + random() % 12;
  while (cells.size() < count) {
    auto grown = std::next(cells.begin(), static_cast<long>(random() % cells.size()));
    Cubes::Cell cell = *grown;
    cell[random() % 3] += random() % 2 ? 1 : -1;
    if (std::all_of(cell.begin(), cell.end(), [](int i) { return std::abs(i) <= 2; })) {
      cells.insert(cell);
    }
  }
  return Cubes(cells);
}

TEST(ConvexCut, HoldsTheSolidAndReachesNoFartherThanSaid) {
  std::mt19937 random(71);
  int exact = 0, within = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const Cubes cubes = random_cubes(random);
    const Pose pose = sample % 2 ? test::random_pose(random, 1) : Pose::Identity();
    const double scale = test::uniform(random, 0.01, 1);
    const double asked = scale * (sample % 3 == 0 ? 0.3 : 0.02);
    const MeshBody body = cut(test::transformed(cubes.surface(), pose, scale), asked);
    ASSERT_TRUE(body.error.has_value());
    if (body.warnings.empty()) {
      EXPECT_LE(*body.error, 1.001 * asked);
      ++within;
    }
    if (*body.error < 1e-4 * scale) ++exact;
    const double slack = 2e-6 * (1 + 5 * scale);
    for (const Cubes::Cell& cell : cubes.cells()) {
      for (int i = 0; i < 20; ++i) {
        const auto coordinate = [&](int low) {
          return low + (random() % 4 ? test::uniform(random, 0, 1) : double(random() % 2));
        };
        const Eigen::Vector3d point(coordinate(cell[0]), coordinate(cell[1]), coordinate(cell[2]));
        ASSERT_TRUE(in_a_piece(body, pose * Eigen::Vector3d(scale * point), slack))
            << "sample " << sample << ": " << point.transpose();
      }
    }
    for (const ConvexHull& piece : body.pieces) {
      for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d point = pose.inverse() * random_point_of(random, piece) / scale;
        ASSERT_LE(scale * cubes.distance(point), *body.error + slack) << "sample " << sample;
      }
    }
  }
  EXPECT_GT(within, 30);  // the others touch themselves along an edge, and are filled
  EXPECT_GT(exact, 20);
}

TEST(ConvexCut, CurvedSolidsAreHeld) {
  const auto torus = test::closed_grid(48, 24, [](int i, int j) {
    const double u = 2 * test::kPi * i / 48, v = 2 * test::kPi * j / 24;
    const double radius = 0.1 + 0.03 * std::cos(v);
    return Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), 0.03 * std::sin(v));
  });
  const std::array<Eigen::Vector2d, 4> profile = {
      Eigen::Vector2d(0.04, 0), {0.05, 0}, {0.05, 0.2}, {0.04, 0.2}};
  const auto pipe = test::closed_grid(40, 4, [&](int i, int j) {
    const double u = 2 * test::kPi * i / 40;
    const Eigen::Vector2d& at = profile[static_cast<std::size_t>(j)];
    return Eigen::Vector3d(at.x() * std::cos(u), at.x() * std::sin(u), at.y());
  });
  std::mt19937 random(72);
  for (const Triangles& mesh : {torus, pipe}) {
    const MeshBody body = cut(mesh, 0.003);
    EXPECT_TRUE(body.warnings.empty());
    EXPECT_LE(*body.error, 0.00301);
    EXPECT_LE(body.pieces.size(), 30U);
    EXPECT_FALSE(in_a_piece(body, {0, 0, 0.05}, 0));  // the hole
    int inside = 0;
    for (int i = 0; i < 8000; ++i) {
      const Eigen::Vector3d point =
          test::random_point(random, 0.13).cwiseProduct(Eigen::Vector3d(1, 1, i % 2 ? 1 : 0.2));
      if (!inside_by_crossings(mesh, point)) continue;
      ++inside;
      ASSERT_TRUE(in_a_piece(body, point, 1e-6)) << point.transpose();
    }
    EXPECT_GT(inside, 100);
  }
}

using Bvh = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Bvh> bvh_of(const Triangles& triangles) {
  auto model = std::make_shared<Bvh>();
  model->beginModel();
  for (const auto& [a, b, c] : triangles) model->addTriangle(a, b, c);
  model->endModel();
  return model;
}

TEST(ConvexCut, DistancesAreThoseOfTheMeshLessTheErrorAtMost) {
  const auto ring = test::closed_grid(32, 12, [](int i, int j) {
    const double u = 2 * test::kPi * i / 32, v = 2 * test::kPi * j / 12;
    const double radius = 0.1 + 0.03 * std::cos(v);
    return Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), 0.05 * std::sin(v));
  });
  const Cubes u_profile({{-1, 0, 0}, {-1, 0, 1}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}});
  const Triangles profile = test::transformed(u_profile.surface(), Pose::Identity(), 0.05);
  const Triangles probe = test::transformed(Cubes({{0, 0, 0}}).surface(),
                                            Pose(Eigen::Translation3d(-0.01, -0.01, -0.01)), 0.02);
  const auto probe_bvh = bvh_of(probe);
  const Geometry box = Box{{0.02, 0.02, 0.02}};
  std::mt19937 random(73);
  for (const Triangles& mesh : {ring, profile}) {
    const MeshBody body = cut(mesh, 0.002);
    const auto bvh = bvh_of(mesh);
    int separated = 0, near = 0;
    for (int i = 0; i < 400; ++i) {
      const Pose pose = test::random_pose(random, 0.15);
      fcl::DistanceRequestd request;
      fcl::DistanceResultd found;
      const Eigen::Isometry3d place(pose.matrix());
      fcl::distance(bvh.get(), Eigen::Isometry3d::Identity(), probe_bvh.get(), place, request,
                    found);
      if (found.min_distance <= 1e-9 || inside_by_crossings(mesh, pose.translation())) continue;
      ++separated;
      double distance = 1e300;
      for (const ConvexHull& piece : body.pieces) {
        const Geometry geometry = piece;
        distance =
            std::min(distance, signed_distance({geometry, Pose::Identity()}, {box, pose}).distance);
      }
      EXPECT_LE(distance, found.min_distance + 2e-6);
      EXPECT_GE(distance, found.min_distance - *body.error - 2e-6);
      if (found.min_distance < 0.02) ++near;
    }
    EXPECT_GT(separated, 200);
    EXPECT_GT(near, 20);
  }
}

TEST(ConvexCut, ProfilesAreCutExactly) {
  struct Profile {
    std::string name;
    std::set<Cubes::Cell> cells;
    std::size_t pieces;
  };
  for (const Profile& profile :
       {Profile{"box", {{0, 0, 0}, {1, 0, 0}}, 1},
        Profile{"L", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2},
        Profile{"T", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, 2},
        Profile{"U", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, 3},
        Profile{"corner", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3}}) {
    const MeshBody body = cut(
        test::transformed(Cubes(profile.cells).surface(),
                          Pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized())), 0.1),
        0.001);
    EXPECT_EQ(body.pieces.size(), profile.pieces) << profile.name;
    EXPECT_NEAR(volume_of(body), 0.001 * static_cast<double>(profile.cells.size()), 1e-8)
        << profile.name;
    EXPECT_LT(*body.error, 1e-6) << profile.name;
  }
}

const Triangles kBentSheet = {{Eigen::Vector3d(0, 0, 0), {0.1, 0, 0}, {0.1, 0, 0.3}},
                              {Eigen::Vector3d(0, 0, 0), {0.1, 0, 0.3}, {0, 0, 0.3}},
                              {Eigen::Vector3d(0, 0, 0), {0, 0, 0.3}, {0, 0.08, 0.3}},
                              {Eigen::Vector3d(0, 0, 0), {0, 0.08, 0.3}, {0, 0.08, 0}}};

TEST(ConvexCut, SheetsAreSurfacesWhereTheySaySo) {
  const MeshBody sheet = cut(kBentSheet, 0.002, true);
  EXPECT_EQ(sheet.pieces.size(), 2U);
  EXPECT_TRUE(sheet.warnings.empty());
  EXPECT_LE(*sheet.error, 0.002);
  EXPECT_LT(volume_of(sheet), 1e-6);
  std::mt19937 random(74);
  for (int i = 0; i < 500; ++i) {
    const auto& [a, b, c] = kBentSheet[random() % 4];
    const double u = test::uniform(random, 0, 1), v = test::uniform(random, 0, 1 - u);
    EXPECT_TRUE(in_a_piece(sheet, a + u * (b - a) + v * (c - a), 1e-9));
  }
  const MeshBody solid = cut(kBentSheet, 0.002);
  EXPECT_EQ(solid.pieces.size(), 1U);
  ASSERT_EQ(solid.warnings.size(), 1U);
  EXPECT_TRUE(says(solid.warnings[0], "not closed")) << solid.warnings[0];
  // The hull of a right angle of 100 mm x 80 mm: its middle is 40 mm from both legs.
  EXPECT_GE(*solid.error, 0.04);
  EXPECT_LE(*solid.error, 0.07);
}

TEST(ConvexCut, DefectsAreMendedOrFilled) {
  const std::vector<Eigen::Vector2d> letter{{0, 0},     {0.2, 0},   {0.2, 0.1},
                                            {0.1, 0.1}, {0.1, 0.2}, {0, 0.2}};
  const Triangles sound = prism(letter, 0.1);
  Triangles turned = sound, repeated = sound, open = sound, cracked = sound;
  for (std::size_t i = 0; i < turned.size(); i += 3) std::swap(turned[i][0], turned[i][1]);
  repeated.insert(repeated.end(), sound.begin(), sound.begin() + 5);
  repeated.push_back({sound[0][0], sound[0][0], sound[0][1]});
  open.pop_back();
  std::mt19937 random(75);
  for (auto& triangle : cracked) {
    for (auto& v : triangle) v += test::random_point(random, 2e-8);
  }
  for (const Triangles& mended : {sound, turned, repeated, cracked}) {
    const MeshBody body = cut(mended, 0.001);
    EXPECT_EQ(body.pieces.size(), 2U);
    EXPECT_TRUE(body.warnings.empty());
    EXPECT_NEAR(volume_of(body), 0.003, 1e-7);
  }
  const MeshBody filled = cut(open, 0.001);
  EXPECT_EQ(filled.pieces.size(), 1U);
  EXPECT_NEAR(volume_of(filled), 0.0035, 1e-7);
  ASSERT_EQ(filled.warnings.size(), 1U);
}

TEST(ConvexCut, VoidsAreFilled) {
  std::set<Cubes::Cell> cells;
  for (int i = 0; i < 27; ++i) cells.insert({i % 3, i / 3 % 3, i / 9});
  cells.erase({1, 1, 1});
  const MeshBody body = cut(Cubes(cells).surface(), 0.01);
  EXPECT_TRUE(in_a_piece(body, {1.5, 1.5, 1.5}, 0));
  EXPECT_NEAR(hull_volume(body.pieces.at(0)), 27, 1e-6);
}

TEST(ConvexCut, MeshesInMillimetresAreWarnedOf) {
  const MeshBody body = cut(prism({{0, 0}, {150, 0}, {150, 10}, {0, 10}}, 400), 0.002);
  ASSERT_EQ(body.warnings.size(), 1U);
  EXPECT_TRUE(says(body.warnings[0], "400 m across; in mm it needs the scale 0.001"));
}

TEST(ConvexCut, WithinItsLimitsItSaysHowFarItGot) {
  const auto comb = [] {
    std::set<Cubes::Cell> cells;
    for (int i = 0; i < 13; ++i) {
      for (int j = 0; j < 13; ++j) {
        cells.insert({i, j, 0});
        if (i % 2 == 0 && j % 2 == 0) cells.insert({i, j, 1});
      }
    }
    return Cubes(cells);
  }();
  const MeshBody body = cut(comb.surface(), 1e-3);
  EXPECT_LE(body.pieces.size(), 128U);
  EXPECT_LT(*body.error, 1.0);  // the hull alone would be 0.7 off
  for (int i = 0; i < 13; ++i) EXPECT_TRUE(in_a_piece(body, {i + 0.5, 6.5, 0.5}, 1e-6));
}

TEST(ConvexCut, HugeMeshesAreFilled) {
  const auto torus = test::closed_grid(200, 130, [](int i, int j) {
    const double u = 2 * test::kPi * i / 200, v = 2 * test::kPi * j / 130;
    const double radius = 0.1 + 0.03 * std::cos(v);
    return Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), 0.03 * std::sin(v));
  });
  const TemporaryFolder folder;
  MeshOptions options;
  options.convex_error = 0.002;
  const auto file = folder.write("part.stl", test::binary_stl(torus));
  const MeshBody body = load_mesh(file, {1, 1, 1}, options);
  ASSERT_EQ(body.pieces.size(), 1U);
  EXPECT_LT(body.pieces[0].vertices.size(), 2000U);
  ASSERT_EQ(body.warnings.size(), 1U);
  EXPECT_TRUE(says(body.warnings[0], "52000 triangles, more than 50000, is not cut but filled"));
  // The hole: its middle, at the height of the rings' tops, is 0.1 from their axis.
  const double farthest = std::hypot(0.1, 0.03) - 0.03;
  EXPECT_GE(*body.error, farthest - 1e-4);
  EXPECT_LE(*body.error, 1.6 * farthest);
}

TEST(ConvexCut, UnusableErrorIsRefused) {
  const Triangles cube = Cubes({{0, 0, 0}}).surface();
  for (const double error : {0.0, -1.0, std::nan(""), 1.0 / 0.0}) {
    EXPECT_TRUE(says(test::invalid_input([&] { cut(cube, error); }), "convex_error"));
  }
}

}  // namespace
}  // namespace wristwise
