#include "kinematics/numeric_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/chain_rank.hpp"
#include "kinematics/even_points.hpp"
#include "kinematics/nearest_in_cell.hpp"

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPoseTolerance = 1e-10;  // m and rad
constexpr double kConsistent = 1e-9;      // m and rad, of a pose that few joints can reach
constexpr double kSameStart = 0.4;        // rad or m
constexpr double kLeadsThere = 0.6;       // rad or m, of a start to a known solution
constexpr double kUnlimitedTravel = 10;   // m either way, of a slide without limits
constexpr int kStartsOfABoxPose = 8;
constexpr int kStartsOfASample = 16;

bool turns_round(const Joint& joint) {
  return joint.type != JointType::prismatic && joint.upper - joint.lower >= 2 * kPi;
}

/// What holds a joint back: its limits, unless it can turn round.
DescentRules rules_of(const Robot& robot, bool revolute_limits, double tolerance) {
  DescentRules rules;
  rules.tolerance = tolerance;
  rules.lower = robot.lower_limits();
  rules.upper = robot.upper_limits();
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    if (joint.type == JointType::prismatic || (revolute_limits && !turns_round(joint))) continue;
    rules.lower[j] = -kInfinity;
    rules.upper[j] = kInfinity;
  }
  return rules;
}

JointVector finite(JointVector bounds, const Robot& robot) {
  for (int j = 0; j < robot.joint_count(); ++j) {
    const bool slides = robot.joints()[static_cast<std::size_t>(j)].type == JointType::prismatic;
    const double most = slides ? kUnlimitedTravel : kPi;
    if (std::isinf(bounds[j])) bounds[j] = std::copysign(most, bounds[j]);
  }
  return bounds;
}

}  // namespace

NumericSearch::NumericSearch(std::shared_ptr<const Robot> robot, const NumericIkOptions& options)
    : robot_(std::move(robot)), options_(options), rank_(chain_rank(*robot_)) {
  const double tolerance = rank_ < 6 ? kConsistent : kPoseTolerance;
  to_pose_ = rules_of(*robot_, is_redundant(), tolerance);
  in_cell_ = rules_of(*robot_, true, tolerance);
  table_ = std::make_unique<const PostureTable>(robot_, finite(to_pose_.lower, *robot_),
                                                finite(to_pose_.upper, *robot_), options_.postures);
  to_pose_.length = in_cell_.length = table_->length();
}

void NumericSearch::solve(const Pose& tcp, std::vector<JointVector>& solutions) const {
  solutions.clear();
  if (!tcp.matrix().allFinite()) return;
  SolutionSet set(*robot_, options_.separation, solutions);
  const auto is_isolated = [&](const JointVector& q) {
    ChainPose chain;
    forward_kinematics(*robot_, q, chain);
    return !is_redundant() && rank_of(geometric_jacobian(*robot_, chain)) == rank_;
  };
  Progress progress;
  start_near(tcp, 0, options_.neighbours, solutions, progress, [&](JointVector q) {
    if (is_redundant()) turn_inside(q);
    return descend_to_pose(*robot_, tcp, to_pose_, q) && set.add(std::move(q), is_isolated);
  });
}

void NumericSearch::solve_in_cell(const DeviationCell& cell,
                                  std::vector<JointVector>& solutions) const {
  solutions.clear();
  if (!cell.path_frame.matrix().allFinite()) return;
  const Pose middle = pose_at_deviation(cell.box, cell.path_frame, cell.middle());
  Progress progress;
  search_cell_near(middle, cell, slack_of(cell), kStartsOfASample, solutions, progress);
}

void NumericSearch::solve_all_over(const DeviationCell& cell,
                                   std::vector<JointVector>& solutions) const {
  solutions.clear();
  if (!cell.path_frame.matrix().allFinite()) return;
  if (cell.lower == cell.upper) return solve_inside_limits(cell, solutions);
  const EvenPoints even(6);
  for (int i = 0; i < options_.box_poses; ++i) {
    Vector6 e = cell.middle();
    for (int k = 0; k < 6; ++k) {
      const double width = cell.is_free(k) ? 2 * kPi : cell.upper[k] - cell.lower[k];
      if (i > 0) e[k] += width * (even.at(i, k) - 0.5);
    }
    Progress progress;
    search_cell_near(pose_at_deviation(cell.box, cell.path_frame, e), cell, slack_of(cell),
                     kStartsOfABoxPose, solutions, progress);
  }
}

