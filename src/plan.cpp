#include "wristwise/plan.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "cancelled.hpp"
#include "graph/diagnosis.hpp"
#include "graph/ladder_graph.hpp"
#include "graph/move_checker.hpp"
#include "graph/path_sampling.hpp"
#include "parallel.hpp"
#include "refine/refinement.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

/// Adds the time between its construction and destruction to a counter.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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
      if (result_.mode == Mode::two_stage) refine_seed(problem_.task);
      verify_result(problem_.task);
    });
  }

  PlanResult smooth(const JointPath& path) {
    validate(path, problem_.robot->joint_count(), "joint path");
    return run([&] {
      prepare();
      const Task task = problem_.task.with_waypoints_at(path.times);
      result_.path = path;
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
    SampledPath sampled = sample(task);
    auto diagnosis = diagnose_samples(*problem_.robot, task, sampled);
    std::vector<Rung> rungs = rungs_to_search(sampled);
    if (!rungs.empty()) {
      const EdgeRules rules = edge_rules(task);
      const LadderPath path = search(rungs, rules);
      record_path(task, rungs, path);
      if (!path.found) {
        sampled.rungs = std::move(rungs);
        diagnosis = diagnose_moves(task, sampled, rules, path, *moves_, clearance_,
                                   verification_.clearance_epsilon);
      }
    }
    if (!diagnosis) return true;
    result_.status = Status::infeasible;
    result_.diagnosis.push_back(*diagnosis);
    return false;
  }

  SampledPath sample(const Task& task) {
    const Stopwatch watch(result_.timing.sampling);
    const InverseKinematicsFound found = find_inverse_kinematics(problem_.robot);
    result_.inverse_kinematics = found.description;
    if (!found.solver) {
      throw InvalidInput("robot " + problem_.robot->name(),
                         "no inverse kinematics: " + found.description,
                         "a six-axis arm with a spherical wrist");
    }
    SampledPath sampled = sample_path(*problem_.robot, task, *found.solver, clearance_,
                                      problem_.cost, problem_.graph, threads_, options_.monitor);
    result_.graph.collision_checks = sampled.collision_checks;
    for (const Rung& rung : sampled.rungs) {
      result_.graph.vertices += static_cast<std::size_t>(rung.size());
    }
    return sampled;
  }

  /// Those before the first rung without a vertex.
  static std::vector<Rung> rungs_to_search(SampledPath& sampled) {
    const auto empty = std::find_if(sampled.rungs.begin(), sampled.rungs.end(),
                                    [](const Rung& rung) { return rung.size() == 0; });
    return {std::make_move_iterator(sampled.rungs.begin()), std::make_move_iterator(empty)};
  }

  EdgeRules edge_rules(const Task& task) {
    EdgeRules rules;
    rules.weight = JointVector::Constant(problem_.robot->joint_count(), problem_.cost.joint_motion);
    for (std::size_t j = 0; j < problem_.cost.joint_weights.size(); ++j) {
      rules.weight[static_cast<Eigen::Index>(j)] *= problem_.cost.joint_weights[j];
    }
    for (std::size_t i = 0; i + 1 < task.waypoints.size(); ++i) {
      rules.max_step.push_back((task.waypoints[i + 1].time - task.waypoints[i].time) *
                               problem_.robot->velocity_limits());
    }
    moves_ = std::make_unique<MoveChecker>(task, clearance_, problem_.graph.max_stray,
                                           verification_.clearance_epsilon, threads_);
    rules.is_clear = [this](int worker, std::size_t interval, const JointVector& from,
                            const JointVector& to) {
      return moves_->is_clear(worker, interval, from, to);
    };
    return rules;
  }

  LadderPath search(const std::vector<Rung>& rungs, const EdgeRules& rules) {
    const Stopwatch watch(result_.timing.search);
    LadderPath path = find_least_cost_path(rungs, rules, threads_, options_.monitor);
    result_.graph.collision_checks += moves_->queries();
    return path;
  }

  void record_path(const Task& task, const std::vector<Rung>& rungs, const LadderPath& path) {
    result_.graph.edges = path.edges;
    result_.graph.edges_evaluated = path.edges_evaluated;
    result_.graph.edges_checked = path.edges_checked;
    result_.graph.cost = path.cost;
    for (std::size_t i = 0; i < path.vertices.size(); ++i) {
      result_.path.times.push_back(task.waypoints[i].time);
      result_.path.positions.push_back(rungs[i].vertex(path.vertices[i]));
      if (i == 0) continue;
      result_.graph.joint_motion_l1 +=
          (result_.path.positions[i] - result_.path.positions[i - 1]).lpNorm<1>();
    }
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
  std::unique_ptr<MoveChecker> moves_;
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
