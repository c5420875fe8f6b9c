#include <algorithm>

#include "collision/point_distance.hpp"
#include "collision/signed_distance.hpp"
#include "wristwise/clearance.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

struct MovingShape {
  const Shape* shape = nullptr;
  int joint = -1;
  BoundingBall ball;           ///< in the shape's frame
  Pose pose;                   ///< of the shape, in the base frame
  Eigen::Vector3d center;      ///< of the ball, in the base frame
  std::size_t placed_for = 0;  ///< number of the posture; 0: never
};

/// Distance of a ball from the shape where that is a box or a cylinder; from the ball round it
/// otherwise.
double ball_to_shape(const MovingShape& shape, const Eigen::Vector3d& center, double radius) {
  const auto local = [&] { return Eigen::Vector3d(shape.pose.inverse(Eigen::Isometry) * center); };
  if (const auto* box = std::get_if<Box>(&shape.shape->geometry)) {
    return point_distance(*box, local()).distance - radius;
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&shape.shape->geometry)) {
    return point_distance(*cylinder, local()).distance - radius;
  }
  return (shape.center - center).norm() - shape.ball.radius - radius;
}

}  // namespace

/// The shapes of the model at the posture set last, each placed when it is first asked for.
class ClearanceChecker::Impl {
 public:
  explicit Impl(std::shared_ptr<const ClearanceModel> model) : model_(std::move(model)) {
    if (!model_) throw InvalidInput("clearance checker", "no model");
    std::vector<std::size_t> first_shape;
    for (const ClearanceModel::Body& body : model_->bodies()) {
      first_shape.push_back(shapes_.size());
      for (const Shape& shape : body.shapes) add_shape(shape, body.joint);
    }
    for (const ClearanceModel::Pair& pair : model_->pairs()) {
      pairs_.push_back({first_shape[static_cast<std::size_t>(pair.body_a)] +
                            static_cast<std::size_t>(pair.shape_a),
                        first_shape[static_cast<std::size_t>(pair.body_b)] +
                            static_cast<std::size_t>(pair.shape_b)});
    }
    bounds_.resize(pairs_.size());
    order_.resize(pairs_.size());
  }

  void set_posture(const JointVector& q) {
    const int joints = model_->robot().joint_count();
    if (q.size() != joints || !q.allFinite()) {
      throw InvalidInput("posture", q.size() == joints ? "not finite" : "wrong number of joints",
                         std::to_string(joints) + " finite joint values");
    }
    forward_kinematics(model_->robot(), q, chain_);
    ++posture_;
  }

  MovingShape& shape_a(int pair) { return placed(pairs_[static_cast<std::size_t>(pair)].first); }
  MovingShape& shape_b(int pair) { return placed(pairs_[static_cast<std::size_t>(pair)].second); }

  double lower_bound(int pair);
  PairDistance distance(int pair);

  /// From the bounding balls alone: cheaper, and not above lower_bound.
  double ball_bound(int pair) {
    const MovingShape& a = shape_a(pair);
    const MovingShape& b = shape_b(pair);
    return (a.center - b.center).norm() - a.ball.radius - b.ball.radius;
  }

  const ClearanceModel& model() const { return *model_; }
  const ChainPose& chain() const { return chain_; }
  std::size_t queries() const { return queries_; }

  /// Pairs with a lower bound below `cutoff`, the most promising first.
  const std::vector<int>& promising(double cutoff) {
    order_.clear();
    for (int pair = 0; pair < static_cast<int>(pairs_.size()); ++pair) {
      bounds_[static_cast<std::size_t>(pair)] = lower_bound(pair);
      if (bound(pair) < cutoff) order_.push_back(pair);
    }
    std::sort(order_.begin(), order_.end(),
              [this](int p, int q) { return bound(p) != bound(q) ? bound(p) < bound(q) : p < q; });
    return order_;
  }
  double bound(int pair) const { return bounds_[static_cast<std::size_t>(pair)]; }

 private:
  void add_shape(const Shape& shape, int joint) {
    MovingShape body;
    body.shape = &shape;
    body.joint = joint;
    body.ball = bounding_ball(shape.geometry);
    body.pose = shape.pose;
    body.center = shape.pose * body.ball.center;
    shapes_.push_back(body);
  }

