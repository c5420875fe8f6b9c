#pragma once

#include <memory>
#include <vector>

#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// Whether the straight joint-space move between two waypoints can be welded: the TCP stays near
/// the seam, and the clearance is kept (F10).
class MoveChecker {
 public:
  /// @param max_stray m, the largest distance of the TCP from the seam; infinity: any
  /// @param epsilon m, of the swept clearance check
  MoveChecker(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
              double max_stray, double epsilon, int threads);

  /// The move from a posture at waypoint `interval` to one at the next.
  /// Does not depend on the worker (below `threads`), nor on what was asked before.
  bool is_clear(int worker, std::size_t interval, const JointVector& from, const JointVector& to);

  /// The largest distance (m) of the TCP from the seam's tolerance at a quarter, half and three
  /// quarters of the move; 0 where no path is prescribed.
  double stray(std::size_t interval, const JointVector& from, const JointVector& to) const;

  double max_stray() const { return max_stray_; }

  /// Exact distance queries made by all threads.
  std::size_t queries() const;

 private:
  struct Worker {
    ClearanceChecker checker;
    int pair = -1;  ///< of the last blocked move
    double s = 0.5;
  };
  bool is_blocked_as_before(Worker& worker, const JointVector& from, const JointVector& to) const;

  const Robot& robot_;
  std::vector<Worker> workers_;
  struct Stretch {
    ToleranceBox tolerance;
    std::vector<Pose> frames;  ///< at a quarter, half and three quarters; none for free moves
  };
  static Stretch stretch(const Task& task, std::size_t interval);
  std::vector<Stretch> stretches_;  ///< between waypoints
  double max_stray_;
  double required_;
  double epsilon_;
};

}  // namespace wristwise
