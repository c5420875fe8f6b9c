#pragma once

#include <memory>
#include <vector>

#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// Whether a posture, and the straight joint-space move between two waypoints, can be welded: the
/// clearance is kept (F10), the TCP stays near the seam and steps no farther than it may.
class MoveChecker {
 public:
  struct Limits {
    double stray = 0;     ///< m, of the TCP from the seam; infinity: any
    double tcp_step = 0;  ///< m, of the TCP from waypoint to waypoint; infinity: any
    double tcp_turn = 0;  ///< rad, likewise
    bool steps() const;   ///< are limited
    bool strays() const;  ///< are limited
  };

  /// @param epsilon m, of the swept clearance check
  MoveChecker(const Task& task, const std::shared_ptr<const ClearanceModel>& clearance,
              const Limits& limits, double epsilon, int threads);

  /// Does not depend on the worker (below `threads`), nor on what was asked before. Threads may ask
  /// about different waypoints.
  bool has_clearance(int worker, std::size_t waypoint, const JointVector& q);

  /// The move from a posture at waypoint `interval` to one at the next, steps_too_far left aside.
  /// Does not depend on the worker (below `threads`), nor on what was asked before.
  bool is_clear(int worker, std::size_t interval, const JointVector& from, const JointVector& to);

  /// The largest distance (m) of the TCP from the seam's tolerance at a quarter, half and three
  /// quarters of the move; 0 where no path is prescribed.
  double stray(std::size_t interval, const JointVector& from, const JointVector& to) const;

  bool steps_too_far(const JointVector& from, const JointVector& to) const;

  const Limits& limits() const { return limits_; }

  /// Exact distance queries made by all threads.
  std::size_t queries() const;

 private:
  struct Worker {
    ClearanceChecker checker;
    // The last blocked move. Only moves to the same end are tried for the same reason first, so
    // that the number of queries does not depend on who did what before.
    std::size_t interval = 0;
    JointVector to;
    int pair = -1;
    double s = 0.5;
  };
  bool is_blocked_as_before(Worker& worker, std::size_t interval, const JointVector& from,
                            const JointVector& to) const;

  const Robot& robot_;
  std::vector<Worker> workers_;
  struct Stretch {
    ToleranceBox tolerance;
    std::vector<Pose> frames;  ///< at a quarter, half and three quarters; none for free moves
  };
  static Stretch stretch(const Task& task, std::size_t interval);
  std::vector<Stretch> stretches_;  ///< between waypoints
  std::vector<int> near_pairs_;     ///< of the last posture of each waypoint that was too near
  Limits limits_;
  double required_;
  double epsilon_;
};

}  // namespace wristwise
