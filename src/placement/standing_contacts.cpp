#include "placement/standing_contacts.hpp"

#include <algorithm>
#include <limits>

#include "collision/signed_distance.hpp"
#include "placement/placed_problem.hpp"

namespace wristwise {

namespace {

constexpr double kRoundOff = 1e-5;  // m, ten times what a distance is exact to

double distance(const std::vector<Shape>& moving, const Pose& motion,
                const std::vector<Shape>& standing) {
  double least = std::numeric_limits<double>::infinity();
  for (const Shape& a : moving) {
    const Pose pose = motion * a.pose;
    for (const Shape& b : standing)
      least = std::min(least, signed_distance({a.geometry, pose}, {b.geometry, b.pose}).distance);
  }
  return least;
}

bool is_disabled(const Scene& scene, const std::string& a, const std::string& b) {
  return std::any_of(scene.disabled.begin(), scene.disabled.end(), [&](const auto& pair) {
    return pair == Scene::Names(a, b) || pair == Scene::Names(b, a);
  });
}

}  // namespace

StandingContacts::StandingContacts(const PlacementRequest& request) {
  const Scene& scene = request.problem.scene;
  if (scene.scope != CollisionScope::all) return;
  for (const Link& link : request.problem.robot->links()) {
    if (link.joint != -1 || link.collision.empty()) continue;
    Body body{link.name, link.collision, scene.clearance};
    for (Shape& shape : body.shapes) shape.pose = link.pose * shape.pose;
    standing_.push_back(std::move(body));
  }
  const std::vector<std::string> moved = moving_objects(request);
  for (const SceneObject& object : scene.objects) {
    const bool moves = std::find(moved.begin(), moved.end(), object.name) != moved.end();
    (moves ? moving_ : standing_).push_back({object.name, object.shapes, 0});
  }
  for (std::size_t a = 0; a < moving_.size(); ++a) {
    for (std::size_t b = 0; b < standing_.size(); ++b) {
      if (is_disabled(scene, moving_[a].name, standing_[b].name)) continue;
      const double given = distance(moving_[a].shapes, Pose::Identity(), standing_[b].shapes);
      pairs_.push_back({a, b, std::min(standing_[b].required, given) - kRoundOff});
    }
  }
}

StandingContact StandingContacts::at(const Pose& motion) const {
  StandingContact contact;
  double most = 0;
  for (const Pair& pair : pairs_) {
    const Body& a = moving_[pair.moving];
    const Body& b = standing_[pair.standing];
    const double missing = pair.required - distance(a.shapes, motion, b.shapes);
    if (missing <= 0) continue;
    contact.depth += missing;
    if (missing <= most) continue;
    most = missing;
    contact.pair = {a.name, b.name};
  }
  return contact;
}

}  // namespace wristwise
