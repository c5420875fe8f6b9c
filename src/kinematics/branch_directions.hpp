#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "kinematics/arc_tangent.hpp"
#include "kinematics/planar_turn.hpp"
#include "wristwise/joints.hpp"

namespace wristwise {

/// The solutions of one pose while their joint angles are still directions, so that the angles of
/// all are taken at once: most of the time of a closed form goes into arc tangents.
class BranchDirections {
 public:
  static constexpr std::size_t kMostArms = 4;           ///< two shoulders with two elbows each
  static constexpr std::size_t kMostWristsOfAnArm = 8;  ///< WorkspaceMargin::wrist_starts

  enum class Wrist {
    single,
    flipped,  ///< stands for two: (q4, phi + psi, q6) and (q4 + pi, phi - psi, q6 + pi)
  };

  void add_shoulder(double x, double y) { shoulder_ = add(x, y); }
  /// An elbow of the last shoulder.
  void add_elbow(const PlanarTurn& turn_2, const PlanarTurn& turn_3) {
    elbow_ = add(turn_2.cosine, turn_2.sine);
    add(turn_3.cosine, turn_3.sine);
  }
  /// A wrist of the last elbow, by the directions of q4, psi = q5 - phi, and q6.
  void add_wrist(Wrist wrist, const PlanarTurn& turn_4, const PlanarTurn& psi, double x_6,
                 double y_6) {
    assert(wrist_count_ < wrists_.size());
    wrists_[wrist_count_++] = {shoulder_, elbow_, add(turn_4.cosine, turn_4.sine), wrist};
    add(psi.cosine, psi.sine);
    add(x_6, y_6);
  }

  /// Appends the solutions in the order in which they were added, angles in (-pi, pi].
  void append_to(std::vector<JointVector>& branches, double phi) {
    if (wrist_count_ == 0) return;
    if (count_ % 2 != 0) add(1, 0);  // whole pairs
    angles_of_directions(static_cast<std::size_t>(count_), x_.data(), y_.data(), angle_.data());
    for (std::size_t i = 0; i < wrist_count_; ++i) {
      const Entry& wrist = wrists_[i];
      const double* arm = &angle_[wrist.elbow];
      const double* end = &angle_[wrist.joint_4];
      double* q = branches.emplace_back(6).data();
      fill(q, angle_[wrist.shoulder], arm, end[0], wrapped(phi + end[1]), end[2]);
      if (wrist.kind == Wrist::single) continue;
      q = branches.emplace_back(6).data();
      fill(q, angle_[wrist.shoulder], arm, opposite(end[0]), wrapped(phi - end[1]),
           opposite(end[2]));
    }
  }

 private:
  static constexpr double kPi = 3.14159265358979323846;
  static constexpr std::size_t kMostWrists = kMostArms * kMostWristsOfAnArm;
  static constexpr int kMostAngles = static_cast<int>(2 + 2 * kMostArms + 3 * kMostWrists);

  struct Entry {
    int shoulder, elbow, joint_4;  // where their angles start
    Wrist kind;
  };

  int add(double x, double y) {
    x_[count_] = x;
    y_[count_] = y;
    return count_++;
  }

  static void fill(double* q, double q1, const double* arm, double q4, double q5, double q6) {
    q[0] = q1;
    q[1] = arm[0];
    q[2] = arm[1];
    q[3] = q4;
    q[4] = q5;
    q[5] = q6;
  }

  /// Of an angle in (-2 pi, 2 pi], into (-pi, pi].
  static double wrapped(double angle) {
    return angle - (angle > kPi ? 2 * kPi : 0) + (angle <= -kPi ? 2 * kPi : 0);
  }
  static double opposite(double angle) { return wrapped(angle + kPi); }

  // Eigen's arrays, as they are not set to zero for each pose.
  Eigen::Array<double, kMostAngles, 1> x_, y_, angle_;
  std::array<Entry, kMostWrists> wrists_{};
  std::size_t wrist_count_ = 0;
  int count_ = 0;
  int shoulder_ = 0, elbow_ = 0;
};

}  // namespace wristwise
