#include "collision/normal_search.hpp"

namespace wristwise {

namespace {

constexpr double kFirstStep = 0.02;
constexpr double kLastStep = 1e-9;

bool try_normal(const PlacedShape& a, const PlacedShape& b, const Eigen::Vector3d& direction,
                CertifiedDistance& found) {
  const double length = direction.norm();
  if (!(length > kLastStep)) return false;
  const Eigen::Vector3d normal = direction / length;
  const double gap = plane_gap(a, b, normal);
  if (!(gap > found.lower)) return false;
  found.lower = gap;
  found.normal = normal;
  return true;
}

/// The axes of a shape, and the found normal turned into the planes across them.
void try_axes(const PlacedShape& a, const PlacedShape& b, const PlacedShape& of,
              CertifiedDistance& found) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = of.pose.linear().col(i);
    try_normal(a, b, axis, found);
    try_normal(a, b, -axis, found);
    try_normal(a, b, found.normal - found.normal.dot(axis) * axis, found);
  }
}

/// Compass search: steps in eight directions across the normal, halved when none is better.
void descend(const PlacedShape& a, const PlacedShape& b, CertifiedDistance& found) {
  for (double step = kFirstStep; step > kLastStep;) {
    const Eigen::Vector3d normal = found.normal;
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    bool better = false;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        if (i == 0 && j == 0) continue;
        better |= try_normal(a, b, normal + step * (i * u + j * v), found);
      }
    }
    if (!better) step /= 2;
  }
}

}  // namespace

void search_normal(const PlacedShape& a, const PlacedShape& b, CertifiedDistance& found) {
  try_axes(a, b, a, found);
  try_axes(a, b, b, found);
  descend(a, b, found);
}

}  // namespace wristwise
