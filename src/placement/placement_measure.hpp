#pragma once

#include "kinematics/singularity.hpp"
#include "placement/standing_contacts.hpp"
#include "wristwise/placement.hpp"

namespace wristwise {

/// Measures placements by planning there (F81, F82). Shared by threads.
class PlacementMeter {
 public:
  /// @param request must outlive the meter
  PlacementMeter(const PlacementRequest& request, const PlanOptions& options);

  /// Plans, without looking for help where that fails, and measures.
  /// @throws Cancelled
  PlacementMeasure operator()(const Offset& offset) const;

  /// Of a plan that there is already; `problem` is the one it was made for.
  PlacementMeasure of(const Problem& problem, const PlanResult& plan) const;

  /// The problem, without the options that only look for help.
  static Problem without_help(Problem problem);

  /// What stands in the way of standing there; nullopt where nothing does.
  std::optional<Diagnosis> obstacle(const Offset& offset) const;

 private:
  double value(const PlacementMeasure& measure) const;
  double missing(const Problem& problem, const PlanResult& plan, double share) const;
  std::optional<double> clearance(const Problem& problem, const Trajectory& motion) const;
  double singularity_distance(const Trajectory& motion) const;

  const PlacementRequest& request_;
  PlanOptions options_;
  StandingContacts contacts_;
  SingularityDistance singularity_;
};

}  // namespace wristwise
