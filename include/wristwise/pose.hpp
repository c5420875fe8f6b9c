#pragma once

#include <Eigen/Geometry>
#include <array>

#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// A rigid transformation; positions in m.
using Pose = Eigen::Isometry3d;

/// A value for each coordinate of a deviation: x, y, z (m) and about x, y, z (rad).
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Order of the three turns about moving axes; the names read R = R_first R_second R_third.
/// Only cyclic orders are used, so that one set of formulas serves all three.
enum class EulerSequence { xyz, yzx, zxy };

/// The axes (0 x, 1 y, 2 z) of the three turns of a sequence.
std::array<int, 3> euler_axes(EulerSequence sequence);

/// Angles (rad) of R about the axes x, y, z, in this order whatever the sequence (F1).
/// The second angle of the sequence is in [-pi/2, pi/2], the others in (-pi, pi].
/// Where the second is +-pi/2 the third is set to zero.
Eigen::Vector3d euler_angles(const Eigen::Matrix3d& rotation,
                             EulerSequence sequence = EulerSequence::xyz);

/// Inverse of euler_angles: the rotation with these angles (rad) about x, y, z.
Eigen::Matrix3d rotation_from_euler(const Eigen::Vector3d& angles,
                                    EulerSequence sequence = EulerSequence::xyz);

/// The matrix that turns an angular velocity in the fixed frame into rates of the angles about
/// x, y, z (F2). Singular where the second angle is +-pi/2; there its cosine is replaced by 1e-9.
Eigen::Matrix3d euler_rate_matrix(const Eigen::Vector3d& angles,
                                  EulerSequence sequence = EulerSequence::xyz);

/// Fixed-axis roll, pitch, yaw (rad) as in URDF: R = Rz(yaw) Ry(pitch) Rx(roll).
Pose pose_from_xyz_rpy(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy);

/// The angle in (-pi, pi] that differs from `angle` by whole turns.
double wrap_angle(double angle);

}  // namespace wristwise
