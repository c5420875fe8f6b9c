#include "kinematics/redundant_inverse_kinematics.hpp"

#include <algorithm>
#include <utility>

#include "kinematics/partial_chain.hpp"

namespace wristwise {

namespace {

std::shared_ptr<const Robot> without_links(const Robot& robot) {
  Robot::Parts parts = robot.parts();
  parts.links.clear();
  parts.adjacent_links.clear();
  return std::make_shared<const Robot>(std::move(parts));
}

}  // namespace

// (F61) With the sampled joints before and behind the solved ones, the TCP is
//   T = B(q) S(q) E(q),
// B the product of the joints before, S that of the others, E that of the joints behind with the
// TCP. A solver of the chain that is held at the first samples q^0 has to reach
//   T' = B(q^0) B(q)^-1 T E(q)^-1 E(q^0),
// and serves for every sample of B and E. Joints between the solved ones change S itself: a solver
// for each of their samples.

InverseKinematicsFound RedundantInverseKinematics::find(const std::shared_ptr<const Robot>& robot,
                                                        std::vector<SampledJoint> sampled,
                                                        const InverseKinematicsFinder& finder) {
  const std::shared_ptr<RedundantInverseKinematics> result(
      new RedundantInverseKinematics(robot, std::move(sampled), finder));
  std::string description;
  for (JointVector& posture : result->combinations([&](int j) { return result->is_between(j); })) {
    InverseKinematicsFound found = result->solver_with(posture);
    if (!found.solver) return found;
    if (description.empty()) description = found.description;
    result->middles_.push_back({std::move(posture), std::move(found.solver)});
  }
  std::string names;
  for (const SampledJoint& joint : result->sampled_) {
    names += (names.empty() ? "" : ", ") +
             robot->joints()[static_cast<std::size_t>(joint.joint)].name + " at " +
             std::to_string(joint.values.size()) +
             (joint.values.size() == 1 ? " value" : " values");
  }
  result->description_ = names + "; for each: " + description;
  return {result, result->description_};
}

RedundantInverseKinematics::RedundantInverseKinematics(const std::shared_ptr<const Robot>& robot,
                                                       std::vector<SampledJoint> sampled,
                                                       InverseKinematicsFinder finder)
    : robot_(without_links(*robot)), sampled_(std::move(sampled)), finder_(std::move(finder)) {
  first_ = JointVector::Zero(robot_->joint_count());
  for (const SampledJoint& joint : sampled_) {
    held_.push_back(joint.joint);
    first_[joint.joint] = joint.values.front();
  }
  for (int j = 0; j < robot_->joint_count(); ++j)
    if (!std::binary_search(held_.begin(), held_.end(), j)) solved_.push_back(j);
  for (JointVector& q : combinations([&](int j) { return is_before(j); }))
    first_ends_.push_back(first_end(std::move(q)));
  for (JointVector& q : combinations([&](int j) { return is_behind(j); }))
    last_ends_.push_back(last_end(std::move(q)));
}

/// Of the sampled joints that are accepted; the others at their first sample.
template <class Accept>
std::vector<JointVector> RedundantInverseKinematics::combinations(const Accept& accept) const {
  std::vector<JointVector> postures = {first_};
  for (const SampledJoint& joint : sampled_) {
    if (!accept(joint.joint)) continue;
    std::vector<JointVector> product;
    product.reserve(postures.size() * joint.values.size());
    for (const JointVector& partial : postures) {
      for (const double value : joint.values) {
        product.push_back(partial);
        product.back()[joint.joint] = value;
      }
    }
    postures = std::move(product);
  }
  return postures;
}

Pose RedundantInverseKinematics::before(const JointVector& posture) const {
  Pose result = Pose::Identity();
  for (int j = 0; is_before(j); ++j)
    result = result * joint_transform(robot_->joints()[static_cast<std::size_t>(j)], posture[j]);
  return result;
}

Pose RedundantInverseKinematics::behind(const JointVector& posture) const {
  Pose result = Pose::Identity();
  for (int j = solved_.back() + 1; j < robot_->joint_count(); ++j)
    result = result * joint_transform(robot_->joints()[static_cast<std::size_t>(j)], posture[j]);
  return result * robot_->tcp();
}

RedundantInverseKinematics::End RedundantInverseKinematics::first_end(JointVector posture) const {
  const Pose correction = before(first_) * before(posture).inverse();
  return {std::move(posture), correction};
}

RedundantInverseKinematics::End RedundantInverseKinematics::last_end(JointVector posture) const {
  const Pose correction = behind(posture).inverse() * behind(first_);
  return {std::move(posture), correction};
}

InverseKinematicsFound RedundantInverseKinematics::solver_with(const JointVector& posture) const {
  JointVector held = first_;
  for (const int j : held_)
    if (is_between(j)) held[j] = posture[j];
  return finder_(std::make_shared<const Robot>(with_held_joints(*robot_, held_, held)));
}

void RedundantInverseKinematics::append(const Pose& tcp, const End& first, const End& last,
                                        const Middle& middle, std::vector<JointVector>& scratch,
                                        std::vector<JointVector>& branches) const {
  middle.solver->solve(first.correction * tcp * last.correction, scratch);
  for (const JointVector& solved : scratch) {
    JointVector& q = branches.emplace_back(middle.posture);
    for (const int j : held_) {
      if (is_before(j)) q[j] = first.posture[j];
      if (is_behind(j)) q[j] = last.posture[j];
    }
    for (std::size_t i = 0; i < solved_.size(); ++i)
      q[solved_[i]] = solved[static_cast<Eigen::Index>(i)];
  }
}

void RedundantInverseKinematics::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  branches.clear();
  std::vector<JointVector> scratch;
  for (const End& first : first_ends_)
    for (const End& last : last_ends_)
      for (const Middle& middle : middles_) append(tcp, first, last, middle, scratch, branches);
}

void RedundantInverseKinematics::solve_beside(const Pose& tcp, const JointVector& posture,
                                              std::vector<JointVector>& branches) const {
  branches.clear();
  JointVector held = first_;
  for (const int j : held_) {
    const bool slides = robot_->joints()[static_cast<std::size_t>(j)].type == JointType::prismatic;
    held[j] = slides ? posture[j] : wrap_angle(posture[j]);
  }
  Middle middle{held, middles_.front().solver};
  if (middles_.size() > 1) middle.solver = solver_with(held).solver;
  if (!middle.solver) return;
  std::vector<JointVector> scratch;
  append(tcp, first_end(held), last_end(held), middle, scratch, branches);
}

}  // namespace wristwise