void NumericSearch::solve_inside_limits(const DeviationCell& point,
                                        std::vector<JointVector>& solutions) const {
  std::vector<JointVector> all, copies;
  solve(pose_at_deviation(point.box, point.path_frame, point.lower), all);
  for (JointVector& q : all) {
    if (append_turns(*robot_, q, Turns::all, copies) > 0) solutions.push_back(std::move(q));
  }
}

void NumericSearch::search_cell_near(const Pose& tcp, const DeviationCell& cell, double slack,
                                     int most_starts, std::vector<JointVector>& solutions,
                                     Progress& progress) const {
  SolutionSet set(*robot_, options_.separation, solutions);
  const auto is_isolated = [&](const JointVector& q) {
    Jacobian rows;
    cell.measure(*robot_, q, rows);
    for (int k = 0; k < 6; ++k) {
      if (!cell.is_fixed(k)) rows.row(k).setZero();
    }
    return rank_of(rows) == robot_->joint_count();
  };
  start_near(tcp, slack, most_starts, solutions, progress, [&](JointVector q) {
    turn_inside(q);
    return move_to_nearest_in_cell(*robot_, cell, in_cell_.lower, in_cell_.upper, q) &&
           polish_in_cell(*robot_, cell, in_cell_, q) && set.add(std::move(q), is_isolated);
  });
}

/// From the postures of the table that come nearest to the pose: first those that do not look as if
/// they led to a known solution.
template <class Start>
void NumericSearch::start_near(const Pose& tcp, double slack, int most_starts,
                               const std::vector<JointVector>& solutions, Progress& progress,
                               const Start& start) const {
  PostureTable::Found found;
  table_->find(tcp, options_.neighbours, slack, found);
  const int most_vain = std::min(options_.vain_starts, most_starts);
  const auto ends = [&] {
    const bool many = solutions.size() >= static_cast<std::size_t>(options_.most_of_continuum);
    return progress.vain >= most_vain || many ||
           static_cast<int>(progress.tried.size()) >= most_starts;
  };
  const auto try_start = [&](int index) {
    progress.tried.push_back(index);
    progress.vain = start(table_->towards(tcp, found, index)) ? 0 : progress.vain + 1;
  };
  std::vector<int> waiting;
  for (const NearestKeys::Neighbour& neighbour : found.postures) {
    if (ends()) return;
    const JointVector& posture = table_->posture(neighbour.index);
    if (is_tried(progress.tried, posture)) continue;
    if (is_near_one(solutions, posture)) {
      waiting.push_back(neighbour.index);
    } else {
      try_start(neighbour.index);
    }
  }
  for (const int index : waiting) {
    if (ends()) return;
    if (!is_tried(progress.tried, table_->posture(index))) try_start(index);
  }
}

/// Of the joints that a posture of the table fixes.
double NumericSearch::inner_distance(const JointVector& a, const JointVector& b) const {
  return a.size() > 2 ? posture_distance(*robot_, a, b, 1, a.size() - 1) : kInfinity;
}

bool NumericSearch::is_tried(const std::vector<int>& tried, const JointVector& posture) const {
  return std::any_of(tried.begin(), tried.end(), [&](int other) {
    return inner_distance(table_->posture(other), posture) < kSameStart;
  });
}

bool NumericSearch::is_near_one(const std::vector<JointVector>& solutions,
                                const JointVector& posture) const {
  return std::any_of(solutions.begin(), solutions.end(), [&](const JointVector& solution) {
    return inner_distance(solution, posture) < kLeadsThere;
  });
}

/// By a whole turn, where that brings a joint inside its limits.
void NumericSearch::turn_inside(JointVector& q) const {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    if (robot_->joints()[static_cast<std::size_t>(j)].type == JointType::prismatic) continue;
    const double turned = q[j] < in_cell_.lower[j] ? q[j] + 2 * kPi : q[j] - 2 * kPi;
    const bool is_outside = q[j] < in_cell_.lower[j] || q[j] > in_cell_.upper[j];
    if (is_outside && turned >= in_cell_.lower[j] && turned <= in_cell_.upper[j]) q[j] = turned;
  }
}

double NumericSearch::slack_of(const DeviationCell& cell) const {
  const Vector6 half = 0.5 * (cell.upper - cell.lower);
  return half.head<3>().norm() / table_->length() + half.tail<3>().norm();
}

}  // namespace wristwise
