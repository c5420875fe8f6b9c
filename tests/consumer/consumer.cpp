#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#include <wristwise/wristwise.hpp>

namespace {

/// Inverse kinematics of the application's own: another's, counted.
class Counted : public wristwise::InverseKinematics {
 public:
  explicit Counted(std::shared_ptr<const wristwise::InverseKinematics> solver)
      : solver_(std::move(solver)) {}

  void solve(const wristwise::Pose& tcp,
             std::vector<wristwise::JointVector>& branches) const override {
    calls_.fetch_add(1, std::memory_order_relaxed);
    solver_->solve(tcp, branches);
  }
  std::string description() const override { return solver_->description(); }
  int calls() const { return calls_; }

 private:
  std::shared_ptr<const wristwise::InverseKinematics> solver_;
  mutable std::atomic<int> calls_{0};
};

int failed(const std::string& what) {
  std::fprintf(stderr, "consumer: %s\n", what.c_str());
  return 1;
}

bool refuses_a_missing_file() {
  try {
    wristwise::load_problem("no_such_problem.yaml");
  } catch (const wristwise::InvalidInput&) {
    return true;
  }
  return false;
}

}  // namespace

/// Plans task C (problems/task_c_wrist_singularity.yaml) and compares with what its file says.
int main(int argc, char** argv) {
  if (argc != 2) return failed("give task C");
  if (std::string(wristwise::library_version()) != wristwise::kHeaderVersion)
    return failed("headers and library are of different versions");
  if (!refuses_a_missing_file()) return failed("a missing problem is no InvalidInput");

  wristwise::Problem problem = wristwise::load_problem(argv[1]);
  const auto own =
      std::make_shared<Counted>(wristwise::find_inverse_kinematics(problem.robot).solver);
  problem.inverse_kinematics = own;
  const wristwise::PlanResult result = wristwise::plan(problem);

  if (result.status != wristwise::Status::solved) return failed("not solved");
  if (own->calls() == 0) return failed("the own inverse kinematics was not asked");
  if (result.path.size() != 50) return failed("not 50 waypoints");
  const Eigen::Vector3d first =
      wristwise::tcp_pose(*problem.robot, result.path.positions.front()).translation();
  const Eigen::Vector3d last =
      wristwise::tcp_pose(*problem.robot, result.path.positions.back()).translation();
  if ((first - Eigen::Vector3d(1.1, -0.18, 0.845)).norm() > 1e-5)
    return failed("the weld begins elsewhere");
  if ((last - Eigen::Vector3d(1.1, 0.18, 0.845)).norm() > 1e-5)
    return failed("the weld ends elsewhere");
  std::printf("wristwise %s: solved, %d postures asked for\n", wristwise::library_version(),
              own->calls());
  return 0;
}
