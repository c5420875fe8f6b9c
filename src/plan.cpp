#include "wristwise/plan.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "cancelled.hpp"
#include "graph/graph_planner.hpp"
#include "parallel.hpp"
#include "problem_check.hpp"
#include "refine/seed_refinement.hpp"
#include "refine/spare_seeds.hpp"
#include "smoothing/whole_turns.hpp"
#include "stopwatch.hpp"
#include "timing/slowed_stretches.hpp"
#include "timing/speed_diagnosis.hpp"
#include "timing/weld_speed.hpp"
#include "verify/pace_check.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr const char* kStoppedEarly =
    "stage 2 was stopped before its end; this is its best trajectory until then";

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
    check_problem(problem);
    result_.mode = mode;
    verification_ = verification_options(problem, options);
  }

  PlanResult plan() {
    return run([this] {
      prepare();
      if (!find_seeds(problem_.task)) return;
      if (result_.mode == Mode::graph_only) return verify_result(problem_.task);
      Refined refined = refine_best_seed(problem_.task);
      std::vector<JointPath> seeds;
      for (const Seed& seed : result_.seeds) seeds.push_back(seed.path);
      conclude(problem_.task, std::move(refined), seeds,
               [](const Problem& slower, double, const PlanOptions& quiet) {
                 return wristwise::plan(slower, quiet);
               });
      keep_seed_if_better(problem_.task);
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
      const JointPath given = result_.path;
      conclude(task, refine_path(task, given), {given},
               [&](const Problem& slower, double factor, const PlanOptions& quiet) {
                 JointPath slow = given;
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
    append(problem_.scene.warnings, result_.warnings);
  }

  /// Stage 1. Without a path to the end, the best partial one and a diagnosis.
  bool find_seeds(const Task& task) {
    GraphPlan plan = search(task, problem_.graph);
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
  GraphPlan search(const Task& task, const GraphOptions& graph) {
    find_solver();
    const SamplingInput input{*problem_.robot, *ik_, clearance_, problem_.cost, graph};
    const Speed speed = result_.mode == Mode::graph_only ? Speed::hold : Speed::any;
    return plan_graph(input, task, verification_.clearance_epsilon, threads_, options_.monitor,
                      result_.timing, speed);
  }

  void find_solver() {
    if (ik_) return;
    ik_ = problem_.inverse_kinematics;
    if (!ik_) {
      const InverseKinematicsFound found =
          find_redundant_inverse_kinematics(problem_.robot, problem_.graph.redundancy);
      if (!found.solver)
        throw InvalidInput("graph.samples", found.description, "fewer joints to sample");
      ik_ = found.solver;
    }
    result_.inverse_kinematics = ik_->description();
  }

  /// Stage 2; where none of the seeds can be refined it tries more of them.
  Refined refine_best_seed(const Task& task) {
    Refined best = refine_seeds(task, result_.seeds);
    if (best.feasible || best.stopped || !may_try_spare_seeds(problem_.graph, result_.graph))
      return best;
    return try_spare_seeds(
        std::move(best), result_.seeds, [&] { return more_seeds(task); },
        [&](std::vector<Seed>& spare) { return refine_seeds(task, spare); });
  }

  std::vector<Seed> more_seeds(const Task& task) {
    GraphOptions graph = problem_.graph;
    graph.seeds += graph.spare_seeds;
    return search(task, graph).seeds;
  }

  Refined refine_seeds(const Task& task, std::vector<Seed>& seeds) {
    const Stopwatch watch(result_.timing.refine);
    return wristwise::refine_seeds(refinement_input(task), seeds, threads_);
  }

  Refined refine_path(const Task& task, const JointPath& path) {
    const Stopwatch watch(result_.timing.refine);
    return refine(refinement_input(task), path);
  }

  /// Keeps and checks what stage 2 made of the seeds, at another speed where that is in the way.
  void conclude(const Task& task, Refined refined, const std::vector<JointPath>& seeds,
                const SlowerTrial& trial) {
    std::optional<SpeedRefined> other;
    if (!refined.feasible && !refined.stopped) other = refine_at_other_speed(task, seeds);
    keep(other ? std::move(other->refined) : std::move(refined));
    if (other) note_speed(*other);
    verify_result(other ? other->task : task);
    if (!other || !other->too_fast || !fails_by_rates_only(result_.verification)) return;
    const Stopwatch watch(result_.timing.refine);
    result_.status = Status::infeasible;
    result_.diagnosis.insert(result_.diagnosis.begin(),
                             diagnose_speed(problem_, task, *other->too_fast, options_, trial));
  }

  std::optional<SpeedRefined> refine_at_other_speed(const Task& task,
                                                    const std::vector<JointPath>& seeds) {
    const Stopwatch watch(result_.timing.refine);
    const auto passes = [this](const Task& timed, const Trajectory& motion) {
      return verify(timed, clearance_, motion, verification_).passed;
    };
    for (const JointPath& seed : seeds) {
      auto other = wristwise::refine_at_other_speed(refinement_input(task), seed, passes);
      if (other) return other;
    }
    return std::nullopt;
  }

  void note_speed(const SpeedRefined& other) {
    if (other.law.empty()) return;
    result_.seam_time = other.task.seam.seam_time();
    result_.slowed = slowed_stretches(other.law, result_.trajectory, rate_limits(*problem_.robot));
  }

  RefinementInput refinement_input(const Task& task) const {
    return {*problem_.robot, task, clearance_, problem_.cost, problem_.refine, options_.monitor};
  }

  void keep(Refined refined) {
    result_.trajectory = std::move(refined.trajectory);
    result_.path = result_.trajectory.waypoints();
    result_.refine = std::move(refined.statistics);
    if (refined.feasible) {
      if (refined.stopped) result_.warnings.push_back(kStoppedEarly);
      return;
    }
    result_.diagnosis.push_back(
        {std::nullopt, "refinement",
         "stage 2 ended without meeting every constraint: " + result_.refine.termination,
         "look at the verification for what is not met; widen that tolerance, weld slower, or "
         "start from another path"});
  }

  void check_given_path(const Task& task) {
    const Stopwatch watch(result_.timing.verify);
    result_.before = {result_.path, verify(task, clearance_, result_.path, verification_)};
  }

  void verify_result(const Task& task) {
    const Stopwatch watch(result_.timing.verify);
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
    throw_if_cancelled(options_.monitor);
  }

  /// Where the trajectory of stage 2 does not pass and the path of stage 1 does, as points, the
  /// path is what is returned. It is not what was asked for: the result stays failed.
  void keep_seed_if_better(const Task& task) {
    if (result_.status != Status::failed) return;
    const JointPath& seed = result_.seeds.front().path;
    const Verification of_seed = verify(task, clearance_, seed, verification_);
    if (!of_seed.passed) return;
    result_.path = seed;
    result_.trajectory = {};
    result_.verification = of_seed;
    result_.diagnosis.push_back({std::nullopt, "seed",
                                 "the path of stage 1 is returned: it passes the check as a list "
                                 "of points, the trajectory of stage 2 does not pass",
                                 "use it with --mode graph-only if that is enough"});
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
  std::shared_ptr<const InverseKinematics> ik_;
  PlanResult result_;
};

template <class Motion>
Verification check_along(const Problem& problem, const Task& task, const Motion& motion,
                         const PlanOptions& options) {
  check_task(problem);
  return verify(task, std::make_shared<const ClearanceModel>(problem.robot, problem.scene), motion,
                verification_options(problem, options));
}

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
  return check_along(problem, problem.task, path, options);
}

Verification check(const Problem& problem, const Trajectory& trajectory,
                   const PlanOptions& options) {
  return check_along(problem, problem.task, trajectory, options);
}

Verification check(const Problem& problem, const TrajectoryFile& file, const PlanOptions& options) {
  check_task(problem);
  Task task = problem.task;
  if (file.seam_time) {
    Verification unusable;
    unusable.failures = law_failures(problem.task, *file.seam_time);
    unusable.run = true;
    if (!unusable.failures.empty()) return unusable;
    task = problem.task.retimed(*file.seam_time);
  }
  Verification result = file.trajectory ? check_along(problem, task, *file.trajectory, options)
                                        : check_along(problem, task, file.path, options);
  if (file.seam_time) {
    for (const std::string& line : pace_failures(problem.task, task))
      result.failures.push_back(line);
  }
  result.passed = result.failures.empty();
  return result;
}

}  // namespace wristwise
