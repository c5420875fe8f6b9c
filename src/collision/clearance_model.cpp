#include <algorithm>
#include <cmath>

#include "collision/body_pairs.hpp"
#include "collision/motion_radius.hpp"
#include "collision/permanent_contacts.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

double checked_clearance(double clearance) {
  if (std::isfinite(clearance) && clearance >= 0) return clearance;
  throw InvalidInput("clearance", "it is " + std::to_string(clearance),
                     "a finite length of zero or more, in m");
}

std::vector<bool> always_near(const Robot& robot, const Scene& scene,
                              const std::vector<ClearanceModel::Body>& bodies,
                              const std::vector<std::pair<int, int>>& pairs) {
  if (scene.scope != CollisionScope::all) return std::vector<bool>(pairs.size(), false);
  return permanent_contacts(robot, bodies, pairs, scene.clearance);
}

}  // namespace

ClearanceModel::ClearanceModel(std::shared_ptr<const Robot> robot, const Scene& scene)
    : robot_(std::move(robot)), clearance_(checked_clearance(scene.clearance)) {
  if (!robot_) throw InvalidInput("clearance model", "no robot");
  bodies_ = collision_bodies(*robot_, scene);
  const auto candidates = body_pairs(bodies_, *robot_, scene);
  const auto near = always_near(*robot_, scene, bodies_, candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto [a, b] = candidates[i];
    const Body& body_a = bodies_[static_cast<std::size_t>(a)];
    const Body& body_b = bodies_[static_cast<std::size_t>(b)];
    const bool never_moves = body_a.joint == body_b.joint;
    if (never_moves && !near[i]) continue;
    if (near[i] && scene.find_permanent_contacts &&
        may_stay_in_contact(bodies_, *robot_, scene, candidates[i])) {
      permanent_contacts_.emplace_back(body_a.name, body_b.name);
      continue;
    }
    for (std::size_t m = 0; m < body_a.shapes.size(); ++m) {
      for (std::size_t n = 0; n < body_b.shapes.size(); ++n) {
        pairs_.push_back({a, static_cast<int>(m), b, static_cast<int>(n)});
        motion_radius_.push_back(wristwise::motion_radius(*robot_, body_a.joint, body_a.shapes[m],
                                                          body_b.joint, body_b.shapes[n]));
        reach_.push_back(body_a.joint > body_b.joint
                             ? reach_of(*robot_, body_a.joint, body_a.shapes[m], body_b.joint)
                             : reach_of(*robot_, body_b.joint, body_b.shapes[n], body_a.joint));
      }
    }
  }
}

ClearanceModel ClearanceModel::with_clearance(double clearance) const {
  ClearanceModel other = *this;
  other.clearance_ = checked_clearance(clearance);
  return other;
}

ClearanceModel::Names ClearanceModel::names(int pair) const {
  const Pair& p = pairs_.at(static_cast<std::size_t>(pair));
  return {bodies_[static_cast<std::size_t>(p.body_a)].name,
          bodies_[static_cast<std::size_t>(p.body_b)].name};
}

}  // namespace wristwise
