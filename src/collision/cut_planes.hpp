#pragma once

#include <vector>

#include "collision/cut_piece.hpp"

namespace wristwise {

/// An edge at which a part is not convex.
struct ConcaveEdge {
  Eigen::Vector3d from, to;
  Eigen::Vector3d normal_a, normal_b;  ///< of the triangles beside it
  double weight = 0;                   ///< length times the angle of the bend
};

std::vector<ConcaveEdge> concave_edges(const Part& part);

/// Planes by which a piece might be cut: those of the faces at its concave edges, those that halve
/// the angle there, and planes across the axes through `at` and the middle.
std::vector<Plane> cut_candidates(const CutPiece& piece, const std::vector<ConcaveEdge>& edges,
                                  const Eigen::Vector3d& at, double slack);

}  // namespace wristwise
