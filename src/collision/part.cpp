#include "collision/part.hpp"

#include <cmath>
#include <map>

namespace wristwise {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// The angle of a triangle at its first corner.
double angle_at(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d u = b - a, v = c - a;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

Part::Part(TriangleMesh mesh, bool closed)
    : mesh_(std::move(mesh)), closed_(closed), box_(mesh_.box()), tree_(mesh_) {
  find_normals();
}

// The sign of the distance comes from the angle-weighted normal of the nearest corner, edge or
// face (Baerentzen and Aanaes 2005).
void Part::find_normals() {
  vertex_normals_.assign(mesh_.vertices.size(), Eigen::Vector3d::Zero());
  std::map<std::pair<int, int>, Eigen::Vector3d> of_edge;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Eigen::Vector3d &a = mesh_.corner(t, 0), &b = mesh_.corner(t, 1), &c = mesh_.corner(t, 2);
    const Eigen::Vector3d across = (b - a).cross(c - a);
    face_normals_.push_back(across.norm() > 0 ? across.stableNormalized() : across);
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = mesh_.triangles[t][(i + 1) % 3], to = mesh_.triangles[t][(i + 2) % 3];
      vertex_normals_[static_cast<std::size_t>(mesh_.triangles[t][i])] +=
          angle_at(mesh_.corner(t, i), mesh_.corner(t, (i + 1) % 3), mesh_.corner(t, (i + 2) % 3)) *
          face_normals_.back();
      of_edge.try_emplace(std::minmax(from, to), Eigen::Vector3d::Zero()).first->second +=
          face_normals_.back();
    }
  }
  for (const auto& triangle : mesh_.triangles) {
    edge_normals_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      edge_normals_.back()[i] =
          of_edge.at(std::minmax(triangle[(i + 1) % 3], triangle[(i + 2) % 3]));
    }
  }
}

Eigen::Vector3d Part::normal_at(const NearestOnMesh& nearest) const {
  const std::size_t t = nearest.triangle;
  int zeros = 0;
  std::size_t zero = 0, full = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (nearest.weights[static_cast<int>(i)] == 0) {
      ++zeros;
      zero = i;
    } else {
      full = i;
    }
  }
  if (zeros == 0) return face_normals_[t];
  if (zeros == 1) return edge_normals_[t][zero];
  return vertex_normals_[static_cast<std::size_t>(mesh_.triangles[t][full])];
}

double Part::distance(const Eigen::Vector3d& point) const {
  const NearestOnMesh nearest = tree_.nearest(point);
  if (!closed_) return nearest.distance;
  const bool inside = normal_at(nearest).dot(point - nearest.point) < 0;
  return inside ? -nearest.distance : nearest.distance;
}

// Solid angles of the triangles (van Oosterom and Strackee 1983) add up to 4 pi times the number.
double Part::winding(const Eigen::Vector3d& point) const {
  double half_angles = 0;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Eigen::Vector3d a = mesh_.corner(t, 0) - point, b = mesh_.corner(t, 1) - point,
                          c = mesh_.corner(t, 2) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    half_angles += std::atan2(a.dot(b.cross(c)), below);
  }
  return half_angles / (2 * kPi);
}

}  // namespace wristwise
