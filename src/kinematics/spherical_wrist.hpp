#pragma once

#include <vector>

#include "kinematics/planar_turn.hpp"
#include "kinematics/six_axes.hpp"

namespace wristwise {

class BranchDirections;

/// How far outside its workspace the closed form still answers, with the nearest posture.
struct WorkspaceMargin {
  double length = 1e-12;  ///< m
  double angle = 1e-12;   ///< rad
  /// rad: solutions nearer to a double root of shoulder or elbow, or to a straight wrist, than this
  /// are moved away from it. Zero where exact solutions are wanted.
  double arm_separation = 0;
  double wrist_separation = 0;
  /// Postures given for a wrist that was moved away, with joint 4 spread over a whole turn.
  int wrist_starts = 1;
  static constexpr int kMostWristStarts = 8;  ///< more are not given
};

/// The inverse kinematics of an arm whose axes 2 and 3 are parallel and whose axes 4, 5 and 6 meet
/// in one point, in closed form (F7).
class SphericalWrist {
 public:
  /// @pre axes 2 and 3 are parallel or opposite, axis 1 is not parallel to them, axes 4, 5, 6 pass
  /// through `wrist_centre` (m) and no two neighbours of them are parallel; upper arm and forearm
  /// have a length.
  SphericalWrist(const SixAxes& axes, const Eigen::Vector3d& wrist_centre);

  /// Appends every solution, angles in (-pi, pi], ordered by shoulder, elbow, wrist.
  void solve(const Pose& tcp, const WorkspaceMargin& margin,
             std::vector<JointVector>& branches) const;

  double shoulder_radius() const { return shoulder_radius_; }  ///< m, between axes 1 and 2
  double side_offset() const { return side_offset_; }          ///< m, along axis 2
  double upper_arm() const { return upper_arm_; }              ///< m, between axes 2 and 3
  double forearm() const { return forearm_; }                  ///< m, from axis 3 to the wrist
  double tool_length() const { return wrist_in_tcp_.norm(); }  ///< m, from the wrist to the TCP

 private:
  struct ToolPose;      // what is left of the TCP pose inside the arm
  struct WristAngles {  // constants of t1 and t2, the angles between axes 4 and 5, 5 and 6
    WristAngles(double t1, double t2);
    double sine_difference, cosine_1_sine_2, sine_2;
    PlanarTurn half_least, half_most;  // of the angle between axes 4 and 6
  };

  void solve_elbow(const ToolPose& tool, const WorkspaceMargin& margin,
                   BranchDirections& directions) const;
  void solve_wrist(const Eigen::Vector3d& axis_6, const Eigen::Vector3d& side_6,
                   const WorkspaceMargin& margin, BranchDirections& directions) const;
  void solve_right_angled_wrist(const Eigen::Vector3d& axis_6, const Eigen::Vector3d& side_6,
                                BranchDirections& directions) const;
  void solve_any_wrist(const Eigen::Vector3d& axis_6, const Eigen::Vector3d& side_6,
                       const WorkspaceMargin& margin, BranchDirections& directions) const;

  // Frames of constant orientation, z along an axis at zero; see the derivation in the source.
  Eigen::Matrix3d base_to_1_;
  Eigen::Matrix3d from_1_to_2_, from_2_to_4_, from_4_to_5_;
  Eigen::Vector3d point_1_;     // on axis 1, nearest to axis 2
  Eigen::Vector3d offset_1_2_;  // from axis 2's point to axis 1's, in frame 2
  Eigen::Vector3d wrist_in_tcp_, axis_6_in_tcp_, side_6_in_tcp_;
  Eigen::Vector3d side_6_, normal_6_;  // in frame 5
  double shoulder_radius_ = 0;
  double side_offset_ = 0;
  double shoulder_cos_ = 0, shoulder_sin_ = 1;  // of the angle between axes 1 and 2
  double upper_arm_ = 0, forearm_ = 0, axis_3_sign_ = 1;
  PlanarTurn forearm_turn_;
  WristAngles wrist_{1, 1};
  PlanarTurn wrist_zero_;      // joint 5 where axis 6 is nearest to axis 4
  double phi_ = 0;             // the same as an angle
  bool right_angled_ = false;  // axis 5 is perpendicular to axes 4 and 6
};

}  // namespace wristwise
