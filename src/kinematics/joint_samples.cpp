#include "kinematics/joint_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDefaultSlide = 0.1;            // m
constexpr double kDefaultTurn = 10 * kPi / 180;  // rad
constexpr double kDefaultCombinations = 100;
constexpr double kMostCombinations = 1e5;
constexpr double kCoarser = 1.05;
constexpr double kFewest = 3;  // samples of a joint by default

bool turns_round(const Joint& joint) {
  return joint.type != JointType::prismatic && joint.upper - joint.lower >= 2 * kPi - 1e-12;
}

double width(const Joint& joint) {
  return turns_round(joint) ? 2 * kPi : joint.upper - joint.lower;
}

/// Of the fewest equal intervals; a quotient that is whole up to round-off counts as whole.
double intervals(const Joint& joint, double step) {
  return std::max(1.0, std::ceil(width(joint) / step - 1e-9));
}

double sample_count(const Joint& joint, double step) {
  if (width(joint) == 0) return 1;
  return intervals(joint, step) + (turns_round(joint) ? 0 : 1);
}

std::vector<double> samples(const Joint& joint, double step) {
  if (width(joint) == 0) return {joint.lower};
  const auto count = static_cast<int>(intervals(joint, step));
  std::vector<double> values;
  for (int k = turns_round(joint) ? 1 : 0; k <= count; ++k) {
    const double lower = turns_round(joint) ? -kPi : joint.lower;
    const double value = k == count ? lower + width(joint) : lower + k * width(joint) / count;
    values.push_back(joint.type == JointType::prismatic ? value : wrap_angle(value));
  }
  return values;
}

/// The steps of some joints of a robot, those that are not given as coarse as need be.
class Steps {
 public:
  Steps(const Robot& robot, const std::vector<int>& joints, const JointSteps& given) {
    for (const int j : joints) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      const auto found = given.find(joint.name);
      const bool is_given = found != given.end() && found->second > 0;
      const double usual = joint.type == JointType::prismatic ? kDefaultSlide : kDefaultTurn;
      steps_.push_back({&joint, is_given ? found->second : usual, is_given});
    }
    while (combinations() > kDefaultCombinations && coarsen()) {
    }
    if (combinations() > kMostCombinations) refuse();
  }

  double of(std::size_t index) const { return steps_[index].step; }

 private:
  struct Step {
    const Joint* joint;
    double step;
    bool given;
  };

  double combinations() const {
    double product = 1;
    for (const Step& step : steps_) product *= sample_count(*step.joint, step.step);
    return product;
  }

  /// @return whether there was a step to change
  bool coarsen() {
    bool changed = false;
    for (Step& step : steps_) {
      if (step.given || sample_count(*step.joint, step.step) <= kFewest) continue;
      step.step *= kCoarser;
      changed = true;
    }
    return changed;
  }

  [[noreturn]] void refuse() const {
    char text[96];
    std::snprintf(text, sizeof text, "the steps of the sampled joints make %.3g combinations",
                  combinations());
    throw InvalidInput("graph.samples", text, "at most 100,000: larger steps");
  }

  std::vector<Step> steps_;
};

}  // namespace

std::vector<SampledJoint> sample_joints(const Robot& robot, const std::vector<int>& joints,
                                        const JointSteps& steps) {
  const Steps chosen(robot, joints, steps);
  std::vector<SampledJoint> sampled;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(joints[i])];
    sampled.push_back({joints[i], samples(joint, chosen.of(i))});
  }
  return sampled;
}

}  // namespace wristwise
