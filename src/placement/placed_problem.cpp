#include "placement/placed_problem.hpp"

#include <algorithm>

#include "placement/placement_options.hpp"

namespace wristwise {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Pose motion_of(const PlacementRequest& request, const Offset& offset) {
  const Pose step = pose_from_xyz_rpy(offset.head<3>(), offset.tail<3>());
  if (request.options.placed == Placed::robot) return step.inverse();
  const Eigen::Translation3d origin(request.part_frame.translation());
  return origin * step * origin.inverse();
}

std::vector<std::string> moving_objects(const PlacementRequest& request) {
  std::vector<std::string> moving;
  const bool listed_move = request.options.placed == Placed::part;
  for (const SceneObject& object : request.problem.scene.objects)
    if (contains(request.options.with, object.name) == listed_move) moving.push_back(object.name);
  return moving;
}

PlacedProblem placed(const PlacementRequest& request, const Offset& offset) {
  validate(request);
  PlacedProblem result{request.problem, {}, motion_of(request, offset), moving_objects(request)};
  result.part_frame = result.motion * request.part_frame;
  result.problem.task = request.task_after(result.motion);
  for (SceneObject& object : result.problem.scene.objects) {
    if (!contains(result.moved, object.name)) continue;
    for (Shape& shape : object.shapes) shape.pose = result.motion * shape.pose;
  }
  return result;
}

}  // namespace wristwise