  MovingShape& placed(std::size_t index) {
    MovingShape& body = shapes_[index];
    if (body.joint >= 0 && body.placed_for != posture_) {
      body.pose = chain_.frames[static_cast<std::size_t>(body.joint)] * body.shape->pose;
      body.center = body.pose * body.ball.center;
      body.placed_for = posture_;
    }
    return body;
  }

  std::shared_ptr<const ClearanceModel> model_;
  std::vector<MovingShape> shapes_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  ChainPose chain_;
  std::size_t posture_ = 0;
  std::size_t queries_ = 0;
  std::vector<double> bounds_;
  std::vector<int> order_;
};

// Each shape lies in its ball, and the signed distance of a smaller shape is never less.
double ClearanceChecker::Impl::lower_bound(int pair) {
  const MovingShape& a = shape_a(pair);
  const MovingShape& b = shape_b(pair);
  return std::max(ball_to_shape(a, b.center, b.ball.radius),
                  ball_to_shape(b, a.center, a.ball.radius));
}

PairDistance ClearanceChecker::Impl::distance(int pair) {
  ++queries_;
  const MovingShape& a = shape_a(pair);
  const MovingShape& b = shape_b(pair);
  const SignedDistance d =
      signed_distance({a.shape->geometry, a.pose}, {b.shape->geometry, b.pose});
  return {pair, d.distance, d.point_a, d.point_b, d.normal};
}

ClearanceChecker::ClearanceChecker(std::shared_ptr<const ClearanceModel> model)
    : impl_(std::make_unique<Impl>(std::move(model))) {
  set_posture(JointVector::Zero(impl_->model().robot().joint_count()));
}
ClearanceChecker::~ClearanceChecker() = default;
ClearanceChecker::ClearanceChecker(ClearanceChecker&&) noexcept = default;
ClearanceChecker& ClearanceChecker::operator=(ClearanceChecker&&) noexcept = default;

const ClearanceModel& ClearanceChecker::model() const { return impl_->model(); }
void ClearanceChecker::set_posture(const JointVector& q) { impl_->set_posture(q); }
const ChainPose& ClearanceChecker::chain() const { return impl_->chain(); }
double ClearanceChecker::lower_bound(int pair, double enough) const {
  const double from_balls = impl_->ball_bound(pair);
  return from_balls >= enough ? from_balls : impl_->lower_bound(pair);
}
PairDistance ClearanceChecker::distance(int pair) { return impl_->distance(pair); }
std::size_t ClearanceChecker::queries() const { return impl_->queries(); }

// (F8) The nearest points' own travel over the surfaces does not change the distance to first
// order, so that d distance / d q = n^T (J_b(p_b) - J_a(p_a)) with the points fixed to the bodies.
JointVector ClearanceChecker::gradient(const PairDistance& measured) const {
  const ClearanceModel& model = impl_->model();
  const auto& pair = model.pairs().at(static_cast<std::size_t>(measured.pair));
  const int joint_a = model.bodies()[static_cast<std::size_t>(pair.body_a)].joint;
  const int joint_b = model.bodies()[static_cast<std::size_t>(pair.body_b)].joint;
  const PointJacobian difference =
      point_jacobian(model.robot(), chain(), joint_b, measured.point_b) -
      point_jacobian(model.robot(), chain(), joint_a, measured.point_a);
  return difference.transpose() * measured.normal;
}

std::optional<PairDistance> ClearanceChecker::first_below(double required) {
  const int count = static_cast<int>(impl_->model().pairs().size());
  for (int pair = 0; pair < count; ++pair) {
    if (impl_->ball_bound(pair) >= required || impl_->lower_bound(pair) >= required) continue;
    const PairDistance measured = impl_->distance(pair);
    if (!(measured.distance >= required)) return measured;
  }
  return std::nullopt;
}

std::optional<PairDistance> ClearanceChecker::nearest(double cutoff) {
  std::optional<PairDistance> best;
  for (const int pair : impl_->promising(cutoff)) {
    if (best && impl_->bound(pair) >= best->distance) break;
    const PairDistance measured = impl_->distance(pair);
    if (measured.distance < (best ? best->distance : cutoff)) best = measured;
  }
  return best;
}

}  // namespace wristwise
