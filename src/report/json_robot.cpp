#include "report/json_robot.hpp"

#include <nlohmann/json.hpp>

#include "report/json_array.hpp"

namespace wristwise::json {

namespace {

Json joint(const Joint& joint) {
  return {{"name", joint.name},
          {"prismatic", joint.type == JointType::prismatic},
          {"origin", pose(joint.origin)},
          {"axis", array(joint.axis, 12)},
          {"lower", number(joint.lower)},
          {"upper", number(joint.upper)},
          {"limits",
           {number(joint.max_velocity), number(joint.max_acceleration), number(joint.max_jerk)}}};
}

/// Of the base link: where a positioner carries the part, it moves against the chain's first link.
Json standing(const Robot& robot) {
  for (const Link& link : robot.links())
    if (link.name == robot.base_link()) return {{"joint", link.joint}, {"pose", pose(link.pose)}};
  return {{"joint", -1}, {"pose", pose(Pose::Identity())}};
}

struct GeometryToJson {
  Json operator()(const Box& box) const { return {{"box", array(box.size, kExact)}}; }
  Json operator()(const Sphere& sphere) const {
    return {{"sphere", rounded(sphere.radius, kExact)}};
  }
  Json operator()(const Cylinder& cylinder) const {
    return {{"cylinder", {rounded(cylinder.radius, kExact), rounded(cylinder.length, kExact)}}};
  }
  Json operator()(const ConvexHull& hull) const {
    Json vertices = Json::array(), triangles = Json::array();
    for (const Eigen::Vector3d& vertex : hull.vertices)
      for (const double x : vertex) vertices.push_back(rounded(x, kShown));
    for (const auto& triangle : hull.triangles)
      for (const int corner : triangle) triangles.push_back(corner);
    return {{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}};
  }
};

Json shape(const Shape& shape) {
  Json json = std::visit(GeometryToJson{}, shape.geometry);
  json["pose"] = pose(shape.pose);
  return json;
}

}  // namespace

Json robot(const Robot& robot) {
  Json joints = Json::array();
  for (const Joint& each : robot.joints()) joints.push_back(joint(each));
  return {{"name", robot.name()},
          {"joints", std::move(joints)},
          {"tcp", pose(robot.tcp())},
          {"standing", standing(robot)}};
}

Json bodies(const ClearanceModel& model, std::size_t object_count) {
  Json json = Json::array();
  const std::size_t links = model.bodies().size() - object_count;
  for (const ClearanceModel::Body& body : model.bodies()) {
    Json shapes = Json::array();
    for (const Shape& each : body.shapes) shapes.push_back(shape(each));
    json.push_back({{"name", body.name},
                    {"object", json.size() >= links},
                    {"joint", body.joint},
                    {"shapes", std::move(shapes)}});
  }
  return json;
}

}  // namespace wristwise::json
