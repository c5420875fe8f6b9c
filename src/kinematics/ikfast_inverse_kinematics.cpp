#include "wristwise/ikfast_inverse_kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/descent.hpp"
#include "kinematics/even_points.hpp"
#include "kinematics/ikfast_library.hpp"
#include "kinematics/ikfast_solutions.hpp"
#include "kinematics/solution_set.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr const char* kWhere = "IKFast solver";
constexpr double kCorrect = 1e-3;  // m and rad, of what is a solution before it is polished
constexpr double kAngleStep = kPi / 18;
constexpr double kLengthStep = 0.1;  // m
constexpr double kMostCombinations = 1e5;
constexpr int kCheckedPoses = 50;
constexpr int kPosesToMeet = 40;

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

bool is_near(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm() < kCorrect &&
         (a.linear() - b.linear()).norm() < kCorrect;
}

bool slides(const Joint& joint) { return joint.type == JointType::prismatic; }

/// Postures inside the limits; of an endless joint in (-pi, pi].
JointVector even_posture(const Robot& robot, int index) {
  const EvenPoints even(robot.joint_count());
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const double lower = std::isinf(joint.lower) ? -kPi : joint.lower;
    const double upper = std::isinf(joint.upper) ? kPi : joint.upper;
    q[j] = lower + even.at(index, j) * (upper - lower);
  }
  return q;
}

/// Both ends of the range; once round where a joint can turn round.
std::vector<double> samples_of(const Joint& joint, double step) {
  const bool round = !slides(joint) && joint.upper - joint.lower >= 2 * kPi;
  const double lower = round ? -kPi : joint.lower, upper = round ? kPi : joint.upper;
  if (lower == upper) return {lower};
  const double count = std::max(1.0, std::ceil((upper - lower) / step - 1e-9));
  if (!(count <= kMostCombinations))
    throw InvalidInput(kWhere, fmt::format("a step of {:g} for {}", step, joint.name),
                       "a larger step");
  std::vector<double> values(static_cast<std::size_t>(count) + (round ? 0 : 1));
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = lower + static_cast<double>(k) * (upper - lower) / count;
  return values;
}

}  // namespace

IkFastInverseKinematics::IkFastInverseKinematics(std::shared_ptr<const Robot> robot,
                                                 const IkFastFunctions& functions,
                                                 const FreeSteps& steps)
    : robot_(std::move(robot)), functions_(functions) {
  if (!robot_) throw InvalidInput(kWhere, "no robot");
  if (functions.compute_ik == nullptr || functions.free_parameter_count == nullptr ||
      functions.free_parameters == nullptr || functions.joint_count == nullptr) {
    throw InvalidInput(kWhere, "a function is missing",
                       "ComputeIk, GetNumFreeParameters, GetFreeParameters and GetNumJoints");
  }
  if (functions.joint_count() != robot_->joint_count()) {
    throw InvalidInput(kWhere, fmt::format("it has {} joints", functions.joint_count()),
                       fmt::format("the {} joints of the chain from {} to {}",
                                   robot_->joint_count(), robot_->base_link(), robot_->tip_link()));
  }
  find_free_joints();
  sample_free_joints(steps);
  if (functions_.compute_fk != nullptr) find_tool();
  check_robot();
}

IkFastInverseKinematics::~IkFastInverseKinematics() = default;

std::shared_ptr<const IkFastInverseKinematics> IkFastInverseKinematics::load(
    const std::shared_ptr<const Robot>& robot, const std::filesystem::path& file,
    const FreeSteps& steps) {
  const IkFastLibrary library = open_ikfast_library(file);
  auto solver = std::make_shared<IkFastInverseKinematics>(robot, library.functions, steps);
  solver->library_ = library.handle;
  return solver;
}

void IkFastInverseKinematics::find_free_joints() {
  const int count = functions_.free_parameter_count();
  const int* free = functions_.free_parameters();
  for (int i = 0; i < count; ++i) {
    if (free == nullptr || free[i] < 0 || free[i] >= robot_->joint_count())
      throw InvalidInput(kWhere, "a free parameter is none of its joints");
    free_joints_.push_back(free[i]);
  }
}

