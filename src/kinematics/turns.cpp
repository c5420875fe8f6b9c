#include <cmath>

#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr double kLimitTolerance = 1e-12;

/// The whole turns first .. first + count - 1 that keep a joint inside its limits.
struct TurnRange {
  double first;
  int count;
};

bool inside(const Joint& joint, double value) {
  return value >= joint.lower - kLimitTolerance && value <= joint.upper + kLimitTolerance;
}

TurnRange principal_turn(const Joint& joint, double value) {
  const bool is_principal = value > -kTurn / 2 && value <= kTurn / 2;
  const double turn = is_principal ? 0 : std::round((wrap_angle(value) - value) / kTurn);
  return {turn, inside(joint, value + turn * kTurn) ? 1 : 0};
}

TurnRange all_turns(const Joint& joint, double value) {
  // Most limits leave room for one turn or two: no division.
  const double least = joint.lower - kLimitTolerance - value;
  const double most = joint.upper + kLimitTolerance - value;
  if (least > -kTurn && most < kTurn) return {0, least <= 0 && most >= 0 ? 1 : 0};
  if (least > -2 * kTurn && most < 2 * kTurn) {
    const auto allows = [&](double shift) { return shift >= least && shift <= most ? 1 : 0; };
    const int below = allows(-kTurn), here = allows(0);
    return {static_cast<double>(below != 0 ? -1 : 1 - here), below + here + allows(kTurn)};
  }
  const double first = std::ceil(least / kTurn);
  const double last = std::floor(most / kTurn);
  return {first, last >= first ? static_cast<int>(last - first) + 1 : 0};
}

TurnRange turn_range(const Joint& joint, double value, Turns turns) {
  if (!std::isfinite(value)) return {0, 0};
  if (joint.type == JointType::prismatic) return {0, inside(joint, value) ? 1 : 0};
  if (turns == Turns::principal || joint.type == JointType::continuous) {
    return principal_turn(joint, value);
  }
  return all_turns(joint, value);
}

/// Those of every joint.
struct TurnRanges {
  Eigen::Array<double, kMaxJoints, 1> first;
  Eigen::Array<int, kMaxJoints, 1> count;
};

/// The copies after the first, the turns of the last joint changing fastest.
void append_further_turns(const TurnRanges& ranges, const JointVector& branch, int copies,
                          std::vector<JointVector>& postures) {
  Eigen::Array<int, kMaxJoints, 1> turn = Eigen::Array<int, kMaxJoints, 1>::Zero();
  for (int copy = 1; copy < copies; ++copy) {
    Eigen::Index last = branch.size() - 1;
    while (++turn[last] == ranges.count[last]) turn[last--] = 0;
    JointVector& q = postures.emplace_back(branch);
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      q[j] += kTurn * (ranges.first[j] + turn[j]);
    }
  }
}

}  // namespace

int append_turns(const Robot& robot, const JointVector& branch, Turns turns,
                 std::vector<JointVector>& postures, int* limiting_joint) {
  if (limiting_joint != nullptr) *limiting_joint = -1;
  const int joints = robot.joint_count();
  TurnRanges ranges;
  int copies = 1;
  for (int j = 0; j < joints; ++j) {
    const TurnRange range =
        turn_range(robot.joints()[static_cast<std::size_t>(j)], branch[j], turns);
    if (range.count == 0) {
      if (limiting_joint != nullptr) *limiting_joint = j;
      return 0;
    }
    ranges.first[j] = range.first;
    ranges.count[j] = range.count;
    copies *= range.count;
  }
  JointVector q = branch;
  for (int j = 0; j < joints; ++j) q[j] += kTurn * ranges.first[j];
  postures.push_back(q);
  if (copies > 1) append_further_turns(ranges, branch, copies, postures);
  return copies;
}

}  // namespace wristwise
