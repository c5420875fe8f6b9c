#include "planner_run.hpp"

#include <chrono>
#include <thread>
#include <utility>

#include "wristwise/error.hpp"

namespace wristwise::python {

namespace {

constexpr std::chrono::milliseconds kSignalPeriod{20};

/// An inverse kinematics that stops the run where it throws, or gives what is no posture.
class GuardedInverseKinematics final : public InverseKinematics {
 public:
  GuardedInverseKinematics(PlannerRun& run, std::shared_ptr<const InverseKinematics> solver,
                           int joints)
      : run_(run), solver_(std::move(solver)), joints_(joints) {}

  void solve(const Pose& tcp, std::vector<JointVector>& branches) const override {
    fill(branches, "solve", [&] { solver_->solve(tcp, branches); });
  }
  void solve_beside(const Pose& tcp, const JointVector& posture,
                    std::vector<JointVector>& branches) const override {
    fill(branches, "solve_beside", [&] { solver_->solve_beside(tcp, posture, branches); });
  }
  void solve_near(const ToleranceSample& sample,
                  std::vector<JointVector>& branches) const override {
    fill(branches, "solve_near", [&] { solver_->solve_near(sample, branches); });
  }
  std::size_t samples() const override {
    return run_.guard(std::size_t{1}, [&] { return solver_->samples(); });
  }
  bool meets_every_pose() const override {
    return run_.guard(true, [&] { return solver_->meets_every_pose(); });
  }
  std::string description() const override {
    return run_.guard(std::string(), [&] { return solver_->description(); });
  }

 private:
  template <class Solve>
  void fill(std::vector<JointVector>& branches, const char* method, const Solve& solve) const {
    const bool usable = run_.guard(false, [&] {
      solve();
      for (const JointVector& branch : branches) expect_posture(branch, method);
      return true;
    });
    if (!usable) branches.clear();
  }

  void expect_posture(const JointVector& branch, const char* method) const {
    if (branch.size() == joints_ && branch.allFinite()) return;
    throw InvalidInput(std::string("InverseKinematics.") + method,
                       branch.size() == joints_
                           ? "returned a value that is not finite"
                           : "returned rows of " + std::to_string(branch.size()) + " values",
                       std::to_string(joints_) + " finite joint values in each row");
  }

  PlannerRun& run_;
  const std::shared_ptr<const InverseKinematics> solver_;
  const int joints_;
};

}  // namespace

PlanOptions PlannerRun::options() {
  PlanOptions options;
  options.threads = given_.threads;
  options.verification = given_.verification;
  options.monitor.cancel = &stop_;
  const PythonMonitor& monitor = given_.monitor;
  if (!monitor.progress.callable.is_none())
    options.monitor.progress = [this, &monitor](const std::string& stage, double fraction) {
      in_calling_thread([&] { monitor.progress.callable(stage, fraction); });
    };
  if (!monitor.log.callable.is_none())
    options.monitor.log = [this, &monitor](LogLevel level, const std::string& line) {
      in_calling_thread([&] { monitor.log.callable(level, line); });
    };
  return options;
}

Problem PlannerRun::guarded(const Problem& problem) {
  Problem copy = problem;
  if (problem.cost.vertex_cost)
    copy.cost.vertex_cost = [this, own = problem.cost.vertex_cost](std::size_t waypoint,
                                                                   const JointVector& q) {
      return guard(0.0, [&] { return own(waypoint, q); });
    };
  if (problem.cost.edge_cost)
    copy.cost.edge_cost = [this, own = problem.cost.edge_cost](std::size_t interval,
                                                               const JointVector& from,
                                                               const JointVector& to) {
      return guard(0.0, [&] { return own(interval, from, to); });
    };
  for (PostureResidual& residual : copy.cost.posture_residuals)
    residual = [this, own = residual](double time, const JointVector& q, JointVector* gradient) {
      if (gradient != nullptr) *gradient = JointVector::Zero(q.size());
      return guard(0.0, [&] { return own(time, q, gradient); });
    };
  if (problem.inverse_kinematics)
    copy.inverse_kinematics = std::make_shared<GuardedInverseKinematics>(
        *this, problem.inverse_kinematics, problem.robot ? problem.robot->joint_count() : 0);
  return copy;
}

void PlannerRun::run(const std::function<void()>& work) {
  look_for_signals();
  std::thread worker([&] {
    work_unlocked(work);
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
    changed_.notify_all();
  });
  while (serve()) look_for_signals();
  worker.join();
  if (failure_) std::rethrow_exception(failure_);
}

void PlannerRun::work_unlocked(const std::function<void()>& work) {
  // Python's state of this thread is made once, and not for each callback.
  const py::gil_scoped_acquire state;
  const py::gil_scoped_release unlocked;
  try {
    work();
  } catch (...) {
    fail(std::current_exception());
  }
}

bool PlannerRun::serve() {
  const std::function<void()>* request = nullptr;
  {
    const py::gil_scoped_release unlocked;
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, kSignalPeriod, [this] { return done_ || request_ != nullptr; });
    if (done_) return false;
    request = request_;
  }
  if (request == nullptr) return true;
  guard(false, [&] {
    (*request)();
    return true;
  });
  const std::lock_guard<std::mutex> lock(mutex_);
  request_ = nullptr;
  changed_.notify_all();
  return true;
}

void PlannerRun::in_calling_thread(const std::function<void()>& callback) {
  std::unique_lock<std::mutex> lock(mutex_);
  request_ = &callback;
  changed_.notify_all();
  changed_.wait(lock, [this] { return request_ == nullptr; });
}

void PlannerRun::look_for_signals() {
  guard(false, [&] {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const py::object& cancel = given_.monitor.cancel.event;
    if (!cancel.is_none() && py::bool_(cancel.attr("is_set")())) stop_ = true;
    return true;
  });
}

void PlannerRun::fail(std::exception_ptr failure) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!failure_) failure_ = std::move(failure);
  stop_ = true;
}

}  // namespace wristwise::python
