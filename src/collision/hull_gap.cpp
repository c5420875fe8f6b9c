#include "collision/hull_gap.hpp"

#include <algorithm>
#include <queue>

#include "collision/hull_planes.hpp"

namespace wristwise {

namespace {

constexpr double kPrecision = 0.5;

struct Cube {
  Eigen::Vector3d center;
  Eigen::Vector3d half;
  double upper = 0;  ///< m, no point of the hull in it is farther from the part
};

struct LessFar {
  bool operator()(const Cube& a, const Cube& b) const { return a.upper < b.upper; }
};

class Search {
 public:
  Search(const ConvexHull& hull, const Part& part, double enough, long& budget)
      : planes_(hull_planes(hull)), part_(part), enough_(enough), budget_(budget) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : hull.vertices) box.extend(vertex);
    gap_.at = box.center();
    look_at(box.center(), box.sizes() / 2, box.sizes().norm());
  }

  HullGap run() {
    while (!open_.empty() && budget_ > 0) {
      const Cube widest = open_.top();
      if (widest.upper <= enough_ || widest.upper <= (1 + kPrecision) * gap_.lower) break;
      open_.pop();
      split(widest);
    }
    gap_.upper = std::max(settled_, open_.empty() ? 0.0 : open_.top().upper);
    return gap_;
  }

 private:
  /// Halves the long edges: the boxes of a flat hull soon are cubes.
  void split(const Cube& cube) {
    const Eigen::Array3d halved = (cube.half.array() > 0.6 * cube.half.maxCoeff()).cast<double>();
    const Eigen::Vector3d step = halved * cube.half.array() / 2;
    const Eigen::Vector3d half = cube.half - step;
    for (int octant = 0; octant < 8; ++octant) {
      const Eigen::Array3d side(octant & 1, (octant >> 1) & 1, octant >> 2);
      if ((side > halved).any()) continue;
      const Eigen::Vector3d sign = 2 * side - 1;
      look_at(cube.center + sign.cwiseProduct(step), half, cube.upper);
    }
  }

  // The distance from the part changes by no more than the way: within the box it is at most that
  // of the centre, which is negative inside, and half the diagonal.
  void look_at(const Eigen::Vector3d& center, const Eigen::Vector3d& half, double known) {
    double beyond = -1;  // of the centre, over the hull's planes
    for (const Plane& plane : planes_) {
      const double height = plane.height(center);
      if (height > plane.normal.cwiseAbs().dot(half)) return;  // no point of the hull
      beyond = std::max(beyond, height);
    }
    --budget_;
    const double distance = part_.distance(center);
    const double upper = std::min(known, std::max(0.0, distance + half.norm()));
    if (beyond <= 0 && distance > gap_.lower) {
      gap_.lower = distance;
      gap_.at = center;
    }
    if (upper <= enough_) {
      settled_ = std::max(settled_, upper);
    } else {
      open_.push({center, half, upper});
    }
  }

  std::vector<Plane> planes_;
  const Part& part_;
  double enough_;
  long& budget_;
  std::priority_queue<Cube, std::vector<Cube>, LessFar> open_;
  double settled_ = 0;
  HullGap gap_;
};

}  // namespace

HullGap hull_gap(const ConvexHull& hull, const Part& part, double enough, long& budget) {
  return Search(hull, part, enough, budget).run();
}

}  // namespace wristwise
