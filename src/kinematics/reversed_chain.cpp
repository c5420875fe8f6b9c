#include "kinematics/reversed_chain.hpp"

namespace wristwise {

// (F62) With T = O_1 M_1 ... O_n M_n C, T^-1 = C^-1 M_n^-1 O_n^-1 ... M_1^-1 O_1^-1: joint n comes
// first, with the origin C^-1 and its axis turned round, and O_1^-1 is the constant at the end.
Robot reversed_chain(const Robot& robot) {
  Robot::Parts parts;
  parts.name = robot.name();
  parts.base_link = robot.tip_link();
  parts.tip_link = robot.part_link();
  Pose before = robot.tcp().inverse();
  for (auto joint = robot.joints().rbegin(); joint != robot.joints().rend(); ++joint) {
    parts.joints.push_back(*joint);
    parts.joints.back().origin = before;
    parts.joints.back().axis = -joint->axis;
    before = joint->origin.inverse();
  }
  parts.tcp = before;
  return Robot(std::move(parts));
}

void ReversedInverseKinematics::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  of_reversed_->solve(tcp.inverse(), branches);
  for (JointVector& branch : branches) branch = branch.reverse().eval();
}

std::string ReversedInverseKinematics::description() const {
  return "passed backwards: " + of_reversed_->description();
}

}  // namespace wristwise
