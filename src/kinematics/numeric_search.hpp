#pragma once

#include <memory>
#include <vector>

#include "kinematics/descent.hpp"
#include "kinematics/posture_table.hpp"
#include "kinematics/solution_set.hpp"
#include "wristwise/numeric_inverse_kinematics.hpp"

namespace wristwise {

/// The search for solutions behind NumericInverseKinematics.
class NumericSearch {
 public:
  NumericSearch(std::shared_ptr<const Robot> robot, const NumericIkOptions& options);

  void solve(const Pose& tcp, std::vector<JointVector>& solutions) const;

  /// Anywhere in a cell, from postures that come near one pose of it.
  void solve_in_cell(const DeviationCell& cell, std::vector<JointVector>& solutions) const;

  /// From postures that come near poses all over the cell.
  void solve_all_over(const DeviationCell& cell, std::vector<JointVector>& solutions) const;

  int rank() const { return rank_; }
  bool is_redundant() const { return robot_->joint_count() > rank_; }
  const NumericIkOptions& options() const { return options_; }
  const Robot& robot() const { return *robot_; }

 private:
  struct Progress {
    std::vector<int> tried;
    int vain = 0;
  };

  template <class Start>
  void start_near(const Pose& tcp, double slack, int most_starts,
                  const std::vector<JointVector>& solutions, Progress& progress,
                  const Start& start) const;
  void solve_inside_limits(const DeviationCell& point, std::vector<JointVector>& solutions) const;
  void search_cell_near(const Pose& tcp, const DeviationCell& cell, double slack, int most_starts,
                        std::vector<JointVector>& solutions, Progress& progress) const;
  double inner_distance(const JointVector& a, const JointVector& b) const;
  bool is_tried(const std::vector<int>& tried, const JointVector& posture) const;
  bool is_near_one(const std::vector<JointVector>& solutions, const JointVector& posture) const;
  void turn_inside(JointVector& q) const;
  double slack_of(const DeviationCell& cell) const;

  std::shared_ptr<const Robot> robot_;
  NumericIkOptions options_;
  int rank_ = 0;
  DescentRules to_pose_, in_cell_;
  std::unique_ptr<const PostureTable> table_;
};

}  // namespace wristwise
