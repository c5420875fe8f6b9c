#pragma once

#include <ceres/cost_function.h>

#include <array>
#include <memory>
#include <vector>

#include "refine/spline.hpp"

namespace wristwise {

/// All residuals of one span in one cost function of its six control points, each a parameter block
/// of one value per joint: the normal equations then get one product per pair of control points and
/// span instead of one per residual.
class BatchCost final : public ceres::CostFunction {
 public:
  explicit BatchCost(int joints);

  /// A cost of consecutive control points, the first of them number `first` of the span.
  void add(ceres::CostFunction* cost, int first);

  bool empty() const { return parts_.empty(); }

  /// Makes control points of the span one and the same: slots[k] is the parameter block of control
  /// point k, counted from 0 without gaps. Call it last.
  void merge(const std::array<int, SplineBasis::kLocal>& slots);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  struct Part {
    std::unique_ptr<ceres::CostFunction> cost;
    int first = 0;
    int row = 0;
  };
  void evaluate_parts(double const* const* control, double* residuals, double** jacobians) const;
  void evaluate_merged(double const* const* control, double* residuals, double** jacobians) const;

  int joints_;
  std::vector<Part> parts_;
  bool merged_ = false;
  std::array<int, SplineBasis::kLocal> slots_{};
  mutable std::vector<double> scratch_;
};

}  // namespace wristwise
