#pragma once

#include <vector>

#include "wristwise/options.hpp"
#include "wristwise/seam.hpp"

namespace wristwise {

/// Some waypoints of a task, with the caller's own costs told the numbers that these have in the
/// whole task.
struct SubTask {
  Task task;
  CostOptions cost;
};

/// @param waypoints increasing
SubTask sub_task(const Task& whole, const CostOptions& cost,
                 const std::vector<std::size_t>& waypoints);

/// Waypoints first .. last - 1.
SubTask sub_task(const Task& whole, const CostOptions& cost, std::size_t first, std::size_t last);

}  // namespace wristwise
