#include <array>
#include <cmath>

#include "wristwise/inverse_kinematics.hpp"

namespace wristwise {
namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr double kLimitTolerance = 1e-12;

/// The whole turns first .. first + count - 1 that keep a joint inside its limits.
struct TurnRange {
  double first = 0;
  int count = 0;
};

bool inside(const Joint& joint, double value) {
  return value >= joint.lower - kLimitTolerance && value <= joint.upper + kLimitTolerance;
}

TurnRange turn_range(const Joint& joint, double value, Turns turns) {
  if (!std::isfinite(value)) return {};
  if (joint.type == JointType::prismatic) return {0, inside(joint, value) ? 1 : 0};
  const double principal = (wrap_angle(value) - value) / kTurn;
  if (turns == Turns::principal || joint.type == JointType::continuous) {
    const double turn = std::round(principal);
    return {turn, inside(joint, value + turn * kTurn) ? 1 : 0};
  }
  const double first = std::ceil((joint.lower - kLimitTolerance - value) / kTurn);
  const double last = std::floor((joint.upper + kLimitTolerance - value) / kTurn);
  return {first, last >= first ? static_cast<int>(last - first) + 1 : 0};
}

}  // namespace

int append_turns(const Robot& robot, const JointVector& branch, Turns turns,
                 std::vector<JointVector>& postures, int* limiting_joint) {
  if (limiting_joint != nullptr) *limiting_joint = -1;
  const int joints = robot.joint_count();
  std::array<TurnRange, kMaxJoints> ranges;
  int copies = 1;
  for (int j = 0; j < joints; ++j) {
    const auto index = static_cast<std::size_t>(j);
    ranges[index] = turn_range(robot.joints()[index], branch[j], turns);
    if (ranges[index].count == 0) {
      if (limiting_joint != nullptr) *limiting_joint = j;
      return 0;
    }
    copies *= ranges[index].count;
  }
  for (int copy = 0; copy < copies; ++copy) {
    JointVector& q = postures.emplace_back(branch);
    int rest = copy;
    for (int j = joints - 1; j >= 0; --j) {
      const TurnRange& range = ranges[static_cast<std::size_t>(j)];
      q[j] += kTurn * (range.first + rest % range.count);
      rest /= range.count;
    }
  }
  return copies;
}

}  // namespace wristwise
