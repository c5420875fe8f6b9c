#include "wristwise/plan.hpp"

#include <functional>
#include <memory>
#include <utility>

#include "cancelled.hpp"
#include "graph/graph_planner.hpp"
#include "parallel.hpp"
#include "stopwatch.hpp"
#include "timing/highest_speed.hpp"
#include "timing/retiming.hpp"
#include "timing/slowed_stretches.hpp"
#include "timing/speed_diagnosis.hpp"
#include "timing/weld_speed.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kAnySpeed = 1e4;  // times the time: no joint is too slow for a move

VerificationOptions verification_options(const Problem& problem, const PlanOptions& options) {
  VerificationOptions verification = options.verification;
  verification.clearance_epsilon = problem.refine.clearance_epsilon;
  return verification;
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
      if (result_.mode == Mode::graph_only) return verify_result(problem_.task);
      refine_and_verify(problem_.task, [](const Problem& slower, double, const PlanOptions& quiet) {
        return wristwise::plan(slower, quiet);
      });
    });
  }

  PlanResult smooth(const JointPath& path) {
    validate(path, problem_.robot->joint_count(), "joint path");
    return run([&] {
      prepare();
      const Task task = problem_.task.with_waypoints_at(path.times);
      result_.path = path;
      refine_and_verify(task, [&](const Problem& slower, double factor, const PlanOptions& quiet) {
        JointPath slow = path;
        const double start = problem_.task.seam.start_time();
        for (double& t : slow.times) t = start + factor * (t - start);
        return wristwise::smooth(slower, slow, quiet);
      });
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
    GraphPlan plan = find_paths(input, task);
    result_.graph = std::move(plan.statistics);
    result_.seeds = std::move(plan.seeds);
    if (!result_.seeds.empty()) result_.path = result_.seeds.front().path;
    if (plan.found) return true;
    result_.status = Status::infeasible;
    if (plan.diagnosis) result_.diagnosis.push_back(*plan.diagnosis);
    return false;
  }

  /// Where moves are too fast at weld speed, stage 2 starts from a path at any speed: it says which
  /// speed works, or slows down.
  GraphPlan find_paths(const SamplingInput& input, const Task& task) {
    const auto find = [&](const Task& timed, Help help) {
      return plan_graph(input, timed, verification_.clearance_epsilon, threads_, options_.monitor,
                        result_.timing, help);
    };
    if (result_.mode == Mode::graph_only) return find(task, Help::always);
    GraphPlan plan = find(task, Help::unless_speeds);
    if (plan.found || !is_too_fast(plan)) return plan;
    plan = find(stretched(task, kAnySpeed), Help::unless_speeds);
    if (!plan.found) return find(task, Help::always);
    for (Seed& seed : plan.seeds) seed.path = at_waypoints_of(task, std::move(seed.path));
    return plan;
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

  /// The same problem at a slower uniform speed, `factor` times the time.
  using Trial = std::function<PlanResult(const Problem& slower, double factor, const PlanOptions&)>;

  void refine_and_verify(const Task& task, const Trial& trial) {
    const SpeedRefined refined = refine_seed(task);
    verify_result(refined.task);
    if (refined.too_fast && fails_by_rates_only(result_.verification)) {
      explain_speed(refined.task, *refined.too_fast, trial);
    }
  }

  /// Stage 2.
  SpeedRefined refine_seed(const Task& task) {
    const Stopwatch watch(result_.timing.refine);
    const RefinementInput input{*problem_.robot, task, clearance_, problem_.cost, problem_.refine,
                                options_.monitor};
    SpeedRefined refined = refine_at_weld_speed(
        input, result_.path, [this](const Task& timed, const Trajectory& motion) {
          return verify(timed, clearance_, motion, verification_).passed;
        });
    result_.trajectory = std::move(refined.refined.trajectory);
    result_.path = result_.trajectory.waypoints();
    result_.refine = std::move(refined.refined.statistics);
    result_.seam_time = refined.task.seam.seam_time();
    if (!refined.law.empty()) {
      result_.slowed =
          slowed_stretches(refined.law, result_.trajectory, rate_limits(*problem_.robot));
    }
    if (!refined.refined.feasible) {
      result_.diagnosis.push_back(
          {std::nullopt, "refinement",
           "stage 2 ended without meeting every constraint: " + result_.refine.termination,
           "look at the verification for what is not met; widen that tolerance, weld slower, or "
           "start from another path"});
    }
    return refined;
  }

  /// Nothing but the speed is in the way: where, and which speed would do.
  void explain_speed(const Task& task, const UniformSlowdown& too_fast, const Trial& trial) {
    result_.status = Status::infeasible;
    Diagnosis diagnosis = diagnose_speed(*problem_.robot, task, too_fast);
    if (problem_.refine.try_speeds) {
      const Stopwatch watch(result_.timing.refine);
      const auto works = [&](double factor) { return is_solved(trial, factor); };
      diagnosis.suggestion =
          suggest_speed(task, too_fast, least_working_factor(works, too_fast.factor));
    }
    result_.diagnosis.insert(result_.diagnosis.begin(), std::move(diagnosis));
  }

  bool is_solved(const Trial& trial, double factor) const {
    Problem slower = problem_;
    slower.task = stretched(problem_.task, factor);
    slower.task.speed_policy = SpeedPolicy::hold;
    slower.refine.try_speeds = slower.graph.try_relaxations = false;
    PlanOptions quiet = options_;
    quiet.monitor = {nullptr, nullptr, options_.monitor.cancel};
    const PlanResult result = trial(slower, factor, quiet);
    throw_if_cancelled(options_.monitor);
    return result.status == Status::solved;
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
