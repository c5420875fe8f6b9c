#include "placement/placement_measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cancelled.hpp"
#include "collision/clearance_search.hpp"
#include "placement/placed_problem.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

// (F81) max |q'_j| / limit_j + w_s (1 - m / m_0)^+ + w_c (1 - (d - d_safe) / d_0)^+
// (F82) kInfeasible and what is missing, in four steps: the check of the refined trajectory below
// 1, waypoints that stage 1 can't pass below 2, a seam out of reach below 3, things that would
// stand in each other below 4.

namespace {

constexpr double kInfeasible = 1000;  // more than any placement that can be used
constexpr int kSamples = 8;           // of the distance from singularity, in a piece of the curve
constexpr double kResolution = 1e-5;  // m, of the least clearance
constexpr double kDegree = 0.017453292519943295;

/// Grows from 0 towards 1.
double squashed(double x) { return x / (1 + x); }

/// m; no point of the tool is farther from the first joint.
double reach(const Robot& robot) {
  double sum = robot.tcp().translation().norm();
  for (std::size_t j = 0; j < robot.joints().size(); ++j) {
    const Joint& joint = robot.joints()[j];
    if (j > 0) sum += joint.origin.translation().norm();
    if (joint.type == JointType::prismatic)
      sum += std::max(std::abs(joint.lower), std::abs(joint.upper));
  }
  return std::max(sum, 1e-9);
}

/// By how many reaches the waypoints are too far away, on average.
double distance_out_of_reach(const Problem& problem) {
  const double limit = reach(*problem.robot);
  const Eigen::Vector3d shoulder = problem.robot->joints().front().origin.translation();
  double sum = 0;
  for (const Waypoint& waypoint : problem.task.waypoints)
    sum += std::max(0.0, (waypoint.frame.translation() - shoulder).norm() / limit - 1);
  return sum / static_cast<double>(problem.task.waypoints.size());
}

double longest_piece(const PlanResult& plan, const Problem& problem) {
  if (plan.status == Status::solved || plan.refine.run) return 1;
  std::size_t longest = 0;
  for (const auto& [first, last] : plan.graph.pieces) longest = std::max(longest, last - first + 1);
  return static_cast<double>(longest) / static_cast<double>(problem.task.waypoints.size());
}

/// What the check found beyond what it accepts: mm, degrees and shares of rate limits.
double excess(const Verification& verification, double required) {
  double sum = 0;
  for (const Vector6& box : {verification.tolerance_excess, verification.tolerance_excess_between})
    sum += box.head<3>().sum() * 1e3 + box.tail<3>().sum() / kDegree;
  for (const double ratio :
       {verification.velocity_ratio, verification.acceleration_ratio, verification.jerk_ratio})
    sum += std::max(0.0, ratio - 1);
  if (verification.clearance) sum += std::max(0.0, required - *verification.clearance) * 1e3;
  return sum;
}

/// Without the pairs whose distance the placement does not change: tool against what moves with
/// the seam.
Scene placement_dependent(const Scene& given, const Robot& robot,
                          const std::vector<std::string>& moved) {
  Scene scene = given;
  for (const Link& link : robot.links()) {
    if (link.joint + 1 != robot.joint_count()) continue;
    for (const std::string& object : moved) {
      const Scene::Names pair(link.name, object), reversed(object, link.name);
      scene.disabled.push_back(pair);
      scene.pairs.erase(std::remove_if(scene.pairs.begin(), scene.pairs.end(),
                                       [&](const auto& p) { return p == pair || p == reversed; }),
                        scene.pairs.end());
    }
  }
  return scene;
}

double least_ratio(const PlanResult& plan) {
  double least = 1;
  for (const SlowedStretch& stretch : plan.slowed) least = std::min(least, stretch.least_ratio);
  return least;
}

double share_missing(double has, double wanted) {
  return wanted > 0 ? std::max(0.0, 1 - has / wanted) : 0;
}

PlanOptions quiet(const PlanOptions& options) {
  PlanOptions own = options;
  own.threads = 1;  // several placements are measured at once
  own.monitor = {};
  own.monitor.cancel = options.monitor.cancel;
  return own;
}

}  // namespace

