#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "temporary_folder.hpp"
#include "wristwise/geometry.hpp"

namespace wristwise::test {

using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

inline std::string ascii_stl(const Triangles& triangles) {
  std::ostringstream text;
  text.precision(17);
  text << "solid test\n";
  for (const auto& triangle : triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const auto& v : triangle) text << "vertex " << v.transpose() << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid test\n";
  return text.str();
}

inline std::string binary_stl(const Triangles& triangles) {
  std::string bytes(80, ' ');
  const auto count = static_cast<std::uint32_t>(triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& triangle : triangles) {
    std::array<float, 12> numbers{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < 3; ++i) {
        numbers[3 + 3 * c + static_cast<std::size_t>(i)] = static_cast<float>(triangle[c][i]);
      }
    }
    bytes.append(reinterpret_cast<const char*>(numbers.data()), 48);
    bytes.append("\0\0", 2);
  }
  return bytes;
}

/// A prism: the polygon (counter-clockwise, a fan from its first corner) from z = 0 to `height`.
inline Triangles prism(const std::vector<Eigen::Vector2d>& polygon, double height,
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

/// A surface f(i, j) that closes on itself in both directions, its outside where i x j points.
inline Triangles closed_grid(int rows, int columns,
                             const std::function<Eigen::Vector3d(int, int)>& f) {
  Triangles triangles;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int next_i = (i + 1) % rows, next_j = (j + 1) % columns;
      triangles.push_back({f(i, j), f(next_i, j), f(next_i, next_j)});
      triangles.push_back({f(i, j), f(next_i, next_j), f(i, next_j)});
    }
  }
  return triangles;
}

/// Unit cubes on a grid, joined: what is inside and how far anything is away is plain to see.
class Cubes {
 public:
  using Cell = std::array<int, 3>;

  explicit Cubes(std::set<Cell> cells) : cells_(std::move(cells)) {}

  bool holds(const Eigen::Vector3d& p) const {
    return cells_.count({static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())),
                         static_cast<int>(std::floor(p.z()))}) > 0;
  }

  double distance(const Eigen::Vector3d& p) const {
    double least = 1e300;
    for (const Cell& cell : cells_) {
      const Eigen::Vector3d low(cell[0], cell[1], cell[2]);
      const Eigen::Vector3d nearest = p.cwiseMax(low).cwiseMin(low + Eigen::Vector3d::Ones());
      least = std::min(least, (nearest - p).norm());
    }
    return least;
  }

  const std::set<Cell>& cells() const { return cells_; }

  /// The faces between a cube and no cube, outward.
  Triangles surface() const {
    Triangles triangles;
    for (const Cell& cell : cells_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          Cell beside = cell;
          beside[axis] += 2 * side - 1;
          if (cells_.count(beside) > 0) continue;
          Eigen::Vector3d corner(cell[0], cell[1], cell[2]);
          corner[static_cast<int>(axis)] += side;
          Eigen::Vector3d u = Eigen::Vector3d::Unit(static_cast<int>((axis + 1) % 3));
          Eigen::Vector3d v = Eigen::Vector3d::Unit(static_cast<int>((axis + 2) % 3));
          if (side == 0) std::swap(u, v);
          triangles.push_back({corner, corner + u, corner + u + v});
          triangles.push_back({corner, corner + u + v, corner + v});
        }
      }
    }
    return triangles;
  }

 private:
  std::set<Cell> cells_;
};

inline Triangles transformed(Triangles triangles, const Pose& pose, double scale) {
  for (auto& triangle : triangles) {
    for (auto& v : triangle) v = pose * Eigen::Vector3d(scale * v);
  }
  return triangles;
}

}  // namespace wristwise::test
