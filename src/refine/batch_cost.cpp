#include "refine/batch_cost.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace wristwise {

namespace {

constexpr int kLocal = SplineBasis::kLocal;
using Blocks = std::array<double*, kLocal>;

}  // namespace

BatchCost::BatchCost(int joints) : joints_(joints) {
  set_num_residuals(0);
  mutable_parameter_block_sizes()->assign(kLocal, joints);
}

void BatchCost::add(ceres::CostFunction* cost, int first) {
  parts_.push_back({std::unique_ptr<ceres::CostFunction>(cost), first, num_residuals()});
  set_num_residuals(num_residuals() + cost->num_residuals());
}

void BatchCost::merge(const std::array<int, kLocal>& slots) {
  slots_ = slots;
  const int count = 1 + *std::max_element(slots.begin(), slots.end());
  merged_ = count < kLocal;
  mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(count), joints_);
  const auto residuals = static_cast<std::size_t>(num_residuals());
  if (merged_) scratch_.resize(kLocal * residuals * static_cast<std::size_t>(joints_));
}

bool BatchCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  if (!merged_) {
    evaluate_parts(parameters, residuals, jacobians);
    return true;
  }
  std::array<double const*, kLocal> control{};
  for (std::size_t k = 0; k < kLocal; ++k) control[k] = parameters[slots_[k]];
  jacobians == nullptr ? evaluate_parts(control.data(), residuals, nullptr)
                       : evaluate_merged(control.data(), residuals, jacobians);
  return true;
}

/// Jacobian blocks are stored by rows, so that each part writes its rows in place.
void BatchCost::evaluate_parts(double const* const* control, double* residuals,
                               double** jacobians) const {
  for (const Part& part : parts_) {
    if (jacobians == nullptr) {
      part.cost->Evaluate(control + part.first, residuals + part.row, nullptr);
      continue;
    }
    const auto blocks = static_cast<int>(part.cost->parameter_block_sizes().size());
    const int size = part.cost->num_residuals() * joints_;
    Blocks rows{};
    for (int k = 0; k < kLocal; ++k) {
      if (jacobians[k] == nullptr) continue;
      double* block = jacobians[k] + std::ptrdiff_t{part.row} * joints_;
      const bool seen = k >= part.first && k < part.first + blocks;
      if (seen) rows[static_cast<std::size_t>(k - part.first)] = block;
      if (!seen) std::fill_n(block, size, 0.0);
    }
    part.cost->Evaluate(control + part.first, residuals + part.row, rows.data());
  }
}

/// The derivative with respect to a shared block is the sum over the control points that share it.
void BatchCost::evaluate_merged(double const* const* control, double* residuals,
                                double** jacobians) const {
  const int size = num_residuals() * joints_;
  Blocks blocks{};
  for (int k = 0; k < kLocal; ++k) {
    blocks[static_cast<std::size_t>(k)] = scratch_.data() + std::ptrdiff_t{k} * size;
  }
  evaluate_parts(control, residuals, blocks.data());
  for (std::size_t slot = 0; slot < parameter_block_sizes().size(); ++slot) {
    if (jacobians[slot] != nullptr) std::fill_n(jacobians[slot], size, 0.0);
  }
  for (std::size_t k = 0; k < kLocal; ++k) {
    double* sum = jacobians[slots_[k]];
    if (sum == nullptr) continue;
    for (int i = 0; i < size; ++i) sum[i] += blocks[k][i];
  }
}

}  // namespace wristwise
