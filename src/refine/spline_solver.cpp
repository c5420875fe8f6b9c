#include "refine/spline_solver.hpp"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <memory>

#include "refine/batch_cost.hpp"
#include "refine/control_point_costs.hpp"

namespace wristwise {

namespace {

constexpr int kLocal = SplineBasis::kLocal;
// Rows that press in one direction only make large steps fail, the more the stiffer they are.
constexpr double kTrustRegion = 1e8, kTrustRegionOfRates = 1e6;
constexpr int kAtRest = 3;  ///< control points that are one where velocity and acceleration vanish

class StopOnRequest final : public ceres::IterationCallback {
 public:
  explicit StopOnRequest(const Stop& stop) : stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return stop_.requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Stop& stop_;
};

/// The residuals, a batch for each span.
class Batches {
 public:
  explicit Batches(const AugmentedProblem& problem, int spans) : problem_(problem) {
    for (int span = 0; span < spans; ++span) {
      batches_.push_back(std::make_unique<BatchCost>(problem.robot.joint_count()));
    }
    for (const ObjectiveRow& row : problem.objective_rows) {
      add(objective_cost(row, problem.weights), row.first);
    }
    for (const DeviationPoint& point : problem.deviation_points) {
      add(deviation_cost(problem.robot, point), point.basis.first);
    }
    for (const PosturePoint& point : problem.singularity_points) {
      add(singularity_cost(problem.robot, point), point.basis.first);
    }
    for (const PosturePoint& point : problem.own_points) {
      add(own_cost(problem.weights, point), point.basis.first);
    }
    for (const PointConstraint& point : problem.points) {
      if (point.rows.empty()) continue;
      add(point_cost(problem.robot, problem.checker, point, problem.mu), point.basis.first);
    }
    for (const LimitConstraint& limit : problem.limits) {
      const double mu = limit.derivative == 0 ? problem.mu : problem.rate_mu;
      if (mu > 0) add(limit_cost(limit, problem.robot.joint_count(), mu), limit.first);
    }
  }

  void hand_over(Spline& spline, ceres::Problem& problem) {
    for (std::size_t span = 0; span < batches_.size(); ++span) {
      std::array<int, kLocal> slots{};
      const std::vector<double*> blocks = blocks_of(spline, static_cast<int>(span), slots);
      batches_[span]->merge(slots);
      problem.AddResidualBlock(batches_[span].release(), nullptr, blocks);
    }
  }

  /// The control point that stands for control point k.
  int representative(int k, int count) const {
    if (problem_.rest_at_start && k < kAtRest) return 0;
    if (problem_.rest_at_end && k >= count - kAtRest) return count - 1;
    return k;
  }

 private:
  void add(ceres::CostFunction* cost, int first_control) {
    const int span = std::min(first_control, static_cast<int>(batches_.size()) - 1);
    batches_[static_cast<std::size_t>(span)]->add(cost, first_control - span);
  }

  std::vector<double*> blocks_of(Spline& spline, int span, std::array<int, kLocal>& slots) const {
    std::vector<double*> blocks;
    for (int k = 0; k < kLocal; ++k) {
      double* block =
          spline.control.col(representative(span + k, spline.basis.control_count())).data();
      if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
      slots[static_cast<std::size_t>(k)] = static_cast<int>(blocks.size()) - 1;
    }
    return blocks;
  }

  const AugmentedProblem& problem_;
  std::vector<std::unique_ptr<BatchCost>> batches_;
};

}  // namespace

InnerSummary minimise(const AugmentedProblem& augmented, Spline& spline, const InnerOptions& inner,
                      const Stop& stop) {
  const int count = spline.basis.control_count();
  ceres::Problem problem;
  Batches batches(augmented, spline.basis.span_count());
  batches.hand_over(spline, problem);
  StopOnRequest stop_on_request(stop);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = inner.max_iterations;
  options.function_tolerance = inner.function_tolerance;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  const double largest = augmented.rate_mu > 0 ? kTrustRegionOfRates : kTrustRegion;
  options.initial_trust_region_radius =
      inner.trust_region > 0 ? std::min(inner.trust_region, largest) : largest;
  // Rows of rates are stiff (a derivative of order k weighs a control point by 1 / span^k) and
  // switch on and off: strictly falling steps stall among them.
  options.use_nonmonotonic_steps = augmented.rate_mu > 0;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.callbacks.push_back(&stop_on_request);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (int k = 0; k < count; ++k) {
    spline.control.col(k) = spline.control.col(batches.representative(k, count)).eval();
  }
  return {static_cast<int>(summary.iterations.size()), summary.num_residual_evaluations,
          summary.termination_type == ceres::CONVERGENCE,
          summary.iterations.back().trust_region_radius};
}

}  // namespace wristwise
