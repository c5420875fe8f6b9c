#include "kinematics/turns_onto.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace wristwise {

double turn_onto(const Eigen::Vector3d& h, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d side = from - h * h.dot(from);
  return std::atan2(h.cross(side).dot(to), side.dot(to));
}

// (F78) v = a h1 + b h2 +- g n,   n = h1 x h2,   k = h1 . h2,
//   a = (v . h1 - k v . h2) / |n|^2,   b = (v . h2 - k v . h1) / |n|^2,
//   g^2 |n|^2 = |v|^2 - |a h1 + b h2|^2.
UpToTwo<Eigen::Vector3d> vectors_with(const Component& first, const Component& second,
                                      double squared_length, double slack) {
  UpToTwo<Eigen::Vector3d> vectors;
  const Eigen::Vector3d normal = first.axis.cross(second.axis);
  const double k = first.axis.dot(second.axis), n2 = normal.squaredNorm();
  const Eigen::Vector3d flat = (first.value - k * second.value) / n2 * first.axis +
                               (second.value - k * first.value) / n2 * second.axis;
  const double rest = squared_length - flat.squaredNorm();
  if (!(rest >= -slack * squared_length)) return vectors;
  const double g = rest > 0 ? std::sqrt(rest / n2) : 0;
  vectors.add(flat + g * normal);
  if (g > 0) vectors.add(flat - g * normal);
  return vectors;
}

UpToTwo<TwoTurns> two_turns_onto(const Eigen::Vector3d& h1, const Eigen::Vector3d& h2,
                                 const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double slack) {
  UpToTwo<TwoTurns> turns;
  for (const Eigen::Vector3d& between :
       vectors_with({h1, h1.dot(to)}, {h2, h2.dot(from)}, from.squaredNorm(), slack))
    turns.add({turn_onto(h1, between, to), turn_onto(h2, from, between)});
  return turns;
}

}  // namespace wristwise
