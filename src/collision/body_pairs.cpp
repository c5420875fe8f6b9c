#include "collision/body_pairs.hpp"

#include <algorithm>
#include <set>

#include "collision/geometry_check.hpp"
#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

using Body = ClearanceModel::Body;
using IndexPair = std::pair<int, int>;

IndexPair sorted(int a, int b) { return std::minmax(a, b); }

Body body_of(const Link& link) {
  Body body{link.name, link.joint, link.collision};
  for (Shape& shape : body.shapes) shape.pose = link.pose * shape.pose;
  return body;
}

void check_object(const SceneObject& object, std::set<std::string>& taken) {
  const std::string where = "scene object '" + object.name + "'";
  if (!taken.insert(object.name).second) {
    throw InvalidInput(where, "the name is taken by another object or a link", "another name");
  }
  if (object.shapes.empty()) throw InvalidInput(where, "no shape", "at least one");
}

int find(const std::vector<Body>& bodies, const std::string& name) {
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const Body& body) { return body.name == name; });
  return found == bodies.end() ? -1 : static_cast<int>(found - bodies.begin());
}

int require(const std::vector<Body>& bodies, const std::string& name) {
  const int index = find(bodies, name);
  if (index >= 0) return index;
  std::vector<std::string> names;
  names.reserve(bodies.size());
  for (const Body& body : bodies) names.push_back(body.name);
  throw InvalidInput("collision pairs", "no link or object with shapes is called '" + name + "'",
                     similar_names(name, names));
}

bool move_together(const std::vector<Body>& bodies, int a, int b) {
  return bodies[static_cast<std::size_t>(a)].joint == bodies[static_cast<std::size_t>(b)].joint;
}

[[noreturn]] void refuse_fixed_pair(const Scene::Names& names) {
  throw InvalidInput("collision pair '" + names.first + "', '" + names.second + "'",
                     "they do not move against each other", "bodies with a joint between them");
}

std::vector<IndexPair> listed_pairs(const std::vector<Body>& bodies, const Scene& scene) {
  std::vector<IndexPair> pairs;
  for (const Scene::Names& names : scene.pairs) {
    const IndexPair pair = sorted(require(bodies, names.first), require(bodies, names.second));
    if (move_together(bodies, pair.first, pair.second)) refuse_fixed_pair(names);
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  return pairs;
}

std::set<IndexPair> left_out(const std::vector<Body>& bodies, const Robot& robot,
                             const Scene& scene) {
  std::set<IndexPair> out;
  const auto insert = [&](const std::string& first, const std::string& second) {
    const int a = find(bodies, first);
    const int b = find(bodies, second);
    if (a >= 0 && b >= 0) out.insert(sorted(a, b));
  };
  for (const auto& [i, j] : robot.adjacent_links()) {
    insert(robot.links()[static_cast<std::size_t>(i)].name,
           robot.links()[static_cast<std::size_t>(j)].name);
  }
  for (const auto& [first, second] : scene.disabled) insert(first, second);
  return out;
}

std::vector<IndexPair> all_pairs(const std::vector<Body>& bodies, const Robot& robot,
                                 const Scene& scene) {
  const std::set<IndexPair> out = left_out(bodies, robot, scene);
  const int count = static_cast<int>(bodies.size());
  const int link_count = count - static_cast<int>(scene.objects.size());
  std::vector<IndexPair> pairs;
  for (int a = 0; a < link_count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const bool both_links = b < link_count;
      if (both_links && move_together(bodies, a, b)) continue;
      if (out.count({a, b}) == 0) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

}  // namespace

std::vector<Body> collision_bodies(const Robot& robot, const Scene& scene) {
  std::vector<Body> bodies;
  std::set<std::string> taken;
  for (const Link& link : robot.links()) {
    taken.insert(link.name);
    if (!link.collision.empty()) bodies.push_back(body_of(link));
  }
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const Body& a, const Body& b) { return a.joint < b.joint; });
  for (const SceneObject& object : scene.objects) {
    check_object(object, taken);
    bodies.push_back({object.name, -1, object.shapes});
  }
  for (const Body& body : bodies) {
    for (const Shape& shape : body.shapes) check_shape("'" + body.name + "'", shape);
  }
  return bodies;
}

std::vector<IndexPair> body_pairs(const std::vector<Body>& bodies, const Robot& robot,
                                  const Scene& scene) {
  if (scene.scope == CollisionScope::off) return {};
  if (scene.scope == CollisionScope::pairs) return listed_pairs(bodies, scene);
  return all_pairs(bodies, robot, scene);
}

}  // namespace wristwise
