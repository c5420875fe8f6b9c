#include "collision/penetration.hpp"

#include <limits>

#include "collision/polytope.hpp"

namespace wristwise {

namespace {

constexpr double kClosed = 1e-9;  // m, between lower and upper bound of the depth

}  // namespace

// With D = core b - core a and h(n) = max over D of n.x, the depth is the least h(n) over unit n
// (the signed distance is -h(n) for the best n, separated or not). A polytope inside D has its
// nearest face at a distance that bounds the depth from below, and h of that face's normal bounds
// it from above; the support point that gives h is added until the two meet.
CertifiedDistance penetration(const PlacedShape& a, const PlacedShape& b) {
  Polytope polytope(a, b);
  double depth = std::numeric_limits<double>::infinity();
  CertifiedDistance result;
  while (true) {
    const Polytope::Face& face = polytope.nearest_face();
    const DifferencePoint point = difference_support(a, b, face.normal);
    const double bound = point.difference.dot(face.normal);
    result.upper = -face.offset;
    const bool closed = bound - face.offset <= kClosed;
    if (closed || bound < depth) {
      depth = bound;
      // D moves with b: leaving along n means that b moves along -n of D's nearest face.
      result.normal = -face.normal;
      polytope.points_of(face, result.on_a, result.on_b);
    }
    if (closed || !polytope.add(point)) break;
  }
  result.lower = -depth;
  return result;
}

}  // namespace wristwise
