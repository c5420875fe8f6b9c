#pragma once

// One call into the library from Python: without the interpreter lock, on a thread of its own.
// Meanwhile the calling thread serves signals (Ctrl-C) and the callbacks of the monitor.

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

#include "python_monitor.hpp"
#include "wristwise/plan.hpp"

namespace wristwise::python {

class PlannerRun {
 public:
  explicit PlannerRun(const PythonPlanOptions& options) : given_(options) {}

  /// What the library gets. Lives as long as this run.
  PlanOptions options();

  /// A copy whose costs and inverse kinematics, where they raise, stop the run.
  Problem guarded(const Problem& problem);

  /// To be called under the interpreter lock, once.
  /// Throws what a callback or a signal handler raised, and what `work` throws.
  template <class Work>
  auto operator()(const Work& work) {
    decltype(work()) result{};
    run([&] { result = work(); });
    return result;
  }

  /// The call's answer; `otherwise` where it throws, which stops the run, or it is stopped.
  template <class Answer, class Call>
  Answer guard(Answer otherwise, const Call& call) {
    if (stop_) return otherwise;
    try {
      return call();
    } catch (...) {
      fail(std::current_exception());
      return otherwise;
    }
  }

 private:
  void run(const std::function<void()>& work);
  void work_unlocked(const std::function<void()>& work);
  void fail(std::exception_ptr failure);
  /// From the worker: has the calling thread do this, and waits for it.
  void in_calling_thread(const std::function<void()>& callback);
  /// @return false when the work is done
  bool serve();
  void look_for_signals();

  PythonPlanOptions given_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* request_ = nullptr;
  bool done_ = false;
  std::exception_ptr failure_;
};

}  // namespace wristwise::python
