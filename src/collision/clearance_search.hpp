#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "task/motion_piece.hpp"
#include "wristwise/clearance.hpp"

namespace wristwise {

/// The least distance found on a motion, and what is shown for all t.
struct ClearanceFinding {
  double least = std::numeric_limits<double>::infinity();  ///< m, measured; exact at its time
  int pair = -1;                                           ///< -1: none below the cutoff
  double time = 0;                                         ///< s
  double bound = std::numeric_limits<double>::infinity();  ///< m, every distance for all t
};

/// Looks for the least distance of all pairs along a motion by branch and bound: an interval is
/// left aside for a pair once its distance is shown (F10, F31) to stay above what was found
/// already, less `resolution`.
class ClearanceSearch {
 public:
  using Range = std::pair<double, double>;  ///< s

  /// @param resolution m, > 0
  ClearanceSearch(ClearanceChecker& checker, double resolution)
      : checker_(checker),
        resolution_(resolution),
        directions_(checker.model().pairs().size(), Eigen::Vector3d::Zero()) {}

  /// Measures one posture.
  void look_at(double time, const JointVector& q, ClearanceFinding& finding);

  /// The least distance below `finding.least`, and the bound, over one more piece of a motion:
  /// bound >= least - resolution.
  void look_along(const MotionPiece& piece, ClearanceFinding& finding);

  /// The pair's intervals on which the distance could not be shown to be at least `floor` (m), to a
  /// 32nd of the piece; with the pair, in order of time for each.
  std::vector<std::pair<int, Range>> not_shown(const MotionPiece& piece, double floor);

  std::size_t postures() const { return postures_; }

 private:
  /// A time, and where the joints are then.
  struct Instant {
    double time = 0;
    ChainPose chain;
  };
  struct Span {
    const MotionPiece& piece;
    int pair = -1;
    const Instant& first;
    const Instant& last;
    int depth = 0;
    double nearby = std::numeric_limits<double>::infinity();  ///< m, the last distance measured
  };

  Instant instant(const MotionPiece& piece, double time);
  double gap(int pair, const Instant& at) const;
  double bend(int pair, const MotionPiece::Polynomials& joints) const;
  PairDistance measure(int pair, const JointVector& q);

  void look(const Span& span, ClearanceFinding& finding);
  void mark(const Span& span, double floor, std::vector<std::pair<int, Range>>& ranges);

  ClearanceChecker& checker_;
  double resolution_;
  /// Unit, from the farther body of each pair to the nearer one, in the frame of the nearer one's
  /// joint; zero where none is known yet.
  std::vector<Eigen::Vector3d> directions_;
  std::size_t postures_ = 0;
};

}  // namespace wristwise
