#include "collision/permanent_contacts.hpp"

#include <algorithm>
#include <random>

#include "collision/signed_distance.hpp"

namespace wristwise {

namespace {

using Body = ClearanceModel::Body;

constexpr double kPi = 3.14159265358979323846;
constexpr int kPostures = 256;
constexpr unsigned kSeed = 20170912;

/// Uniform within the limits; a whole turn for continuous joints. Written out because the standard
/// distributions differ from one library to the next.
JointVector random_posture(const Robot& robot, std::mt19937& random) {
  JointVector q(robot.joint_count());
  for (int j = 0; j < robot.joint_count(); ++j) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
    const bool bounded = joint.type != JointType::continuous;
    const double lower = bounded ? joint.lower : -kPi;
    const double upper = bounded ? joint.upper : kPi;
    q[j] = lower + (upper - lower) * (static_cast<double>(random()) / 4294967295.0);
  }
  return q;
}

bool nearer_than(const Body& a, const Body& b, const ChainPose& chain, double clearance) {
  const Pose frame_a = chain.frame(a.joint);
  const Pose frame_b = chain.frame(b.joint);
  return std::any_of(a.shapes.begin(), a.shapes.end(), [&](const Shape& shape_a) {
    const Pose pose_a = frame_a * shape_a.pose;
    return std::any_of(b.shapes.begin(), b.shapes.end(), [&](const Shape& shape_b) {
      const Pose pose_b = frame_b * shape_b.pose;
      return signed_distance({shape_a.geometry, pose_a}, {shape_b.geometry, pose_b}).distance <
             clearance;
    });
  });
}

}  // namespace

std::vector<bool> permanent_contacts(const Robot& robot, const std::vector<Body>& bodies,
                                     const std::vector<std::pair<int, int>>& pairs,
                                     double clearance) {
  std::mt19937 random(kSeed);
  std::vector<bool> permanent(pairs.size(), true);
  ChainPose chain;
  for (int sample = 0; sample < kPostures; ++sample) {
    forward_kinematics(robot, random_posture(robot, random), chain);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Body& a = bodies[static_cast<std::size_t>(pairs[i].first)];
      const Body& b = bodies[static_cast<std::size_t>(pairs[i].second)];
      const bool decided = !permanent[i] || (sample > 0 && a.joint == b.joint);
      if (!decided) permanent[i] = nearer_than(a, b, chain, clearance);
    }
  }
  return permanent;
}

}  // namespace wristwise
