#pragma once

#include <utility>
#include <vector>

#include "wristwise/robot.hpp"

namespace wristwise {

/// Largest difference of two postures in the joints [from, to), turns not counted, rad or m.
double posture_distance(const Robot& robot, const JointVector& a, const JointVector& b,
                        Eigen::Index from, Eigen::Index to);

/// Solutions of one problem, each once.
class SolutionSet {
 public:
  /// @param separation rad or m, of solutions of a continuum
  SolutionSet(const Robot& robot, double separation, std::vector<JointVector>& solutions)
      : robot_(robot), separation_(separation), solutions_(solutions) {}

  /// Adds a solution, turned into (-pi, pi], unless it is known: one that is as good as the same,
  /// or in a continuum one that is nearer than the separation.
  /// @param is_isolated says of a solution whether it is no part of a continuum
  /// @return whether it was added
  template <class IsIsolated>
  bool add(JointVector q, const IsIsolated& is_isolated) {
    turn_home(q);
    const double nearest = distance_to_nearest(q);
    if (nearest < kSame || (nearest < separation_ && !is_isolated(q))) return false;
    solutions_.push_back(std::move(q));
    return true;
  }

 private:
  static constexpr double kSame = 1e-5;  // rad or m: at a double root 1e-10 in the pose

  void turn_home(JointVector& q) const;
  double distance_to_nearest(const JointVector& q) const;

  const Robot& robot_;
  double separation_;
  std::vector<JointVector>& solutions_;
};

}  // namespace wristwise
