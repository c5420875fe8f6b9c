#include "kinematics/nearest_in_cell.hpp"

#include <algorithm>
#include <nlopt.hpp>
#include <stdexcept>
#include <vector>

#include "kinematics/nearest_posture.hpp"

namespace wristwise {
namespace {

constexpr double kTolerance = 1e-8;  // m and rad, of the constraints
constexpr double kEnough = 1e-6;     // m and rad, of what is worth polishing
constexpr double kStep = 1e-6;       // rad or m, at which it ends
constexpr int kMostEvaluations = 100;

double objective(const std::vector<double>& q, std::vector<double>& gradient, void* programme) {
  const auto& problem = *static_cast<const NearestPosture*>(programme);
  const JointVector posture =
      Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  if (!gradient.empty()) {
    const JointVector slope = problem.objective_gradient(posture);
    std::copy(slope.begin(), slope.end(), gradient.begin());
  }
  return problem.objective(posture);
}

using Constraint = void (NearestPosture::*)(const JointVector&, Eigen::Ref<Eigen::VectorXd>,
                                            NearestPosture::Rows&) const;

template <Constraint constraint>
void evaluate(unsigned count, double* values, unsigned joints, const double* q, double* gradient,
              void* programme) {
  const auto& problem = *static_cast<const NearestPosture*>(programme);
  NearestPosture::Rows jacobian;
  (problem.*constraint)(Eigen::Map<const Eigen::VectorXd>(q, joints),
                        Eigen::Map<Eigen::VectorXd>(values, count), jacobian);
  if (gradient != nullptr) std::copy_n(jacobian.data(), count * joints, gradient);
}

std::vector<double> list(const JointVector& values) { return {values.begin(), values.end()}; }

}  // namespace

bool move_to_nearest_in_cell(const Robot& robot, const DeviationCell& cell,
                             const JointVector& lower, const JointVector& upper, JointVector& q) {
  q = q.cwiseMax(lower).cwiseMin(upper);
  NearestPosture problem(robot, cell, q);
  const auto equalities = static_cast<std::size_t>(problem.equality_count());
  const auto inequalities = static_cast<std::size_t>(problem.inequality_count());
  nlopt::opt solver(nlopt::LD_SLSQP, static_cast<unsigned>(q.size()));
  solver.set_lower_bounds(list(lower));
  solver.set_upper_bounds(list(upper));
  solver.set_min_objective(objective, &problem);
  if (equalities > 0) {
    solver.add_equality_mconstraint(evaluate<&NearestPosture::equalities>, &problem,
                                    std::vector<double>(equalities, kTolerance));
  }
  if (inequalities > 0) {
    solver.add_inequality_mconstraint(evaluate<&NearestPosture::inequalities>, &problem,
                                      std::vector<double>(inequalities, kTolerance));
  }
  solver.set_xtol_abs(kStep);
  solver.set_maxeval(kMostEvaluations);
  std::vector<double> x = list(q);
  double value = 0;
  try {
    solver.optimize(x, value);
  } catch (const std::runtime_error&) {
    // Round-off ends it at a solution as well as elsewhere: what counts is where it is.
  }
  q = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  return q.allFinite() &&
         cell.outside(cell.measure(tcp_pose(robot, q))).cwiseAbs().maxCoeff() < kEnough;
}

}  // namespace wristwise
