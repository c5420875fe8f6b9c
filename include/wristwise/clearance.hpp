#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wristwise/kinematics.hpp"
#include "wristwise/scene.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// The pairs of convex shapes whose distance counts. Immutable, shared by threads.
class ClearanceModel {
 public:
  /// A link or an object with its shapes. Poses are in the frame of `joint` (base for -1).
  struct Body {
    std::string name;           ///< of the link or the object
    int joint = -1;             ///< that moves it, as an index; -1: fixed to the part's link
    std::vector<Shape> shapes;  ///< poses in the frame of `joint`
  };
  /// One shape of each of two bodies, as indices.
  struct Pair {
    int body_a = 0;   ///< into bodies()
    int shape_a = 0;  ///< into that body's shapes
    int body_b = 0;   ///< into bodies()
    int shape_b = 0;  ///< into that body's shapes
  };
  /// The names of two bodies.
  using Names = std::pair<std::string, std::string>;

  /// Links that move together, links joined by one joint, an object and what moves with the link
  /// that it names, disabled pairs and what is outside the scope are left out; so are a fixed link
  /// and an object that are clear, as they stay so.
  /// With scene.find_permanent_contacts pairs of links (of an object and a link only those joined
  /// by one joint at most: an object that swallows the robot is no contact to live with) that are
  /// nearer than scene.clearance in each of a fixed set of random postures are left out too (unless
  /// listed by CollisionScope::pairs); they are named by permanent_contacts().
  /// @throws InvalidInput where a listed name is unknown or a name given twice, a listed pair never
  /// moves, the clearance is negative or not finite, or a shape unusable. Unknown names among the
  /// disabled pairs are passed over: an SRDF may speak of links outside the chain.
  ClearanceModel(std::shared_ptr<const Robot> robot, const Scene& scene);

  /// Whose links are measured.
  const Robot& robot() const { return *robot_; }
  /// Links that have shapes, then the objects.
  const std::vector<Body>& bodies() const { return bodies_; }
  /// Those that count; `pair` everywhere below is an index into them.
  const std::vector<Pair>& pairs() const { return pairs_; }
  /// Pairs of bodies that were left out because they touch in every posture.
  const std::vector<Names>& permanent_contacts() const { return permanent_contacts_; }
  double clearance() const { return clearance_; }  ///< required, m
  /// The same pairs with another clearance (m, >= 0).
  ClearanceModel with_clearance(double clearance) const;
  Names names(int pair) const;  ///< of the two bodies of a pair

  /// Bound on how fast the distance of a pair changes: |d(q + dq) - d(q)| <= sum_j r_j |dq_j| for
  /// every q inside the limits (F9). m per rad, or m per m.
  const JointVector& motion_radius(int pair) const {
    return motion_radius_[static_cast<std::size_t>(pair)];
  }

  /// For each joint between the pair's bodies, a bound on how far a point of the body beyond it can
  /// be from its axis, for every q inside the limits; 1 for a prismatic joint, 0 for a joint that
  /// moves both or neither (F31). m per rad, or m per m.
  const JointVector& reach(int pair) const { return reach_[static_cast<std::size_t>(pair)]; }

 private:
  std::shared_ptr<const Robot> robot_;
  std::vector<Body> bodies_;
  std::vector<Pair> pairs_;
  std::vector<JointVector> motion_radius_;
  std::vector<JointVector> reach_;
  std::vector<Names> permanent_contacts_;
  double clearance_ = 0;
};

/// Signed distance of a pair at one posture.
struct PairDistance {
  int pair = -1;            ///< index into ClearanceModel::pairs()
  double distance = 0;      ///< m; negative: depth of penetration
  Eigen::Vector3d point_a;  ///< on shape a, base frame, m
  Eigen::Vector3d point_b;  ///< on shape b; point_b - point_a = distance * normal
  Eigen::Vector3d normal;   ///< unit; moving shape b along +normal increases the distance
};

/// Measures the pairs of a model at a posture. It caches: one per thread, cheap to make.
class ClearanceChecker {
 public:
  /// A checker of that model (not null), with no posture yet.
  explicit ClearanceChecker(std::shared_ptr<const ClearanceModel> model);
  ~ClearanceChecker();
  ClearanceChecker(ClearanceChecker&&) noexcept;             ///< takes the caches along
  ClearanceChecker& operator=(ClearanceChecker&&) noexcept;  ///< takes the caches along

  const ClearanceModel& model() const;  ///< whose pairs it measures

  /// The posture (n values, rad or m) that everything below is measured at. To be called first.
  void set_posture(const JointVector& q);
  const ChainPose& chain() const;  ///< forward kinematics of that posture

  /// A lower bound (m) on the distance of the pair from bounding volumes; cheap, and cheaper where
  /// one of `enough` or more is found at once.
  double lower_bound(int pair, double enough = 1e9) const;

  /// The signed distance (m); exact to 1e-6 m, in penetration too.
  PairDistance distance(int pair);

  /// d distance / d q, n values, m per rad or m per m (F8).
  JointVector gradient(const PairDistance& measured) const;

  /// The first pair, in the order of the model, with a distance below `required` (m).
  std::optional<PairDistance> first_below(double required);

  /// The pair with the least distance, exact where that is below `cutoff` (m); nullopt where there
  /// is none below it.
  std::optional<PairDistance> nearest(double cutoff = 1e9);

  /// Exact distance queries made since construction.
  std::size_t queries() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wristwise
