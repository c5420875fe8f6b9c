// Which joints of a chain with joints to spare are sampled.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "kinematics/redundant_inverse_kinematics.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr int kSolved = 6;       // joints, where they can be chosen
constexpr int kMostSampled = 3;  // joints

using Joints = std::vector<int>;  // by index, increasing

Joints named_joints(const Robot& robot, const JointSteps& steps) {
  const std::vector<std::string> names = robot.joint_names();
  Joints joints;
  for (const auto& [name, step] : steps) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InvalidInput("graph.samples", "no joint '" + name + "' on the chain",
                         "one such as " + similar_names(name, names));
    if (!(step >= 0) || std::isinf(step))
      throw InvalidInput("graph.samples." + name, std::to_string(step) + " is no step",
                         "a positive step, or 0 for the default; rad or m");
    joints.push_back(static_cast<int>(found - names.begin()));
  }
  std::sort(joints.begin(), joints.end());
  return joints;
}

/// Every set of `size` out of `count` joints that holds `named`.
std::vector<Joints> sets_with(const Joints& named, int size, int count) {
  std::vector<Joints> sets;
  std::vector<bool> chosen(static_cast<std::size_t>(count));
  std::fill_n(chosen.begin(), size, true);
  do {
    Joints set;
    for (int j = 0; j < count; ++j)
      if (chosen[static_cast<std::size_t>(j)]) set.push_back(j);
    if (std::includes(set.begin(), set.end(), named.begin(), named.end())) sets.push_back(set);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return sets;
}

/// Whether what is left of the chain is one piece of it.
bool leaves_one_piece(const Joints& sampled, int count) {
  Joints solved(static_cast<std::size_t>(count));
  std::iota(solved.begin(), solved.end(), 0);
  solved.erase(
      std::remove_if(solved.begin(), solved.end(),
                     [&](int j) { return std::binary_search(sampled.begin(), sampled.end(), j); }),
      solved.end());
  return solved.back() - solved.front() + 1 == static_cast<int>(solved.size());
}

/// The better choices first.
void sort_by_preference(std::vector<Joints>& sets, const Robot& robot) {
  const auto rank = [&](const Joints& set) {
    const auto prismatic = std::count_if(set.begin(), set.end(), [&](int j) {
      return robot.joints()[static_cast<std::size_t>(j)].type == JointType::prismatic;
    });
    return std::make_tuple(!leaves_one_piece(set, robot.joint_count()), -prismatic, set);
  };
  std::sort(sets.begin(), sets.end(),
            [&](const Joints& a, const Joints& b) { return rank(a) < rank(b); });
}

std::string refusal(const Robot& robot, int sampled) {
  return "no inverse kinematics: " + std::to_string(robot.joint_count()) + " joints, of which " +
         std::to_string(sampled) + " would have to be sampled; at most " +
         std::to_string(kMostSampled) + " can be";
}

/// The first finder that solves the rest of the chain, for the best choice of joints to sample.
InverseKinematicsFound find_sampled(const std::shared_ptr<const Robot>& robot,
                                    const JointSteps& steps,
                                    const std::vector<InverseKinematicsFinder>& finders) {
  const Joints named = named_joints(*robot, steps);
  const int spare = std::max(0, robot->joint_count() - kSolved);
  const int sampled = std::max(spare, static_cast<int>(named.size()));
  if (sampled > kMostSampled || sampled >= robot->joint_count())
    return {nullptr, refusal(*robot, sampled)};

  std::vector<Joints> sets = sets_with(named, sampled, robot->joint_count());
  sort_by_preference(sets, *robot);
  InverseKinematicsFound first;
  for (const InverseKinematicsFinder& finder : finders) {
    for (const Joints& set : sets) {
      InverseKinematicsFound found =
          sampled == 0
              ? finder(robot)
              : RedundantInverseKinematics::find(robot, sample_joints(*robot, set, steps), finder);
      if (found.solver) return found;
      if (first.description.empty()) first = std::move(found);
    }
  }
  return first;
}

}  // namespace

InverseKinematicsFound find_redundant_inverse_kinematics(
    const std::shared_ptr<const Robot>& robot, const JointSteps& steps,
    const std::vector<InverseKinematicsFinder>& finders) {
  if (!robot) throw InvalidInput("find_redundant_inverse_kinematics", "no robot");
  if (!finders.empty()) return find_sampled(robot, steps, finders);
  const auto closed = [](const auto& rest) { return find_closed_form(rest); };
  const auto any = [](const auto& rest) { return find_inverse_kinematics(rest); };
  InverseKinematicsFound found = find_sampled(robot, steps, {closed});
  if (found.solver) return found;
  return steps.empty() ? find_inverse_kinematics(robot) : find_sampled(robot, steps, {any});
}

}  // namespace wristwise