PlacementMeter::PlacementMeter(const PlacementRequest& request, const PlanOptions& options)
    : request_(request),
      options_(quiet(options)),
      contacts_(request),
      singularity_(*request.problem.robot, request.problem.cost.singularity_measure) {}

Problem PlacementMeter::without_help(Problem problem) {
  problem.graph.try_relaxations = false;
  problem.graph.spare_seeds = 0;
  problem.refine.try_speeds = false;
  return problem;
}

std::optional<Diagnosis> PlacementMeter::obstacle(const Offset& offset) const {
  const StandingContact contact = contacts_.at(motion_of(request_, offset));
  if (contact.depth <= 0) return std::nullopt;
  return Diagnosis{std::nullopt, "standing_contact",
                   fmt::format("{} would stand in {}", contact.pair.first, contact.pair.second),
                   "move that too, or look elsewhere"};
}

PlacementMeasure PlacementMeter::operator()(const Offset& offset) const {
  throw_if_cancelled(options_.monitor);
  const double depth = contacts_.at(motion_of(request_, offset)).depth;
  PlacementMeasure measure;
  if (depth > 0) {
    measure.obstacle = "standing_contact";
    measure.value = kInfeasible + 3 + squashed(depth);
    return measure;
  }
  try {
    const Problem problem = without_help(placed(request_, offset).problem);
    const PlanResult plan = wristwise::plan(problem, options_);
    if (plan.status == Status::interrupted) throw Cancelled{};
    return of(problem, plan);
  } catch (const InvalidInput&) {  // no seam can be laid out there
    measure.obstacle = "seam";
    measure.value = kInfeasible + 4;
    return measure;
  }
}

PlacementMeasure PlacementMeter::of(const Problem& problem, const PlanResult& plan) const {
  PlacementMeasure measure;
  measure.feasible = plan.status == Status::solved;
  measure.waypoints_share = longest_piece(plan, problem);
  if (!plan.trajectory.empty()) {
    measure.speed_ratio = plan.verification.velocity_ratio / least_ratio(plan);
    measure.singularity_distance = singularity_distance(plan.trajectory);
    measure.clearance = clearance(problem, plan.trajectory);
  }
  if (measure.feasible) {
    measure.value = std::min(value(measure), kInfeasible);
  } else {
    measure.obstacle = plan.diagnosis.empty() ? "verification" : plan.diagnosis.front().reason;
    measure.value = kInfeasible + missing(problem, plan, measure.waypoints_share);
  }
  return measure;
}

double PlacementMeter::value(const PlacementMeasure& measure) const {
  const PlacementOptions& o = request_.options;
  double sum = o.speed_weight * measure.speed_ratio;
  sum += o.singularity_weight * share_missing(measure.singularity_distance, o.singularity_margin);
  if (measure.clearance)
    sum += o.clearance_weight *
           share_missing(std::max(0.0, *measure.clearance - request_.problem.scene.clearance),
                         o.clearance_margin);
  return sum;
}

double PlacementMeter::missing(const Problem& problem, const PlanResult& plan, double share) const {
  if (share >= 1) return squashed(excess(plan.verification, problem.scene.clearance));
  if (share > 0) return 1 + (1 - share);
  return 2 + squashed(distance_out_of_reach(problem));
}

std::optional<double> PlacementMeter::clearance(const Problem& problem,
                                                const Trajectory& motion) const {
  const Scene scene = placement_dependent(problem.scene, *problem.robot, moving_objects(request_));
  const auto model = std::make_shared<const ClearanceModel>(problem.robot, scene);
  ClearanceChecker checker(model);
  ClearanceSearch search(checker, kResolution);
  ClearanceFinding found;
  for (std::size_t i = 0; i + 1 < motion.times().size(); ++i)
    search.look_along({motion.times()[i], motion.times()[i + 1], motion.polynomials(i)}, found);
  if (found.pair < 0) return std::nullopt;
  return found.least;
}

double PlacementMeter::singularity_distance(const Trajectory& motion) const {
  double least = 1;
  const std::vector<double>& times = motion.times();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    for (int k = 0; k <= kSamples; ++k) {
      const double t = times[i] + k * (times[i + 1] - times[i]) / kSamples;
      least = std::min(least, singularity_(motion.evaluate(t)));
    }
  }
  return least;
}

}  // namespace wristwise
