#include "collision/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wristwise {

namespace {

constexpr int kLeaf = 4;
constexpr std::size_t kDeepest = 64;

}  // namespace

Eigen::Vector3d nearest_weights(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c, const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh) {
  const int count = static_cast<int>(mesh.triangles.size());
  std::vector<Eigen::Vector3d> centers;
  centers.reserve(mesh.triangles.size());
  for (int t = 0; t < count; ++t) {
    const auto i = static_cast<std::size_t>(t);
    centers.emplace_back((mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3);
    order_.push_back(t);
  }
  build(0, count, centers);
}

int TriangleTree::build(int first, int count, const std::vector<Eigen::Vector3d>& centers) {
  Node node;
  Eigen::AlignedBox3d spread;
  for (int i = first; i < first + count; ++i) {
    const auto triangle = static_cast<std::size_t>(order_[static_cast<std::size_t>(i)]);
    for (std::size_t c = 0; c < 3; ++c) node.box.extend(mesh_.corner(triangle, c));
    spread.extend(centers[triangle]);
  }
  node.first = first;
  node.count = count;
  const auto index = nodes_.size();
  nodes_.push_back(node);
  if (count <= kLeaf) return static_cast<int>(index);

  Eigen::Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const int half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](int a, int b) {
    const double x = centers[static_cast<std::size_t>(a)][axis];
    const double y = centers[static_cast<std::size_t>(b)][axis];
    return x != y ? x < y : a < b;
  });
  const int left = build(first, half, centers);
  const int right = build(first + half, count - half, centers);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return static_cast<int>(index);
}

NearestOnMesh TriangleTree::nearest(const Eigen::Vector3d& point) const {
  struct Open {
    int node = 0;
    double squared = 0;
  };
  std::array<Open, kDeepest> open{};
  std::size_t size = 0;
  open[size++] = {0, 0};
  NearestOnMesh best;
  double least = std::numeric_limits<double>::infinity();
  while (size > 0) {
    const Open at = open[--size];
    if (at.squared >= least) continue;
    const Node& node = nodes_[static_cast<std::size_t>(at.node)];
    if (node.left < 0) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto t = static_cast<std::size_t>(order_[static_cast<std::size_t>(i)]);
        const Eigen::Vector3d &a = mesh_.corner(t, 0), &b = mesh_.corner(t, 1),
                              &c = mesh_.corner(t, 2);
        const Eigen::Vector3d weights = nearest_weights(a, b, c, point);
        if (!weights.allFinite()) continue;  // no area: its neighbours have its points
        const Eigen::Vector3d on = weights[0] * a + weights[1] * b + weights[2] * c;
        const double squared = (on - point).squaredNorm();
        if (squared >= least) continue;
        least = squared;
        best = {0, on, t, weights};
      }
      continue;
    }
    const double to_left =
        nodes_[static_cast<std::size_t>(node.left)].box.squaredExteriorDistance(point);
    const double to_right =
        nodes_[static_cast<std::size_t>(node.right)].box.squaredExteriorDistance(point);
    const Open left{node.left, to_left}, right{node.right, to_right};
    open[size++] = to_left < to_right ? right : left;
    open[size++] = to_left < to_right ? left : right;
  }
  best.distance = std::sqrt(least);
  return best;
}

}  // namespace wristwise
