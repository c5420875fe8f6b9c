// Inverse kinematics of your own. wristwise finds the closed form of most six-axis arms and solves
// other chains numerically. Where you know a closed form that it does not, it is faster and misses
// nothing. Here: the planar arm of three links, as in problems/planar_3r.yaml.

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <wristwise/wristwise.hpp>

namespace {

class PlanarArm final : public wristwise::InverseKinematics {
 public:
  explicit PlanarArm(const wristwise::Robot& robot) {
    if (robot.joint_count() != 3) fail("it has not three joints");
    for (const wristwise::Joint& joint : robot.joints())
      if (joint.type == wristwise::JointType::prismatic || joint.axis != Eigen::Vector3d::UnitZ())
        fail("a joint does not turn about z");
    if (!robot.joints()[0].origin.isApprox(wristwise::Pose::Identity()))
      fail("joint 1 is not at the base");
    first_ = length(robot.joints()[1].origin);
    second_ = length(robot.joints()[2].origin);
    third_ = length(robot.tcp());
  }

  // Every solution, turning joints in (-pi, pi], inside the joint limits or not, always in the same
  // order. The planner adds whole turns and drops what is beyond the limits. It calls this from
  // several threads.
  void solve(const wristwise::Pose& tcp,
             std::vector<wristwise::JointVector>& branches) const override {
    branches.clear();
    if (std::abs(tcp.translation().z()) > kFlat || tcp.linear()(2, 2) < 1 - kFlat) return;
    // Back from the TCP along the third link, then the triangle of the first two.
    const double heading = std::atan2(tcp.linear()(1, 0), tcp.linear()(0, 0));
    const double x = tcp.translation().x() - third_ * std::cos(heading);
    const double y = tcp.translation().y() - third_ * std::sin(heading);
    const double cosine =
        (x * x + y * y - first_ * first_ - second_ * second_) / (2 * first_ * second_);
    if (std::abs(cosine) > 1) return;  // out of reach
    for (const double elbow : {std::acos(cosine), -std::acos(cosine)}) {
      wristwise::JointVector q(3);
      q[0] = std::atan2(y, x) -
             std::atan2(second_ * std::sin(elbow), first_ + second_ * std::cos(elbow));
      q[1] = elbow;
      q[2] = heading - q[0] - elbow;
      for (double& angle : q) angle = wristwise::wrap_angle(angle);
      branches.push_back(q);
      if (elbow == 0) return;  // stretched: both are the same
    }
  }

  std::string description() const override { return "closed form of a planar arm"; }

 private:
  static constexpr double kFlat = 1e-9;  // m, and 1 - cosine

  [[noreturn]] static void fail(const std::string& why) {
    throw wristwise::InvalidInput("robot", why, "a planar arm of three links along x");
  }

  /// Of a link that leads along x.
  static double length(const wristwise::Pose& link) {
    const double x = link.translation().x();
    if (x <= 0 || !link.isApprox(wristwise::Pose(Eigen::Translation3d(x, 0, 0))))
      fail("a link does not lead along x");
    return x;
  }

  double first_ = 0, second_ = 0, third_ = 0;  // m
};

void print(const wristwise::PlanResult& result) {
  std::cout << result.inverse_kinematics << ": cost " << std::setprecision(10) << result.graph.cost
            << std::setprecision(3) << ", sampled in " << result.timing.sampling << " s\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw wristwise::InvalidInput("usage", "PROBLEM.yaml BUILT_IN.csv OWN.csv");
    wristwise::Problem problem = wristwise::load_problem(argv[1]);
    const auto own = std::make_shared<const PlanarArm>(*problem.robot);

    const wristwise::PlanResult built_in = wristwise::plan_graph_only(problem);
    problem.inverse_kinematics = own;  // all that is needed
    const wristwise::PlanResult result = wristwise::plan_graph_only(problem);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    print(built_in);
    print(result);

    write_path(argv[2], problem.robot->joint_names(), built_in.path);
    write_path(argv[3], problem.robot->joint_names(), result.path);
    return result.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