void IkFastInverseKinematics::sample_free_joints(const FreeSteps& steps) {
  free_samples_ = {{}};
  FreeSteps unused = steps;
  for (const int j : free_joints_) {
    const Joint& joint = robot_->joints()[static_cast<std::size_t>(j)];
    const auto given = steps.find(joint.name);
    const double step = given != steps.end() ? given->second
                        : slides(joint)      ? kLengthStep
                                             : kAngleStep;
    if (!(step > 0) || std::isinf(step))
      throw InvalidInput(kWhere, fmt::format("a step of {:g} for {}", step, joint.name),
                         "a positive step");
    unused.erase(joint.name);
    std::vector<std::vector<double>> product;
    for (const std::vector<double>& combination : free_samples_) {
      for (const double value : samples_of(joint, step)) {
        product.push_back(combination);
        product.back().push_back(value);
      }
    }
    free_samples_ = std::move(product);
    if (static_cast<double>(free_samples_.size()) > kMostCombinations)
      throw InvalidInput(kWhere, "its free parameters have too many samples", "larger steps");
  }
  if (!unused.empty())
    throw InvalidInput(kWhere, unused.begin()->first + " is no free parameter of it");
}

void IkFastInverseKinematics::find_tool() {
  const JointVector q = even_posture(*robot_, 0);
  Eigen::Vector3d position;
  RowMajor rotation;
  functions_.compute_fk(q.data(), position.data(), rotation.data());
  Pose tip = Pose::Identity();
  tip.translation() = position;
  tip.linear() = rotation;
  if (!tip.matrix().allFinite()) throw InvalidInput(kWhere, "its ComputeFk gives no pose");
  tool_ = tip.inverse() * tcp_pose(*robot_, q);
}

void IkFastInverseKinematics::check_robot() const {
  int met = 0;
  std::vector<JointVector> branches;
  for (int i = 0; i < kCheckedPoses; ++i) {
    const JointVector q = even_posture(*robot_, i);
    std::vector<double> free;
    for (const int j : free_joints_) free.push_back(q[j]);
    branches.clear();
    compute(tcp_pose(*robot_, q), free, branches);
    if (!branches.empty()) ++met;
  }
  if (met >= kPosesToMeet) return;
  throw InvalidInput(
      kWhere,
      fmt::format("it solves {} of {} poses that {} reaches", met, kCheckedPoses, robot_->name()),
      functions_.compute_fk != nullptr
          ? fmt::format("a solver for this robot, its base at {}", robot_->base_link())
          : fmt::format("a solver for this robot, from {} to the TCP", robot_->base_link()));
}

void IkFastInverseKinematics::solve(const Pose& tcp, std::vector<JointVector>& branches) const {
  branches.clear();
  if (!tcp.matrix().allFinite()) return;
  for (const std::vector<double>& free : free_samples_) compute(tcp, free, branches);
}

void IkFastInverseKinematics::compute(const Pose& tcp, const std::vector<double>& free,
                                      std::vector<JointVector>& branches) const {
  const Pose tip = tcp * tool_.inverse();
  const Eigen::Vector3d position = tip.translation();
  const RowMajor rotation = tip.linear();
  IkFastSolutions found;
  functions_.compute_ik(position.data(), rotation.data(), free.empty() ? nullptr : free.data(),
                        found);
  DescentRules rules;
  rules.upper = JointVector::Constant(robot_->joint_count(), kInfinity);
  rules.lower = -rules.upper;
  SolutionSet set(*robot_, 0, branches);
  for (JointVector q : found.postures()) {
    if (q.size() != robot_->joint_count() || !q.allFinite()) continue;
    if (!is_near(tcp_pose(*robot_, q), tcp)) continue;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const int j = free_joints_[i];
      rules.lower[j] = rules.upper[j] = q[j];
    }
    if (!descend_to_pose(*robot_, tcp, rules, q)) continue;
    set.add(std::move(q), [](const JointVector&) { return true; });
  }
}

std::string IkFastInverseKinematics::description() const {
  std::string text = "IKFast";
  for (const int j : free_joints_)
    text += fmt::format(", {} free", robot_->joints()[static_cast<std::size_t>(j)].name);
  if (!free_joints_.empty()) text += fmt::format(", {} samples", free_samples_.size());
  return text;
}

}  // namespace wristwise
