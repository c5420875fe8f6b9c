#include <cmath>
#include <cstdio>
#include <memory>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "collision/hull_planes.hpp"
#include "wristwise/error.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {

namespace {

// A hull thinner than this part of its size is flat: it has no inside to be deep in.
constexpr double kLeastThickness = 1e-6;

/// Qhull's state, and the file for messages that nobody wants, closed at the end.
class Qhull {
 public:
  Qhull() : messages_(std::tmpfile()) { qh_zero(&state_, messages_); }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int kept = 0, total = 0;
    qh_memfreeshort(&state_, &kept, &total);
    if (messages_) std::fclose(messages_);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  bool run(std::vector<double>& coordinates) {
    std::string command = "qhull Qt";
    return messages_ &&
           qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                        False, command.data(), nullptr, messages_) == 0;
  }
  qhT* state() { return &state_; }

 private:
  qhT state_{};
  std::FILE* messages_;
};

std::vector<std::array<int, 3>> triangles_of(qhT* qh) {
  std::vector<std::array<int, 3>> triangles;
  facetT* facet;
  FORALLfacets {
    setT* corners = qh_facet3vertex(qh, facet);
    std::array<int, 3> triangle{};
    std::size_t count = 0;
    vertexT *vertex, **vertexp;
    FOREACHvertex_(corners) {
      if (count < 3) triangle[count] = qh_pointid(qh, vertex->point);
      ++count;
    }
    qh_settempfree(qh, &corners);
    if (count == 3) triangles.push_back(triangle);
  }
  return triangles;
}

double area_of(const ConvexHull& hull) {
  double twice = 0;
  for (const auto& [i, j, k] : hull.triangles) {
    const Eigen::Vector3d& origin = hull.vertices[static_cast<std::size_t>(i)];
    const Eigen::Vector3d b = hull.vertices[static_cast<std::size_t>(j)] - origin;
    const Eigen::Vector3d c = hull.vertices[static_cast<std::size_t>(k)] - origin;
    twice += b.cross(c).norm();
  }
  return twice / 2;
}

/// Keeps the points that a triangle uses, renumbered in the order of first use.
ConvexHull compacted(const std::vector<Eigen::Vector3d>& points,
                     const std::vector<std::array<int, 3>>& triangles) {
  ConvexHull hull;
  std::vector<int> number(points.size(), -1);
  for (std::array<int, 3> triangle : triangles) {
    for (int& corner : triangle) {
      int& assigned = number[static_cast<std::size_t>(corner)];
      if (assigned < 0) {
        assigned = static_cast<int>(hull.vertices.size());
        hull.vertices.push_back(points[static_cast<std::size_t>(corner)]);
      }
      corner = assigned;
    }
    hull.triangles.push_back(triangle);
  }
  return hull;
}

double extent_of(const std::vector<Eigen::Vector3d>& points, const std::string& where) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) {
      throw InvalidInput(where, "a vertex is not finite", "coordinates that are numbers");
    }
    box.extend(point);
  }
  return points.empty() ? 0 : box.sizes().maxCoeff();
}

}  // namespace

ConvexHull convex_hull(const std::vector<Eigen::Vector3d>& points, const std::string& where) {
  const InvalidInput flat(where, "the points have no volume", "a body with a thickness");
  const double extent = extent_of(points, where);
  if (points.size() < 4 || !(extent > 0)) throw flat;

  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Eigen::Vector3d& p : points)
    coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
  Qhull qhull;
  if (!qhull.run(coordinates)) throw flat;
  ConvexHull hull = compacted(points, triangles_of(qhull.state()));

  // Qhull orders all facets alike; whether that is outward, the sign of the volume tells.
  double volume = hull_volume(hull);
  if (volume < 0) {
    volume = -volume;
    for (auto& triangle : hull.triangles) std::swap(triangle[1], triangle[2]);
  }
  if (!(volume > kLeastThickness * extent * area_of(hull) / 2)) throw flat;
  return hull;
}

}  // namespace wristwise
