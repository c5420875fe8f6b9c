#include "collision/polytope.hpp"

#include <algorithm>

namespace wristwise {

namespace {

// A face counts as seen by a point that is in its plane to within this much (m), so that no new
// face is as thin as a line.
constexpr double kInPlane = 1e-13;
// Faces whose planes are as far from the origin to within this much (m) may be one flat side.
constexpr double kSameSide = 1e-9;

DifferencePoint farther_of(const PlacedShape& a, const PlacedShape& b,
                           const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const DifferencePoint up = difference_support(a, b, direction);
  const DifferencePoint down = difference_support(a, b, -direction);
  const double above = (up.difference - origin).dot(direction);
  const double below = (origin - down.difference).dot(direction);
  return above >= below ? up : down;
}

}  // namespace

// The difference is a solid, so each step finds a point at least half its width away from the
// line or plane of the points before.
Polytope::Polytope(const PlacedShape& a, const PlacedShape& b) {
  vertices_[0] = difference_support(a, b, Eigen::Vector3d::UnitX());
  vertices_[1] = difference_support(a, b, -Eigen::Vector3d::UnitX());
  const Eigen::Vector3d edge = (at(1) - at(0)).normalized();
  vertices_[2] = farther_of(a, b, at(0), edge.unitOrthogonal());
  const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  vertices_[3] = farther_of(a, b, at(0), normal);
  vertex_count_ = 4;
  inside_ = (at(0) + at(1) + at(2) + at(3)) / 4;
  const bool flipped = (at(3) - at(0)).dot(normal) > 0;
  const int i = flipped ? 2 : 1;
  const int j = flipped ? 1 : 2;
  add_face(0, i, j);
  add_face(0, j, 3);
  add_face(j, i, 3);
  add_face(i, 0, 3);
}

bool Polytope::add_face(int i, int j, int k) {
  if (face_count_ == kMaxFaces) return false;
  const Eigen::Vector3d cross = (at(j) - at(i)).cross(at(k) - at(i));
  const double area = cross.norm();
  if (!(area > 0)) return false;
  Face& face = faces_[static_cast<std::size_t>(face_count_++)];
  face.vertex = {i, j, k};
  face.normal = cross / area;
  face.offset = face.normal.dot(at(i));
  return face.normal.dot(inside_) < face.offset;
}

const Polytope::Face& Polytope::nearest_face() const {
  return *std::min_element(faces_.begin(), faces_.begin() + face_count_,
                           [](const Face& f, const Face& g) { return f.offset < g.offset; });
}

// The faces that see the point are replaced by a fan from the point to the edge of that region.
bool Polytope::add(const DifferencePoint& point) {
  if (vertex_count_ == kMaxVertices) return false;
  const int apex = vertex_count_++;
  vertices_[static_cast<std::size_t>(apex)] = point;

  std::array<std::array<int, 2>, kMaxFaces> rim{};
  int rim_count = 0;
  const auto toggle = [&](int from, int to) {
    for (int e = 0; e < rim_count; ++e) {
      if (rim[static_cast<std::size_t>(e)] == std::array<int, 2>{to, from}) {
        rim[static_cast<std::size_t>(e)] = rim[static_cast<std::size_t>(--rim_count)];
        return true;
      }
    }
    if (rim_count == kMaxFaces) return false;
    rim[static_cast<std::size_t>(rim_count++)] = {from, to};
    return true;
  };
  for (int f = 0; f < face_count_;) {
    const Face& face = faces_[static_cast<std::size_t>(f)];
    if (face.normal.dot(point.difference) < face.offset - kInPlane) {
      ++f;
      continue;
    }
    const auto [i, j, k] = face.vertex;
    if (!toggle(i, j) || !toggle(j, k) || !toggle(k, i)) return false;
    faces_[static_cast<std::size_t>(f)] = faces_[static_cast<std::size_t>(--face_count_)];
  }
  for (int e = 0; e < rim_count; ++e) {
    const auto [from, to] = rim[static_cast<std::size_t>(e)];
    if (!add_face(from, to, apex)) return false;
  }
  return rim_count > 0;
}

Eigen::Array3d Polytope::weights(const Face& face, const Eigen::Vector3d& point) const {
  const auto [i, j, k] = face.vertex;
  const Eigen::Vector3d a = at(i) - point, b = at(j) - point, c = at(k) - point;
  const Eigen::Vector3d cross = (b - a).cross(c - a);
  return Eigen::Array3d(b.cross(c).dot(cross), c.cross(a).dot(cross), a.cross(b).dot(cross)) /
         cross.squaredNorm();
}

// The foot may lie in another triangle of the same flat side.
void Polytope::points_of(const Face& face, Eigen::Vector3d& on_a, Eigen::Vector3d& on_b) const {
  const Eigen::Vector3d foot = face.offset * face.normal;
  const Face* around = &face;
  Eigen::Array3d weight = weights(face, foot);
  for (int f = 0; f < face_count_ && weight.minCoeff() < 0; ++f) {
    const Face& other = faces_[static_cast<std::size_t>(f)];
    if (other.offset - face.offset > kSameSide || other.normal.dot(face.normal) < 0.999) continue;
    const Eigen::Array3d candidate = weights(other, foot);
    if (candidate.minCoeff() <= weight.minCoeff()) continue;
    around = &other;
    weight = candidate;
  }
  weight = weight.max(0);
  weight /= weight.sum();
  on_a.setZero();
  on_b.setZero();
  for (int v = 0; v < 3; ++v) {
    const int corner = around->vertex[static_cast<std::size_t>(v)];
    on_a += weight[v] * vertices_[static_cast<std::size_t>(corner)].on_a;
    on_b += weight[v] * vertices_[static_cast<std::size_t>(corner)].on_b;
  }
}

}  // namespace wristwise
