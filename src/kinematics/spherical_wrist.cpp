#include "kinematics/spherical_wrist.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/branch_directions.hpp"
#include "kinematics/planar_turn.hpp"

namespace wristwise {

// (F7) Closed form for a spherical wrist behind two parallel axes.
//
// Notation: h_j the direction and p_j a point of axis j at joint zero, E_j the turn by q_j about
// it, M the TCP at zero, c the wrist centre at zero. The TCP is T = E1 E2 E3 E4 E5 E6 M (product of
// exponentials: no frame convention, sign or offset enters).
//
// Shoulder. E4 E5 E6 leave c in place, so w = T M^-1 c = E1 E2 E3 c, and turns about h2 (parallel
// to h3) keep the component along h2:
//   h2 . Rot(h1, -q1) (w - p1) = h2 . (c - p1).
// In a frame with z along h1 and h2 = (sin tau, 0, cos tau), with u = w - p1, this is
//   r cos(q1 - arg u) = k,   r = |(u_x, u_y)|,   k = (h2 . (c - p1) - u_z cos tau) / sin tau.
//
// Elbow. In the plane perpendicular to h2, with complex numbers, x along the upper arm of length
// l2, l3 the forearm's vector, s = +-1 the sign of h3 along h2 and v = E1^-1 w - p2:
//   v = e^{i q2} (l2 + e^{i s q3} l3),   s q3 + arg l3 = +-g,
//   sin^2(g/2) = ((l2 + |l3|)^2 - |v|^2) / (4 l2 |l3|),
//   cos^2(g/2) = (|v|^2 - (l2 - |l3|)^2) / (4 l2 |l3|),
// and q2 = arg v - arg(l2 + |l3| e^{+-ig}): the radius is kept even at the stretched elbow.
//
// Wrist. W = Rot(h2, -(q2 + s q3)) Rot(h1, -q1) R_T R_M^T is left for the turns 4, 5, 6. With
// a the angle between h4 and W h6, t1 that between h4 and h5, t2 that between h5 and h6, the
// spherical triangle (half-angle form, well conditioned at the wrist singularity a = 0) gives
//   sin^2(psi/2) = sin((a + d)/2) sin((a - d)/2) / (sin t1 sin t2),   d = t1 - t2,
//   cos^2(psi/2) = sin((s + a)/2) sin((s - a)/2) / (sin t1 sin t2),   s = t1 + t2,
// q5 = phi +- psi. q4 turns e = E5 h6 onto W h6, and q6 is what then remains of W: given q4 and q5
// it makes up for their errors, so that T is met even where q4 is arbitrary.
//
// Wrist with t1 = t2 = pi/2. Then psi = +-a. In coordinates along h5, h4 x h5, h4 let
// W h6 = (x, y, z), W h5 = (u, v, w). With psi = a, e = (0, -sin a, cos a) and joint 4 turns it
// onto W h6: q4 = arg(-y, x). As h5 is perpendicular to h6, q6 is the angle about W h6 from
// E4 h5 = (-y, x, 0) / sin a to W h5; times sin a, so that nothing is divided,
//   q6 = arg(x v - y u, w (x^2 + y^2) - z (x u + y v)).
// The other wrist, psi = -a, is (q4 + pi, phi - a, q6 + pi).

namespace {

constexpr double kPi = 3.14159265358979323846;
/// Nearer to a double root than this (rad) its two solutions differ by round-off only.
constexpr double kDoubleRoot = 3e-8;
/// Below this (m, rad) a direction is round-off and the joint that it would fix is set to zero.
constexpr double kNoDirection = 1e-12;

/// A frame with the given z axis (unit) and its x axis in the plane of z and `towards`.
Eigen::Matrix3d frame_about(const Eigen::Vector3d& z, const Eigen::Vector3d& towards) {
  Eigen::Matrix3d axes;
  axes.col(2) = z;
  axes.col(0) = (towards - z * z.dot(towards)).normalized();
  axes.col(1) = z.cross(axes.col(0));
  return axes;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The vector from line 1 to line 2 along their common normal starts here, on line 1.
Eigen::Vector3d nearest_point(const Eigen::Vector3d& p1, const Eigen::Vector3d& h1,
                              const Eigen::Vector3d& p2, const Eigen::Vector3d& h2) {
  const Eigen::Vector3d normal = h1.cross(h2);
  return p1 + h1 * ((p2 - p1).cross(h2).dot(normal) / normal.squaredNorm());
}

/// Nearer than this (rad) to a right angle is one.
constexpr double kRightAngle = 1e-13;

/// Do the two solutions at one end of a half-angle's range coincide?
bool is_double_root(double half_sine) { return 2 * half_sine < kDoubleRoot; }

static_assert(WorkspaceMargin::kMostWristStarts == BranchDirections::kMostWristsOfAnArm);

/// The two solutions +-angle of shoulder or elbow.
struct Bend {
  PlanarTurn turn;
  bool double_root = true;
};

/// From the squares of the half-angle's sine and cosine up to a common factor; negative ones count
/// as zero.
Bend bend_from_squares(double sine_squared, double cosine_squared, double separation) {
  if (separation > 0) {
    const HalfAngle half =
        HalfAngle::from_squares(sine_squared, cosine_squared).kept_off_ends(separation);
    return {half.whole_turn(), is_double_root(std::min(half.sine, half.cosine))};
  }
  const double s = std::max(sine_squared, 0.0);
  const double c = std::max(cosine_squared, 0.0);
  const double sum = s + c;
  if (!(sum > 0)) return {};
  return {{(c - s) / sum, 2 * std::sqrt(s * c) / sum},
          4 * std::min(s, c) < kDoubleRoot * kDoubleRoot * sum};
}

}  // namespace

struct SphericalWrist::ToolPose {
  Eigen::Vector3d wrist;   // the wrist centre
  Eigen::Vector3d axis_6;  // the direction of axis 6
  Eigen::Vector3d side_6;  // perpendicular to axis 6
};

SphericalWrist::SphericalWrist(const SixAxes& axes, const Eigen::Vector3d& wrist_centre) {
  const auto& h = axes.directions;
  const auto& p = axes.points;
  axis_3_sign_ = h[1].dot(h[2]) < 0 ? -1 : 1;

  const Eigen::Matrix3d frame_1 = frame_about(h[0], h[1]);
  const Eigen::Matrix3d frame_2 = frame_about(h[1], p[2] - p[1]);
  const Eigen::Matrix3d frame_4 = frame_about(h[3], h[4]);
  const Eigen::Matrix3d frame_5 = frame_about(h[4], h[3]);
  const Eigen::Vector3d side_6 = frame_about(h[5], h[4]).col(0);
  base_to_1_ = frame_1.transpose();
  from_1_to_2_ = frame_2.transpose() * frame_1;
  from_2_to_4_ = frame_4.transpose() * frame_2;
  from_4_to_5_ = frame_5.transpose() * frame_4;

  point_1_ = nearest_point(p[0], h[0], p[1], h[1]);
  offset_1_2_ = frame_2.transpose() * (point_1_ - p[1]);
  shoulder_cos_ = h[0].dot(h[1]);
  shoulder_sin_ = h[0].cross(h[1]).norm();
  shoulder_radius_ = std::abs((p[1] - p[0]).dot(h[0].cross(h[1]))) / shoulder_sin_;
  side_offset_ = h[1].dot(wrist_centre - point_1_);

  const Eigen::Vector3d upper_arm = frame_2.transpose() * (p[2] - p[1]);
  const Eigen::Vector3d forearm = frame_2.transpose() * (wrist_centre - p[2]);
  upper_arm_ = upper_arm.x();
  forearm_ = std::hypot(forearm.x(), forearm.y());
  forearm_turn_ = PlanarTurn::onto(forearm.x(), forearm.y());

  wrist_ = WristAngles(angle_between(h[3], h[4]), angle_between(h[4], h[5]));
  const Eigen::Vector3d axis_6_in_5 = frame_5.transpose() * h[5];
  wrist_zero_ = PlanarTurn::onto(axis_6_in_5.x(), axis_6_in_5.y()).inverse();
  phi_ = wrist_zero_.angle();
  right_angled_ = std::abs(h[3].dot(h[4])) < kRightAngle && std::abs(h[4].dot(h[5])) < kRightAngle;
  side_6_ = frame_5.transpose() * side_6;
  normal_6_ = frame_5.transpose() * h[5].cross(side_6);

  const Pose tcp_inverse = axes.tcp.inverse();
  wrist_in_tcp_ = tcp_inverse * wrist_centre;
  axis_6_in_tcp_ = tcp_inverse.linear() * h[5];
  side_6_in_tcp_ = tcp_inverse.linear() * side_6;
}

SphericalWrist::WristAngles::WristAngles(double t1, double t2)
    : sine_difference(std::sin(t1 - t2)),
      cosine_1_sine_2(std::cos(t1) * std::sin(t2)),
      sine_2(std::sin(t2)),
      half_least(PlanarTurn::by(std::abs(t1 - t2) / 2)),
      half_most(PlanarTurn::by(std::min(t1 + t2, 2 * kPi - t1 - t2) / 2)) {}

void SphericalWrist::solve(const Pose& tcp, const WorkspaceMargin& margin,
                           std::vector<JointVector>& branches) const {
  const Eigen::Vector3d wrist = base_to_1_ * (tcp * wrist_in_tcp_ - point_1_);
  const double radius = std::sqrt(wrist.x() * wrist.x() + wrist.y() * wrist.y());
  const double along = (side_offset_ - shoulder_cos_ * wrist.z()) / shoulder_sin_;
  if (!(std::abs(along) <= radius + margin.length)) return;

  const Eigen::Vector3d axis_6 = base_to_1_ * (tcp.linear() * axis_6_in_tcp_);
  const Eigen::Vector3d side_6 = base_to_1_ * (tcp.linear() * side_6_in_tcp_);
  BranchDirections directions;
  const auto at = [&](const PlanarTurn& turn) {
    const PlanarTurn back = turn.inverse();
    directions.add_shoulder(turn.cosine, turn.sine);
    solve_elbow({back * wrist, back * axis_6, back * side_6}, margin, directions);
  };
  if (radius < kNoDirection) {
    at({});
  } else {
    const Bend bend = bend_from_squares(radius - along, radius + along, margin.arm_separation);
    const PlanarTurn azimuth{wrist.x() / radius, wrist.y() / radius};
    at(azimuth * bend.turn);
    if (!bend.double_root) at(azimuth * bend.turn.inverse());
  }
  directions.append_to(branches, phi_);
}

void SphericalWrist::solve_elbow(const ToolPose& tool, const WorkspaceMargin& margin,
                                 BranchDirections& directions) const {
  const Eigen::Vector3d reach = from_1_to_2_ * tool.wrist + offset_1_2_;
  const double distance = std::sqrt(reach.x() * reach.x() + reach.y() * reach.y());
  const double longest = upper_arm_ + forearm_;
  const double shortest = std::abs(upper_arm_ - forearm_);
  if (!(distance <= longest + margin.length && distance >= shortest - margin.length)) return;

  const Eigen::Vector3d axis_6 = from_1_to_2_ * tool.axis_6;
  const Eigen::Vector3d side_6 = from_1_to_2_ * tool.side_6;
  const Bend bend =
      bend_from_squares((longest - distance) * (longest + distance),
                        (distance - shortest) * (distance + shortest), margin.arm_separation);
  const bool folded_away = distance < kNoDirection;
  const PlanarTurn azimuth{reach.x() / distance, reach.y() / distance};
  const PlanarTurn arm =
      PlanarTurn::onto(upper_arm_ + forearm_ * bend.turn.cosine, forearm_ * bend.turn.sine);
  const auto bent = [&](const PlanarTurn& turn, const PlanarTurn& to_wrist) {
    const PlanarTurn turn_2 = folded_away ? PlanarTurn{} : azimuth * to_wrist.inverse();
    const PlanarTurn turn_3 = turn * forearm_turn_.inverse();
    const PlanarTurn back = (turn_2 * turn_3).inverse();
    directions.add_elbow(turn_2, {turn_3.cosine, axis_3_sign_ * turn_3.sine});
    solve_wrist(from_2_to_4_ * (back * axis_6), from_2_to_4_ * (back * side_6), margin, directions);
  };
  bent(bend.turn, arm);
  if (!bend.double_root) bent(bend.turn.inverse(), arm.inverse());
}

void SphericalWrist::solve_wrist(const Eigen::Vector3d& axis_6, const Eigen::Vector3d& side_6,
                                 const WorkspaceMargin& margin,
                                 BranchDirections& directions) const {
  if (right_angled_ && !(margin.wrist_separation > 0)) {
    solve_right_angled_wrist(axis_6, side_6, directions);
  } else {
    solve_any_wrist(axis_6, side_6, margin, directions);
  }
}

void SphericalWrist::solve_right_angled_wrist(const Eigen::Vector3d& axis_6,
                                              const Eigen::Vector3d& side_6,
                                              BranchDirections& directions) const {
  const double sine_squared = axis_6.x() * axis_6.x() + axis_6.y() * axis_6.y();
  const double sine = std::sqrt(sine_squared);
  const PlanarTurn psi{axis_6.z(), sine};
  if (sine < kNoDirection) {  // q4 = 0, as if W h6 were at -y
    directions.add_wrist(BranchDirections::Wrist::single, {}, psi, side_6.x(),
                         side_6.z() * sine + axis_6.z() * side_6.y());
    return;
  }
  directions.add_wrist(
      BranchDirections::Wrist::flipped, {-axis_6.y(), axis_6.x()}, psi,
      axis_6.x() * side_6.y() - axis_6.y() * side_6.x(),
      side_6.z() * sine_squared - axis_6.z() * (axis_6.x() * side_6.x() + axis_6.y() * side_6.y()));
}

void SphericalWrist::solve_any_wrist(const Eigen::Vector3d& axis_6, const Eigen::Vector3d& side_6,
                                     const WorkspaceMargin& margin,
                                     BranchDirections& directions) const {
  const double sine = std::sqrt(axis_6.x() * axis_6.x() + axis_6.y() * axis_6.y());
  const HalfAngle a = HalfAngle::of(axis_6.z(), sine);
  const PlanarTurn& least = wrist_.half_least;
  const PlanarTurn& most = wrist_.half_most;
  const double above_least = a.sine * least.cosine - a.cosine * least.sine;  // sin((a - |d|) / 2)
  const double below_most = most.sine * a.cosine - most.cosine * a.sine;     // sin((s - a) / 2)
  if (!(above_least >= -margin.angle / 2 && below_most >= -margin.angle / 2)) return;

  const HalfAngle exact =
      HalfAngle::from_squares((a.sine * least.cosine + a.cosine * least.sine) * above_least,
                              (most.sine * a.cosine + most.cosine * a.sine) * below_most);
  const HalfAngle half = exact.kept_off_ends(margin.wrist_separation);
  const bool singular = sine < kNoDirection;
  const PlanarTurn direction = singular ? PlanarTurn{} : PlanarTurn::onto(axis_6.x(), axis_6.y());
  const auto bent = [&](const PlanarTurn& psi, const PlanarTurn& spread) {
    const double x = wrist_.sine_difference + 2 * wrist_.cosine_1_sine_2 * half.sine * half.sine;
    const PlanarTurn turn_4 =
        singular ? spread : direction * PlanarTurn::onto(x, wrist_.sine_2 * psi.sine) * spread;
    const PlanarTurn turn_5 = wrist_zero_ * psi;
    const Eigen::Vector3d side = turn_5.inverse() * (from_4_to_5_ * (turn_4.inverse() * side_6));
    directions.add_wrist(BranchDirections::Wrist::single, turn_4, psi, side.dot(side_6_),
                         side.dot(normal_6_));
  };
  if (half.sine != exact.sine) {
    const int starts = std::min(margin.wrist_starts, WorkspaceMargin::kMostWristStarts);
    for (int k = 0; k < starts; ++k) {
      bent(half.whole_turn(), PlanarTurn::by(2 * kPi * k / starts));
    }
    return;
  }
  bent(half.whole_turn(), {});
  const bool double_root = singular || (least.sine > kDoubleRoot && is_double_root(half.sine)) ||
                           (most.cosine > kDoubleRoot && is_double_root(half.cosine));
  if (!double_root) bent(half.whole_turn().inverse(), {});
}

}  // namespace wristwise
