#include "placement/placement_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr int kEvaluationsPerCoordinate = 100;
constexpr int kMostMapPoints = 1000;

void validate_region(const PlacementOptions& options) {
  for (int i = 0; i < 6; ++i) {
    const std::string where =
        std::string("placement.") + kCoordinateNames[static_cast<std::size_t>(i)];
    const double lower = options.lower[i], upper = options.upper[i];
    if (!std::isfinite(lower) || !std::isfinite(upper))
      throw InvalidInput(where, "the range is not finite", "[lower, upper]");
    if (lower > upper)
      throw InvalidInput(where,
                         fmt::format("the lower bound {} is above the upper {}", lower, upper),
                         "[lower, upper]");
  }
}

void validate_objects(const PlacementRequest& request) {
  std::vector<std::string> known;
  for (const SceneObject& object : request.problem.scene.objects) known.push_back(object.name);
  const std::vector<std::string>& with = request.options.with;
  for (std::size_t i = 0; i < with.size(); ++i) {
    if (std::find(known.begin(), known.end(), with[i]) == known.end())
      throw InvalidInput("placement.with", "no object '" + with[i] + "'",
                         known.empty()
                             ? "none, the scene has no objects"
                             : "one of the scene, such as " + similar_names(with[i], known));
    if (std::find(with.begin(), with.begin() + static_cast<std::ptrdiff_t>(i), with[i]) !=
        with.begin() + static_cast<std::ptrdiff_t>(i))
      throw InvalidInput("placement.with", "'" + with[i] + "' is given twice", "each object once");
  }
}

/// What is placed is moved in the base frame.
void refuse_moving_parts(const Problem& problem) {
  const Robot& robot = *problem.robot;
  if (robot.part_link() != robot.base_link())
    throw InvalidInput("placement", "the part is on '" + robot.part_link() + "'",
                       "path.link left out: a part that stands in the base link");
  for (const SceneObject& object : problem.scene.objects) {
    if (object.link.empty() || object.link == robot.base_link()) continue;
    throw InvalidInput("placement",
                       "object '" + object.name + "' is fixed to '" + object.link + "'",
                       "objects that stand in the base link");
  }
}

void expect(bool is_valid, const char* option, double value, const char* expected) {
  if (!is_valid)
    throw InvalidInput(std::string("placement.") + option, fmt::format("{}", value), expected);
}

void expect_not_negative(const char* option, double value) {
  expect(value >= 0 && std::isfinite(value), option, value, "a number of at least 0");
}

}  // namespace

void validate(const PlacementRequest& request) {
  const PlacementOptions& options = request.options;
  validate_region(options);
  validate_objects(request);
  if (request.problem.robot) refuse_moving_parts(request.problem);
  expect_not_negative("weights.speed", options.speed_weight);
  expect_not_negative("weights.singularity", options.singularity_weight);
  expect_not_negative("weights.clearance", options.clearance_weight);
  expect(options.singularity_margin >= 0 && options.singularity_margin <= 1, "margins.singularity",
         options.singularity_margin, "0 to 1");
  expect_not_negative("margins.clearance", options.clearance_margin);
  expect(options.evaluations >= 0, "evaluations", options.evaluations, "at least 0");
  expect(options.map_points >= 0 && options.map_points <= kMostMapPoints, "map", options.map_points,
         "0 to 1000 points");
  expect(options.time_limit > 0, "time_limit", options.time_limit, "a positive time");
  if (!request.task_after)
    throw InvalidInput("placement", "nothing says what the task is elsewhere",
                       "PlacementRequest::task_after; load_placement() sets it");
}

std::vector<int> free_coordinates(const PlacementOptions& options) {
  std::vector<int> free;
  for (int i = 0; i < 6; ++i)
    if (options.lower[i] < options.upper[i]) free.push_back(i);
  return free;
}

int evaluation_limit(const PlacementOptions& options) {
  if (options.evaluations > 0) return options.evaluations;
  return kEvaluationsPerCoordinate * (1 + static_cast<int>(free_coordinates(options).size()));
}

bool is_inside(const PlacementOptions& options, const Offset& offset) {
  return (offset.array() >= options.lower.array()).all() &&
         (offset.array() <= options.upper.array()).all();
}

}  // namespace wristwise
