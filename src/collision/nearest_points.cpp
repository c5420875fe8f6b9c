#include "collision/nearest_points.hpp"

#include <array>
#include <limits>

namespace wristwise {

namespace {

constexpr double kClosed = 1e-9;     // m, between lower and upper bound
constexpr double kTouching = 1e-10;  // m, below this the direction is lost to rounding
constexpr int kMaxIterations = 100;

/// Up to four points of the Minkowski difference, and weights of its point nearest to the origin.
struct Simplex {
  std::array<DifferencePoint, 4> points;
  std::array<double, 4> weights{};
  int size = 0;
};

struct Combination {
  double squared_norm = std::numeric_limits<double>::infinity();
  std::array<int, 4> index{};
  std::array<double, 4> weight{};
  int size = 0;
};

void keep_nearer(Combination& best, const Simplex& simplex, const Combination& candidate) {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  for (int i = 0; i < candidate.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (candidate.weight[k] < 0) return;
    v += candidate.weight[k] *
         simplex.points[static_cast<std::size_t>(candidate.index[k])].difference;
  }
  const double squared = v.squaredNorm();
  if (!(squared < best.squared_norm)) return;
  best = candidate;
  best.squared_norm = squared;
}

const Eigen::Vector3d& at(const Simplex& simplex, int i) {
  return simplex.points[static_cast<std::size_t>(i)].difference;
}

void try_edge(Combination& best, const Simplex& simplex, int i, int j) {
  const Eigen::Vector3d edge = at(simplex, j) - at(simplex, i);
  const double length = edge.squaredNorm();
  if (!(length > 0)) return;
  const double t = -at(simplex, i).dot(edge) / length;
  keep_nearer(best, simplex, {0, {i, j}, {1 - t, t}, 2});
}

// Weights of the foot of the origin's perpendicular are ratios of areas, taken along the normal.
void try_triangle(Combination& best, const Simplex& simplex, int i, int j, int k) {
  const Eigen::Vector3d &a = at(simplex, i), &b = at(simplex, j), &c = at(simplex, k);
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  if (!(squared > 1e-30 * (b - a).squaredNorm() * (c - a).squaredNorm())) return;
  const double at_b = (c - a).cross(a).dot(normal) / squared;
  const double at_c = a.cross(b - a).dot(normal) / squared;
  keep_nearer(best, simplex, {0, {i, j, k}, {1 - at_b - at_c, at_b, at_c}, 3});
}

/// Whether the origin is in the tetrahedron; the weights are then its coordinates.
bool tetrahedron_holds_origin(Simplex& simplex) {
  const Eigen::Vector3d &a = at(simplex, 0), &b = at(simplex, 1), &c = at(simplex, 2),
                        &d = at(simplex, 3);
  const double volume = (b - a).cross(c - a).dot(d - a);
  if (volume == 0) return false;
  const Eigen::Array4d part(b.dot(c.cross(d)), -a.dot(c.cross(d)), a.dot(b.cross(d)),
                            -a.dot(b.cross(c)));
  const Eigen::Array4d weight = part / volume;
  if (!(weight >= 0).all()) return false;
  for (int i = 0; i < 4; ++i)
    simplex.weights[static_cast<std::size_t>(i)] = weight[i] / weight.sum();
  return true;
}

// The nearest point lies inside a vertex, edge or triangle of the simplex. The point added last
// belongs to it, or the simplex before would have been nearer already; so only those are tried.
void reduce(Simplex& simplex) {
  const int last = simplex.size - 1;
  Combination best;
  keep_nearer(best, simplex, {0, {last}, {1}, 1});
  for (int i = 0; i < last; ++i) {
    try_edge(best, simplex, i, last);
    for (int j = i + 1; j < last; ++j) try_triangle(best, simplex, i, j, last);
  }
  const Simplex before = simplex;
  simplex.size = best.size;
  for (int i = 0; i < best.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    simplex.points[k] = before.points[static_cast<std::size_t>(best.index[k])];
    simplex.weights[k] = best.weight[k];
  }
}

void read_points(const Simplex& simplex, CertifiedDistance& result) {
  result.on_a.setZero();
  result.on_b.setZero();
  for (int i = 0; i < simplex.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.on_a += simplex.weights[k] * simplex.points[k].on_a;
    result.on_b += simplex.weights[k] * simplex.points[k].on_b;
  }
}

}  // namespace

double plane_gap(const PlacedShape& a, const PlacedShape& b, const Eigen::Vector3d& normal) {
  return difference_support(a, b, -normal).difference.dot(normal);
}

CertifiedDistance nearest_points(const PlacedShape& a, const PlacedShape& b,
                                 const Eigen::Vector3d& normal) {
  CertifiedDistance result;
  result.lower = -std::numeric_limits<double>::infinity();
  result.upper = std::numeric_limits<double>::infinity();
  Eigen::Vector3d direction = normal;
  Simplex simplex;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const DifferencePoint point = difference_support(a, b, -direction);
    const double gap = point.difference.dot(direction);
    // An earlier normal may bound as well, but only this one is along the line of the points.
    const bool closed = result.upper - gap <= kClosed;
    if (closed || gap > result.lower) {
      result.lower = gap;
      result.normal = direction;
    }
    if (closed) break;
    simplex.points[static_cast<std::size_t>(simplex.size++)] = point;
    if (simplex.size == 4 && tetrahedron_holds_origin(simplex)) {
      read_points(simplex, result);
      result.upper = 0;
      break;
    }
    reduce(simplex);
    CertifiedDistance next = result;
    read_points(simplex, next);
    const Eigen::Vector3d v = next.on_b - next.on_a;
    next.upper = v.norm();
    if (!(next.upper < result.upper)) break;
    result = next;
    if (result.upper < kTouching) {
      result.upper = 0;
      break;
    }
    direction = v / result.upper;
  }
  return result;
}

}  // namespace wristwise
