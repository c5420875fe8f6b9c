#include "wristwise/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cancelled.hpp"
#include "parallel.hpp"
#include "placement/placement_map.hpp"
#include "placement/placement_options.hpp"
#include "placement/placement_search.hpp"
#include "problem_check.hpp"
#include "stopwatch.hpp"

namespace wristwise {

namespace {

constexpr double kLengthStep = 1e-4;                        // m: what a part is set up to
constexpr double kAngleStep = 0.01 * 0.017453292519943295;  // rad
constexpr double kRoundingLoss = 0.01;  // of the measure, that rounding may cost

/// The pipeline: given placement -> search -> map -> the placement found, planned in full.
class PlacementPipeline {
 public:
  PlacementPipeline(const PlacementRequest& request, const PlanOptions& options)
      : request_(request),
        options_(options),
        threads_(thread_count(options.threads)),
        meter_(request, options),
        trials_(meter_, options_.monitor, request.options.time_limit) {}

  PlacementResult run() {
    {
      const Stopwatch watch(result_.seconds);
      try {
        measure_given();
        if (find_least()) conclude();
      } catch (const Cancelled&) {
        stop();
      }
    }
    return std::move(result_);
  }

 private:
  void measure_given() {
    result_.before = plans(Offset::Zero(), true);
    result_.given.measure = meter_.of(result_.before.placed.problem, result_.before.two_stage);
  }

  /// @return whether a placement was measured at all
  bool find_least() {
    PlacementSearch search = search_region(trials_, request_.options, threads_);
    count(search.counts);
    if (is_inside(request_.options, Offset::Zero()) &&
        (!search.best || result_.given.measure.value <= search.best->measure.value))
      search.best = result_.given;
    if (search.best) {
      result_.found = rounded(*search.best);
      look_at_map();
    }
    result_.out_of_time = trials_.out_of_time();
    if (search.best) return true;
    result_.status = Status::infeasible;
    result_.diagnosis.push_back({std::nullopt, "time_limit",
                                 "the time was over before a placement was measured",
                                 "a longer placement.time_limit"});
    return false;
  }

  /// Where the map has a better place than the search, that is the one.
  void look_at_map() {
    result_.map = draw_map(trials_, request_.options, result_.found.offset, threads_);
    const Placement* best = &result_.found;
    for (const Placement& sample : result_.map.samples) {
      if (sample.measure.obstacle == "not_measured") continue;
      count({{sample.measure.obstacle, 1}});
      if (sample.measure.value < best->measure.value) best = &sample;
    }
    if (best == &result_.found) return;
    const PlacementSearch search =
        search_nearby(trials_, request_.options, *best, result_.map.axes);
    count(search.counts);
    result_.found = rounded(*search.best);
  }

  void count(const ObstacleCounts& counts) {
    for (const auto& [reason, number] : counts) {
      result_.obstacles[reason] += number;
      result_.evaluations += number;
    }
  }

  /// To what a part can be set up to, where that costs next to nothing.
  Placement rounded(const Placement& exact) const {
    const PlacementOptions& options = request_.options;
    Offset offset = exact.offset;
    for (const int i : free_coordinates(options)) {
      const double step = i < 3 ? kLengthStep : kAngleStep;
      offset[i] =
          std::clamp(step * std::round(offset[i] / step), options.lower[i], options.upper[i]);
    }
    const PlacementMeasure measure = meter_(offset);
    const bool is_as_good = measure.feasible == exact.measure.feasible &&
                            measure.value <= exact.measure.value * (1 + kRoundingLoss);
    return is_as_good ? Placement{offset, measure} : exact;
  }

  void conclude() {
    if (!result_.found.measure.feasible) return explain();
    result_.after = plans(result_.found.offset, false);
    const PlanResult& plan = result_.after.two_stage;
    result_.found.measure = meter_.of(result_.after.placed.problem, plan);
    result_.status = plan.status;
    result_.diagnosis = plan.diagnosis;
  }

  void explain() {
    result_.status = Status::infeasible;
    std::string counts;
    for (const auto& [reason, number] : result_.obstacles) {
      counts += fmt::format(
          "{}{:.0f}% {}", counts.empty() ? "" : ", ",
          100.0 * static_cast<double>(number) / static_cast<double>(result_.evaluations), reason);
    }
    result_.diagnosis.push_back({std::nullopt, "no_placement",
                                 fmt::format("none of {} placements in the region can be used ({})",
                                             result_.evaluations, counts),
                                 "a larger region, or more evaluations"});
    result_.diagnosis.push_back(nearest());
  }

  /// What is wrong with the placement that lacks least.
  Diagnosis nearest() const {
    if (const auto standing = meter_.obstacle(result_.found.offset)) return *standing;
    const PlanResult plan = plans(result_.found.offset, true).two_stage;
    Diagnosis diagnosis;
    if (!plan.diagnosis.empty()) diagnosis = plan.diagnosis.front();
    diagnosis.detail =
        fmt::format("where least is missing ({:.0f}% of the waypoints can be passed): ",
                    100 * result_.found.measure.waypoints_share) +
        diagnosis.detail;
    return diagnosis;
  }

  PlacementPlans plans(const Offset& offset, bool quick) const {
    PlacementPlans plans;
    plans.placed = placed(request_, offset);
    const Problem problem =
        quick ? PlacementMeter::without_help(plans.placed.problem) : plans.placed.problem;
    PlanOptions options = options_;
    if (quick) options.monitor.progress = nullptr;
    plans.graph_only = plan_graph_only(problem, options);
    plans.two_stage = plan(problem, options);
    throw_if_cancelled(options_.monitor);
    return plans;
  }

  void stop() {
    result_.status = Status::interrupted;
    result_.diagnosis.push_back({std::nullopt, "interrupted", "stopped by the caller", ""});
  }

  const PlacementRequest& request_;
  const PlanOptions& options_;
  const int threads_;
  const PlacementMeter meter_;
  PlacementTrials trials_;
  PlacementResult result_;
};

}  // namespace

PlacementResult place(const PlacementRequest& request, const PlanOptions& options) {
  check_problem(request.problem);
  validate(request);
  return PlacementPipeline(request, options).run();
}

}  // namespace wristwise
