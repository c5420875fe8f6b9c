#pragma once

#include <memory>
#include <vector>

#include "kinematics/even_points.hpp"
#include "kinematics/nearest_keys.hpp"
#include "wristwise/robot.hpp"

namespace wristwise {

/// Postures of a chain all over its workspace, found by where they reach. The first joint moves the
/// whole along or about a fixed axis and the last one turns the TCP about another, so that the
/// table holds the joints between them only, and few postures lie densely (F72).
class PostureTable {
 public:
  /// @param lower, upper ranges of the joints, rad or m, finite
  /// @param count of postures, at most
  PostureTable(std::shared_ptr<const Robot> robot, JointVector lower, JointVector upper, int count);

  struct Found {
    std::vector<NearestKeys::Neighbour> postures;  ///< the nearest first
    double first = 0;                              ///< rad or m, where the first joint has to be
  };

  /// The postures that come nearest to the pose. None: it is farther from all of them than they can
  /// be from any pose within reach.
  /// @param slack by how much the pose may change: m / length, rad
  void find(const Pose& tcp, int count, double slack, Found& found) const;

  /// Posture of the table, its first and last joint not meant.
  const JointVector& posture(int index) const { return postures_[static_cast<std::size_t>(index)]; }

  /// That posture with its first and last joint turned towards the pose.
  JointVector towards(const Pose& tcp, const Found& found, int index) const;

  double length() const { return length_; }  ///< m that move the TCP about as much as a radian

 private:
  struct Seen {
    NearestKeys::Key key = NearestKeys::Key::Zero();
    double first = 0;
  };

  bool first_is_free() const { return robot_->joint_count() > 1; }
  bool last_is_free() const { return robot_->joints().back().type != JointType::prismatic; }
  int inner_joints() const;
  JointVector sample(int index) const;
  double longest_reach(int samples) const;
  Seen see(const Pose& tcp) const;
  double widest_gap(int first_sample, int samples) const;

  std::shared_ptr<const Robot> robot_;
  JointVector lower_, upper_;
  Pose shoulder_;  // on the first joint's axis, z along it
  EvenPoints even_;
  double length_ = 1;
  double within_reach_ = 0;  // largest distance of a key to the nearest
  std::vector<JointVector> postures_;
  std::unique_ptr<const NearestKeys> keys_;
};

}  // namespace wristwise
