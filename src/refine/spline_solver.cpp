#include "refine/spline_solver.hpp"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include "cancelled.hpp"
#include "refine/control_point_costs.hpp"

namespace wristwise {

namespace {

class StopWhenCancelled final : public ceres::IterationCallback {
 public:
  explicit StopWhenCancelled(const Monitor& monitor) : monitor_(monitor) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return monitor_.cancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Monitor& monitor_;
};

std::vector<double*> blocks_from(Spline& spline, int first, int count) {
  std::vector<double*> blocks;
  for (int k = 0; k < count; ++k) blocks.push_back(spline.control.col(first + k).data());
  return blocks;
}

void add_residuals(const AugmentedProblem& augmented, Spline& spline, ceres::Problem& problem) {
  constexpr int kLocal = SplineBasis::kLocal;
  for (std::size_t span = 0; span < augmented.span_factors.size(); ++span) {
    problem.AddResidualBlock(span_cost(augmented.span_factors[span], augmented.joint_weight),
                             nullptr, blocks_from(spline, static_cast<int>(span), kLocal));
  }
  for (const EulerPoint& point : augmented.euler_points) {
    problem.AddResidualBlock(euler_cost(augmented.robot, point), nullptr,
                             blocks_from(spline, point.basis.first, kLocal));
  }
  for (const PointConstraint& point : augmented.points) {
    if (point.rows.empty()) continue;
    problem.AddResidualBlock(point_cost(augmented.robot, augmented.checker, point, augmented.mu),
                             nullptr, blocks_from(spline, point.basis.first, kLocal));
  }
  for (const LimitConstraint& limit : augmented.limits) {
    const double mu = limit.derivative == 0 ? augmented.mu : augmented.rate_mu;
    if (mu == 0) continue;
    problem.AddResidualBlock(
        limit_cost(limit, augmented.robot.joint_count(), mu), nullptr,
        blocks_from(spline, limit.first, static_cast<int>(limit.weights.size())));
  }
}

}  // namespace

InnerSummary minimise(const AugmentedProblem& augmented, Spline& spline, int max_iterations,
                      double function_tolerance, const Monitor& monitor) {
  ceres::Problem problem;
  add_residuals(augmented, spline, problem);
  StopWhenCancelled stop(monitor);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = function_tolerance;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  // Rows of rates are stiff (a derivative of order k weighs a control point by 1 / span^k) and
  // switch on and off: strictly falling steps stall among them.
  options.use_nonmonotonic_steps = augmented.rate_mu > 0;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  throw_if_cancelled(monitor);
  InnerSummary inner;
  inner.iterations = static_cast<int>(summary.iterations.size());
  inner.evaluations = summary.num_residual_evaluations;
  inner.converged = summary.termination_type == ceres::CONVERGENCE;
  inner.message = summary.message;
  return inner;
}

}  // namespace wristwise
