#include "kinematics/turns_onto.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace wristwise {

double turn_onto(const Eigen::Vector3d& h, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d side = from - h * h.dot(from);
  return std::atan2(h.cross(side).dot(to), side.dot(to));
}

// (F78) The vector c = Rot(h2, q2) from = Rot(h1, -q1) to has the component of `to` along h1 and
// that of `from` along h2:
//   c = a h1 + b h2 +- g n,   n = h1 x h2,   k = h1 . h2,
//   a = (h1 . to - k h2 . from) / |n|^2,   b = (h2 . from - k h1 . to) / |n|^2,
//   g^2 |n|^2 = |from|^2 - |a h1 + b h2|^2.
TwoTurnsSolutions two_turns_onto(const Eigen::Vector3d& h1, const Eigen::Vector3d& h2,
                                 const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double slack) {
  TwoTurnsSolutions solutions;
  const Eigen::Vector3d normal = h1.cross(h2);
  const double along_1 = h1.dot(to), along_2 = h2.dot(from), k = h1.dot(h2);
  const double n2 = normal.squaredNorm(), length2 = from.squaredNorm();
  const Eigen::Vector3d flat =
      (along_1 - k * along_2) / n2 * h1 + (along_2 - k * along_1) / n2 * h2;
  const double rest = length2 - flat.squaredNorm();
  if (!(rest >= -slack * length2)) return solutions;
  const double g = rest > 0 ? std::sqrt(rest / n2) : 0;
  for (const double signed_g : {g, -g}) {
    const Eigen::Vector3d c = flat + signed_g * normal;
    solutions.turns[static_cast<std::size_t>(solutions.count++)] = {turn_onto(h1, c, to),
                                                                    turn_onto(h2, from, c)};
    if (!(g > 0)) break;
  }
  return solutions;
}

}  // namespace wristwise
