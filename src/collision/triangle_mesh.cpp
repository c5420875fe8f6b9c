#include "collision/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "disjoint_sets.hpp"

namespace wristwise {

namespace {

using Triangle = std::array<int, 3>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Triangle sorted(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

/// For each vertex, the first one at the same place.
std::vector<int> first_at_place(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<int> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto before = [&](int a, int b) {
    const Eigen::Vector3d &p = vertices[index(a)], &q = vertices[index(b)];
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] != q[axis]) return p[axis] < q[axis];
    }
    return a < b;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<int> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[index(order[i])] == vertices[index(order[i - 1])];
    first[index(order[i])] = same ? first[index(order[i - 1])] : order[i];
  }
  return first;
}

/// The triangles with their corners replaced; none with a corner twice, none twice.
std::vector<Triangle> replaced(const std::vector<Triangle>& triangles, const std::vector<int>& by) {
  std::vector<Triangle> kept;
  std::set<Triangle> seen;
  for (Triangle triangle : triangles) {
    for (int& corner : triangle) corner = by[index(corner)];
    const auto [i, j, k] = triangle;
    if (i == j || j == k || k == i) continue;
    if (seen.insert(sorted(triangle)).second) kept.push_back(triangle);
  }
  return kept;
}

/// Only the vertices that are used, in the order of their first use.
TriangleMesh compacted(const std::vector<Eigen::Vector3d>& vertices,
                       const std::vector<Triangle>& triangles) {
  TriangleMesh mesh;
  std::unordered_map<int, int> number;
  for (Triangle triangle : triangles) {
    for (int& corner : triangle) {
      const auto [entry, is_new] = number.emplace(corner, static_cast<int>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(vertices[index(corner)]);
      corner = entry->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// Triangles by edge, and on which of them the edge runs from the lesser to the greater vertex.
struct EdgeUse {
  int triangle;
  bool forward;
};
using Edges = std::map<std::pair<int, int>, std::vector<EdgeUse>>;

Edges edges_of(const TriangleMesh& mesh) {
  Edges edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = mesh.triangles[t][c], b = mesh.triangles[t][(c + 1) % 3];
      edges[std::minmax(a, b)].push_back({static_cast<int>(t), a < b});
    }
  }
  return edges;
}

double sixfold_volume(const TriangleMesh& mesh) {
  double sum = 0;
  const Eigen::Vector3d origin = mesh.vertices.front();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sum += (mesh.corner(t, 0) - origin)
               .dot((mesh.corner(t, 1) - origin).cross(mesh.corner(t, 2) - origin));
  }
  return sum;
}

}  // namespace

std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh) {
  const std::vector<Triangle> triangles = replaced(mesh.triangles, first_at_place(mesh.vertices));
  DisjointSets sets(mesh.vertices.size());
  for (const auto& [i, j, k] : triangles) {
    sets.unite(index(i), index(j));
    sets.unite(index(j), index(k));
  }
  std::unordered_map<std::size_t, std::size_t> part_of_set;
  std::vector<std::vector<Triangle>> parts;
  for (const Triangle& triangle : triangles) {
    const auto [entry, is_new] = part_of_set.emplace(sets.find(index(triangle[0])), parts.size());
    if (is_new) parts.emplace_back();
    parts[entry->second].push_back(triangle);
  }
  std::vector<TriangleMesh> meshes;
  meshes.reserve(parts.size());
  for (const auto& part : parts) meshes.push_back(compacted(mesh.vertices, part));
  return meshes;
}

TriangleMesh welded(const TriangleMesh& mesh, double distance) {
  const Eigen::Vector3d corner = mesh.box().min();
  using Cell = std::array<long, 3>;
  const auto cell_of = [&](const Eigen::Vector3d& p) {
    Cell cell{};
    for (int i = 0; i < 3; ++i) {
      cell[index(i)] = static_cast<long>(std::floor((p[i] - corner[i]) / distance));
    }
    return cell;
  };
  std::map<Cell, std::vector<int>> kept;
  std::vector<int> by(mesh.vertices.size());
  const auto near = [&](const Eigen::Vector3d& p) {
    const Cell at = cell_of(p);
    for (long x = -1; x <= 1; ++x) {
      for (long y = -1; y <= 1; ++y) {
        for (long z = -1; z <= 1; ++z) {
          const auto found = kept.find({at[0] + x, at[1] + y, at[2] + z});
          if (found == kept.end()) continue;
          for (const int other : found->second) {
            if ((mesh.vertices[index(other)] - p).norm() <= distance) return other;
          }
        }
      }
    }
    return -1;
  };
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const int other = near(mesh.vertices[v]);
    by[v] = other >= 0 ? other : static_cast<int>(v);
    if (other < 0) kept[cell_of(mesh.vertices[v])].push_back(static_cast<int>(v));
  }
  return compacted(mesh.vertices, replaced(mesh.triangles, by));
}

bool close_outward(TriangleMesh& mesh) {
  if (mesh.triangles.size() < 4) return false;
  const Edges edges = edges_of(mesh);
  std::vector<std::vector<std::pair<int, bool>>> neighbours(mesh.triangles.size());
  for (const auto& entry : edges) {
    const std::vector<EdgeUse>& uses = entry.second;
    if (uses.size() != 2) return false;
    const bool same_side = uses[0].forward != uses[1].forward;
    neighbours[index(uses[0].triangle)].emplace_back(uses[1].triangle, same_side);
    neighbours[index(uses[1].triangle)].emplace_back(uses[0].triangle, same_side);
  }
  std::vector<int> turned(mesh.triangles.size(), -1);  // -1: not reached, 1: to be turned round
  for (std::size_t start = 0; start < turned.size(); ++start) {
    if (turned[start] >= 0) continue;
    turned[start] = 0;
    std::vector<std::size_t> open = {start};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const auto& [next, same_side] : neighbours[at]) {
        const int turn = same_side ? turned[at] : 1 - turned[at];
        if (turned[index(next)] < 0) {
          turned[index(next)] = turn;
          open.push_back(index(next));
        } else if (turned[index(next)] != turn) {
          return false;
        }
      }
    }
  }
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] == 1) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  if (sixfold_volume(mesh) < 0) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return true;
}

}  // namespace wristwise
