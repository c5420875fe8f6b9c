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

/// @param shapes in the frame of the link
Body body_on(const Link& link, const std::string& name, std::vector<Shape> shapes) {
  for (Shape& shape : shapes) shape.pose = link.pose * shape.pose;
  return {name, link.joint, std::move(shapes)};
}

/// The link that an object is fixed to. A robot made by hand may leave out its base.
Link carrier(const SceneObject& object, const Robot& robot) {
  const std::string& name = object.link.empty() ? robot.base_link() : object.link;
  if (const Link* link = robot.find_link(name)) return *link;
  if (object.link.empty()) return {};
  std::vector<std::string> names;
  for (const Link& link : robot.links()) names.push_back(link.name);
  throw InvalidInput("scene object '" + object.name + "'", "no link '" + name + "'",
                     "a link of the robot such as " + similar_names(name, names));
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

/// Null for a link; objects come last.
const SceneObject* object_of(const std::vector<Body>& bodies, const Scene& scene, int body) {
  const int first = static_cast<int>(bodies.size() - scene.objects.size());
  return body < first ? nullptr : &scene.objects[static_cast<std::size_t>(body - first)];
}

bool are_adjacent(const Robot& robot, const std::string& a, const std::string& b) {
  return std::any_of(robot.adjacent_links().begin(), robot.adjacent_links().end(),
                     [&](const std::pair<int, int>& pair) {
                       const auto& first = robot.links()[static_cast<std::size_t>(pair.first)].name;
                       const auto& second =
                           robot.links()[static_cast<std::size_t>(pair.second)].name;
                       return (first == a && second == b) || (first == b && second == a);
                     });
}

/// Joined for good: links, objects, or an object and the link that it is said to be fixed to.
bool are_one(const std::vector<Body>& bodies, const Scene& scene, int a, int b) {
  if (!move_together(bodies, a, b)) return false;
  const SceneObject* object = object_of(bodies, scene, b);
  return object == nullptr || object_of(bodies, scene, a) != nullptr || !object->link.empty();
}

std::vector<IndexPair> all_pairs(const std::vector<Body>& bodies, const Robot& robot,
                                 const Scene& scene) {
  const std::set<IndexPair> out = left_out(bodies, robot, scene);
  const int count = static_cast<int>(bodies.size());
  std::vector<IndexPair> pairs;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (!are_one(bodies, scene, a, b) && out.count({a, b}) == 0) pairs.emplace_back(a, b);
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
    if (!link.collision.empty()) bodies.push_back(body_on(link, link.name, link.collision));
  }
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const Body& a, const Body& b) { return a.joint < b.joint; });
  for (const SceneObject& object : scene.objects) {
    check_object(object, taken);
    bodies.push_back(body_on(carrier(object, robot), object.name, object.shapes));
  }
  for (const Body& body : bodies) {
    for (const Shape& shape : body.shapes) check_shape("'" + body.name + "'", shape);
  }
  return bodies;
}

bool may_stay_in_contact(const std::vector<Body>& bodies, const Robot& robot, const Scene& scene,
                         const IndexPair& pair) {
  const auto [a, b] = pair;
  const SceneObject* object = object_of(bodies, scene, b);
  if (object == nullptr || move_together(bodies, a, b)) return true;
  if (object_of(bodies, scene, a) != nullptr || object->link.empty()) return false;
  return are_adjacent(robot, bodies[static_cast<std::size_t>(a)].name, object->link);
}

std::vector<IndexPair> body_pairs(const std::vector<Body>& bodies, const Robot& robot,
                                  const Scene& scene) {
  if (scene.scope == CollisionScope::off) return {};
  if (scene.scope == CollisionScope::pairs) return listed_pairs(bodies, scene);
  return all_pairs(bodies, robot, scene);
}

}  // namespace wristwise
