#include "collision/cut_planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wristwise {

namespace {

constexpr double kLeastBend = 1e-3;    // rad
constexpr std::size_t kStrongest = 6;  // candidates by weight,
constexpr std::size_t kSpread = 10;    // and so many more of the rest
constexpr double kSamePlane = 1e-4;    // of normals, and of offsets by the size

/// How much of an edge lies in the inside of a cell, as a share.
double share_inside(const ConcaveEdge& edge, const ConvexCell& cell, double margin) {
  double first = 0, last = 1;
  for (const Plane& plane : cell.planes()) {
    const double a = plane.height(edge.from) + margin, b = plane.height(edge.to) + margin;
    if (a >= 0 && b >= 0) return 0;
    if (a > 0) first = std::max(first, a / (a - b));
    if (b > 0) last = std::min(last, a / (a - b));
  }
  return std::max(0.0, last - first);
}

Plane through(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  return {normal, normal.dot(point)};
}

/// Adds up the weights of planes that are nearly the same.
class Ballot {
 public:
  explicit Ballot(double size) : size_(size) {}

  void vote(Plane plane, double weight) {
    if (!(plane.normal.norm() > 0.5)) return;
    Eigen::Index largest = 0;
    plane.normal.cwiseAbs().maxCoeff(&largest);
    if (plane.normal[largest] < 0) plane = {-plane.normal, -plane.offset};
    std::array<long, 4> key{};
    for (int i = 0; i < 3; ++i) {
      key[static_cast<std::size_t>(i)] = std::lround(plane.normal[i] / kSamePlane);
    }
    key[3] = std::lround(plane.offset / (kSamePlane * size_));
    const auto [entry, is_new] = index_.emplace(key, planes_.size());
    if (is_new) planes_.push_back({0, plane});
    planes_[entry->second].first += weight;
  }

  /// The heaviest, and some of the others, evenly spread.
  std::vector<Plane> elected() const {
    std::vector<std::pair<double, Plane>> order = planes_;
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Plane> planes;
    const std::size_t strongest = std::min(kStrongest, order.size());
    for (std::size_t i = 0; i < strongest; ++i) planes.push_back(order[i].second);
    const std::size_t rest = order.size() - strongest, spread = std::min(kSpread, rest);
    for (std::size_t i = 0; i < spread; ++i) {
      planes.push_back(order[strongest + i * rest / spread].second);
    }
    return planes;
  }

 private:
  double size_;
  std::map<std::array<long, 4>, std::size_t> index_;
  std::vector<std::pair<double, Plane>> planes_;
};

}  // namespace

std::vector<ConcaveEdge> concave_edges(const Part& part) {
  const TriangleMesh& mesh = part.mesh();
  std::map<std::pair<int, int>, std::size_t> first;
  std::vector<ConcaveEdge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = mesh.triangles[t][i], to = mesh.triangles[t][(i + 1) % 3];
      const auto [entry, is_new] = first.emplace(std::minmax(from, to), t);
      if (is_new) continue;
      const Eigen::Vector3d a = part.normal(entry->second), b = part.normal(t);
      const Eigen::Vector3d &p = mesh.corner(t, i), &q = mesh.corner(t, (i + 1) % 3);
      const bool rises = a.dot(mesh.corner(t, (i + 2) % 3) - p) > 0;
      const double bend = std::atan2(a.cross(b).norm(), a.dot(b));
      if (bend < kLeastBend || (part.closed() && !rises)) continue;
      edges.push_back({p, q, a, b, bend * (q - p).norm()});
    }
  }
  return edges;
}

std::vector<Plane> cut_candidates(const CutPiece& piece, const std::vector<ConcaveEdge>& edges,
                                  const Eigen::Vector3d& at, double slack) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : piece.hull.vertices) box.extend(vertex);
  Ballot ballot(box.sizes().maxCoeff());
  for (const ConcaveEdge& edge : edges) {
    const double weight = edge.weight * share_inside(edge, piece.cell, 10 * slack);
    if (!(weight > 0)) continue;
    ballot.vote(through(edge.normal_a, edge.from), weight);
    ballot.vote(through(edge.normal_b, edge.from), weight);
    const Eigen::Vector3d across = edge.normal_a - edge.normal_b;
    if (across.norm() > 0) ballot.vote(through(across.normalized(), edge.from), weight);
  }
  std::vector<Plane> planes = ballot.elected();
  for (int axis = 0; axis < 3; ++axis) {
    planes.push_back(through(Eigen::Vector3d::Unit(axis), at));
    planes.push_back(through(Eigen::Vector3d::Unit(axis), box.center()));
  }
  return planes;
}

}  // namespace wristwise
