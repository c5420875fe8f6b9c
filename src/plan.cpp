#include "wristwise/plan.hpp"

#include <memory>
#include <utility>

#include "cancelled.hpp"
#include "graph/graph_planner.hpp"
#include "parallel.hpp"
#include "refine/refinement.hpp"
#include "smoothing/whole_turns.hpp"
#include "stopwatch.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

VerificationOptions verification_options(const Problem& problem, const PlanOptions& options) {
  VerificationOptions verification = options.verification;
  verification.clearance_epsilon = problem.refine.clearance_epsilon;
  return verification;
}

void append(const std::vector<std::string>& lines, std::vector<std::string>& to) {
  to.insert(to.end(), lines.begin(), lines.end());
}

/// The pipeline: samples -> rungs -> seed path -> refined trajectory -> verification.
class Pipeline {
 public:
  Pipeline(const Problem& problem, const PlanOptions& options, Mode mode)
      : problem_(problem), options_(options), threads_(thread_count(options.threads)) {
    result_.mode = mode;
    verification_ = verification_options(problem, options);
  }

  PlanResult plan() {
    return run([this] {
      prepare();
      if (!find_seed(problem_.task)) return;
      if (result_.mode == Mode::two_stage) refine_seed(problem_.task);
      verify_result(problem_.task);
    });
  }

  PlanResult smooth(const JointPath& path) {
    validate(path, problem_.robot->joint_count(), "joint path");
    return run([&] {
      prepare();
      Unwrapped unwrapped = without_whole_turns(*problem_.robot, path);
      append(unwrapped.warnings, result_.warnings);
      const Task task = problem_.task.with_waypoints_at(path.times);
      result_.path = std::move(unwrapped.path);
      check_given_path(task);
      refine_seed(task);
      verify_result(task);
    });
  }

 private:
  template <class Work>
  PlanResult run(const Work& work) {
    {
      const Stopwatch total(result_.timing.total);
      try {
        work();
      } catch (const Cancelled&) {
        result_.status = Status::interrupted;
        result_.diagnosis.push_back({std::nullopt, "interrupted", "stopped by the caller", ""});
      }
    }
    return std::move(result_);
  }

  void prepare() {
    validate_joint_waypoints(problem_.task, *problem_.robot);
    clearance_ = std::make_shared<const ClearanceModel>(problem_.robot, problem_.scene);
    result_.permanent_contacts = clearance_->permanent_contacts();
    result_.warnings = problem_.robot->warnings();
  }

  /// Stage 1. Without a path to the end, the best partial one and a diagnosis.
  bool find_seed(const Task& task) {
    const auto ik = inverse_kinematics();
    const SamplingInput input{*problem_.robot, *ik, clearance_, problem_.cost, problem_.graph};
    GraphPlan plan = plan_graph(input, task, verification_.clearance_epsilon, threads_,
                                options_.monitor, result_.timing);
    result_.graph = std::move(plan.statistics);
    result_.seeds = std::move(plan.seeds);
    if (!result_.seeds.empty()) result_.path = result_.seeds.front().path;
    if (plan.found) return true;
    result_.status = Status::infeasible;
    if (plan.diagnosis) result_.diagnosis.push_back(*plan.diagnosis);
    return false;
  }

  std::shared_ptr<const InverseKinematics> inverse_kinematics() {
    const InverseKinematicsFound found = find_inverse_kinematics(problem_.robot);
    result_.inverse_kinematics = found.description;
    if (!found.solver) {
      throw InvalidInput("robot " + problem_.robot->name(),
                         "no inverse kinematics: " + found.description,
                         "a six-axis arm with a spherical wrist");
    }
    return found.solver;
  }

  /// Stage 2.
  void refine_seed(const Task& task) {
    const Stopwatch watch(result_.timing.refine);
    const RefinementInput input{*problem_.robot, task, clearance_, problem_.cost, problem_.refine,
                                options_.monitor};
    Refined refined = refine(input, result_.path);
    result_.trajectory = std::move(refined.trajectory);
    result_.path = result_.trajectory.waypoints();
    result_.refine = std::move(refined.statistics);
    if (!refined.feasible) {
      result_.diagnosis.push_back(
          {std::nullopt, "refinement",
           "stage 2 ended without meeting every constraint: " + result_.refine.termination,
           "look at the verification for what is not met; widen that tolerance, weld slower, or "
           "start from another path"});
    }
  }

  void check_given_path(const Task& task) {
    const Stopwatch watch(result_.timing.verify);
    result_.before = {result_.path, verify(task, clearance_, result_.path, verification_)};
  }

  void verify_result(const Task& task) {
    const Stopwatch watch(result_.timing.verify);
    throw_if_cancelled(options_.monitor);
    options_.monitor.report("verify", 0);
    result_.verification = result_.trajectory.empty()
                               ? verify(task, clearance_, result_.path, verification_)
                               : verify(task, clearance_, result_.trajectory, verification_);
    options_.monitor.report("verify", 1);
    result_.status = result_.verification.passed ? Status::solved : Status::failed;
    if (result_.verification.passed) turn_diagnosis_into_warnings();
    for (const std::string& line : result_.verification.failures) {
      result_.diagnosis.push_back({std::nullopt, "verification", line, ""});
    }
  }

  /// What stage 2 thought of its own end does not count against a check that passed.
  void turn_diagnosis_into_warnings() {
    for (const Diagnosis& diagnosis : result_.diagnosis) {
      result_.warnings.push_back(diagnosis.detail);
    }
    result_.diagnosis.clear();
  }

  const Problem& problem_;
  const PlanOptions& options_;
  const int threads_;
  VerificationOptions verification_;
  std::shared_ptr<const ClearanceModel> clearance_;
  PlanResult result_;
};

}  // namespace

PlanResult plan(const Problem& problem, const PlanOptions& options) {
  return Pipeline(problem, options, Mode::two_stage).plan();
}

PlanResult plan_graph_only(const Problem& problem, const PlanOptions& options) {
  return Pipeline(problem, options, Mode::graph_only).plan();
}

PlanResult smooth(const Problem& problem, const JointPath& path, const PlanOptions& options) {
  return Pipeline(problem, options, Mode::smooth).smooth(path);
}

Verification check(const Problem& problem, const JointPath& path, const PlanOptions& options) {
  return verify(problem.task, std::make_shared<const ClearanceModel>(problem.robot, problem.scene),
                path, verification_options(problem, options));
}

Verification check(const Problem& problem, const Trajectory& trajectory,
                   const PlanOptions& options) {
  return verify(problem.task, std::make_shared<const ClearanceModel>(problem.robot, problem.scene),
                trajectory, verification_options(problem, options));
}

}  // namespace wristwise
