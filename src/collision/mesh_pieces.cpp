#include "collision/mesh_pieces.hpp"

#include <map>

#include "disjoint_sets.hpp"

namespace wristwise {

namespace {

/// For each vertex, the first one at the same place.
std::vector<std::size_t> welded(const std::vector<Eigen::Vector3d>& vertices) {
  std::map<std::array<double, 3>, std::size_t> first;
  std::vector<std::size_t> index;
  index.reserve(vertices.size());
  for (const Eigen::Vector3d& v : vertices) {
    // Adding zero turns -0 into 0.
    const std::array<double, 3> key{v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
    index.push_back(first.emplace(key, index.size()).first->second);
  }
  return index;
}

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> connected_pieces(const TriangleSoup& soup) {
  const std::vector<std::size_t> weld = welded(soup.vertices);
  DisjointSets sets(soup.vertices.size());
  for (const auto& [i, j, k] : soup.triangles) {
    sets.unite(weld[static_cast<std::size_t>(i)], weld[static_cast<std::size_t>(j)]);
    sets.unite(weld[static_cast<std::size_t>(j)], weld[static_cast<std::size_t>(k)]);
  }
  std::map<std::size_t, std::size_t> piece_of_set;
  std::vector<std::vector<Eigen::Vector3d>> pieces;
  std::vector<bool> taken(soup.vertices.size(), false);
  for (const auto& triangle : soup.triangles) {
    for (const int corner : triangle) {
      const std::size_t vertex = weld[static_cast<std::size_t>(corner)];
      if (taken[vertex]) continue;
      taken[vertex] = true;
      const auto [entry, is_new] = piece_of_set.emplace(sets.find(vertex), pieces.size());
      if (is_new) pieces.emplace_back();
      pieces[entry->second].push_back(soup.vertices[vertex]);
    }
  }
  return pieces;
}

}  // namespace wristwise
