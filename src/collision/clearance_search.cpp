#include "collision/clearance_search.hpp"

#include <algorithm>

namespace wristwise {

namespace {

constexpr int kDeepest = 40;       // halvings of a piece
constexpr int kDeepestToMark = 5;  // halvings of a piece, of what is not shown
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double magnitude(const MotionPiece::Polynomials& joints, int j, int derivative) {
  double sum = 0;
  for (int k = derivative; k < 6; ++k) {
    sum += (derivative == 1 ? k : k * (k - 1)) * std::abs(joints(j, k));
  }
  return sum;
}

/// One of the shapes of a pair, and the frame of its joint.
struct Side {
  const Shape& shape;
  int joint;

  Side(const ClearanceModel& model, int body, int index)
      : shape(
            model.bodies()[static_cast<std::size_t>(body)].shapes[static_cast<std::size_t>(index)]),
        joint(model.bodies()[static_cast<std::size_t>(body)].joint) {}

  /// The largest n.x of the shape's points, in the frame of its joint.
  double extent(const Eigen::Vector3d& n) const {
    const Eigen::Vector3d local = shape.pose.linear().transpose() * n;
    return local.dot(support_point(shape.geometry, local)) + n.dot(shape.pose.translation());
  }
};

/// The nearer body of a pair along the chain, and the farther one.
std::pair<Side, Side> sides(const ClearanceModel& model, int pair) {
  const ClearanceModel::Pair& p = model.pairs()[static_cast<std::size_t>(pair)];
  const Side a(model, p.body_a, p.shape_a), b(model, p.body_b, p.shape_b);
  return a.joint <= b.joint ? std::pair(a, b) : std::pair(b, a);
}

void record(const PairDistance& measured, double time, ClearanceFinding& finding) {
  if (measured.distance >= finding.least) return;
  finding.least = measured.distance;
  finding.pair = measured.pair;
  finding.time = time;
}

}  // namespace

void ClearanceSearch::look_at(double time, const JointVector& q, ClearanceFinding& finding) {
  ++postures_;
  checker_.set_posture(q);
  if (const auto nearest = checker_.nearest(finding.least)) record(*nearest, time, finding);
}

void ClearanceSearch::look_along(const MotionPiece& piece, ClearanceFinding& finding) {
  const auto joints = piece.over(piece.start(), piece.end());
  const double middle = 0.5 * (piece.start() + piece.end());
  if (!(finding.least < kInfinity)) look_at(middle, joints.col(0), finding);
  ++postures_;
  checker_.set_posture(joints.col(0));
  const JointVector strays = spread(joints);
  std::vector<int> open;
  for (int pair = 0; pair < static_cast<int>(directions_.size()); ++pair) {
    const double stray = checker_.model().motion_radius(pair).dot(strays);
    const double enough = finding.least - resolution_ + stray;
    const double bound = checker_.lower_bound(pair, enough) - stray;
    if (bound + stray >= enough) {
      finding.bound = std::min(finding.bound, bound);
    } else {
      open.push_back(pair);
    }
  }
  if (open.empty()) return;
  const Instant first = instant(piece, piece.start()), last = instant(piece, piece.end());
  for (const int pair : open) look({piece, pair, first, last, 0}, finding);
}

// (F31) With the direction n held in the frame of the nearer body, the gap between the planes
// across n that touch the bodies is a lower bound of their distance, and the least over the farther
// body's points of functions of t; each is at least the lesser of its ends less (t1 - t0)^2 / 8
// times the largest second derivative.
void ClearanceSearch::look(const Span& span, ClearanceFinding& finding) {
  const auto joints = span.piece.over(span.first.time, span.last.time);
  const double bent = bend(span.pair, joints);
  const bool has_direction = !directions_[static_cast<std::size_t>(span.pair)].isZero(0);
  const double at_ends =
      has_direction ? std::min(gap(span.pair, span.first), gap(span.pair, span.last)) : -kInfinity;
  if (at_ends - bent >= finding.least - resolution_) {
    finding.bound = std::min(finding.bound, at_ends - bent);
    return;
  }
  const Instant middle = instant(span.piece, 0.5 * (span.first.time + span.last.time));
  // Halving quarters what is bent away. Where that will do the same direction serves, and where it
  // won't, whatever the direction, there is no use for a better one yet.
  const double floor = finding.least - resolution_;
  const bool halves_will_do =
      has_direction && std::min(at_ends, gap(span.pair, middle)) - bent / 4 >= floor;
  const bool halves_wont_do = span.nearby - bent / 4 < floor;
  double nearby = span.nearby;
  if (!halves_will_do && (!halves_wont_do || span.depth >= kDeepest)) {
    const PairDistance measured = measure(span.pair, joints.col(0));
    nearby = measured.distance;
    record(measured, middle.time, finding);
    const double bound = nearby - checker_.model().motion_radius(span.pair).dot(spread(joints));
    if (bound >= finding.least - resolution_ || span.depth >= kDeepest) {
      finding.bound = std::min(finding.bound, bound);
      return;
    }
  }
  look({span.piece, span.pair, span.first, middle, span.depth + 1, nearby}, finding);
  look({span.piece, span.pair, middle, span.last, span.depth + 1, nearby}, finding);
}

std::vector<std::pair<int, ClearanceSearch::Range>> ClearanceSearch::not_shown(
    const MotionPiece& piece, double floor) {
  std::vector<std::pair<int, Range>> ranges;
  const Instant first = instant(piece, piece.start()), last = instant(piece, piece.end());
  for (int pair = 0; pair < static_cast<int>(directions_.size()); ++pair) {
    mark({piece, pair, first, last, 0}, floor, ranges);
  }
  return ranges;
}

void ClearanceSearch::mark(const Span& span, double floor,
                           std::vector<std::pair<int, Range>>& ranges) {
  const auto joints = span.piece.over(span.first.time, span.last.time);
  checker_.set_posture(joints.col(0));
  const double stray = checker_.model().motion_radius(span.pair).dot(spread(joints));
  if (checker_.lower_bound(span.pair) - stray >= floor) return;
  if (measure(span.pair, joints.col(0)).distance - stray >= floor) return;
  const double at_ends = std::min(gap(span.pair, span.first), gap(span.pair, span.last));
  if (at_ends - bend(span.pair, joints) >= floor) return;
  if (span.depth < kDeepestToMark) {
    const Instant middle = instant(span.piece, 0.5 * (span.first.time + span.last.time));
    mark({span.piece, span.pair, span.first, middle, span.depth + 1}, floor, ranges);
    mark({span.piece, span.pair, middle, span.last, span.depth + 1}, floor, ranges);
    return;
  }
  const bool goes_on = !ranges.empty() && ranges.back().first == span.pair &&
                       ranges.back().second.second == span.first.time;
  if (goes_on) {
    ranges.back().second.second = span.last.time;
  } else {
    ranges.push_back({span.pair, {span.first.time, span.last.time}});
  }
}

ClearanceSearch::Instant ClearanceSearch::instant(const MotionPiece& piece, double time) {
  ++postures_;
  Instant result;
  result.time = time;
  forward_kinematics(checker_.model().robot(), piece.posture(time), result.chain);
  return result;
}

/// (F31) Between the planes across the pair's direction, m.
double ClearanceSearch::gap(int pair, const Instant& at) const {
  const auto [near, far] = sides(checker_.model(), pair);
  const Eigen::Vector3d& n = directions_[static_cast<std::size_t>(pair)];
  const Pose near_frame = at.chain.frame(near.joint), far_frame = at.chain.frame(far.joint);
  const Eigen::Vector3d in_base = near_frame.linear() * n;
  const Eigen::Vector3d in_far = far_frame.linear().transpose() * in_base;
  const double offset = in_base.dot(far_frame.translation() - near_frame.translation());
  return -near.extent(-n) - offset - far.extent(in_far);
}

/// (F31) With s from -1 to 1, half the largest second derivative of a point of the farther body.
double ClearanceSearch::bend(int pair, const MotionPiece::Polynomials& joints) const {
  const JointVector& reach = checker_.model().reach(pair);
  const auto& robot_joints = checker_.model().robot().joints();
  double sum = 0, turning = 0;
  for (int j = 0; j < reach.size(); ++j) {
    if (reach[j] == 0) continue;
    const bool turns = robot_joints[static_cast<std::size_t>(j)].type != JointType::prismatic;
    const double speed = magnitude(joints, j, 1);
    const double own = turns ? speed : 0;
    sum += reach[j] * (magnitude(joints, j, 2) + speed * (own + 2 * turning));
    turning += own;
  }
  return sum / 2;
}

PairDistance ClearanceSearch::measure(int pair, const JointVector& q) {
  ++postures_;
  checker_.set_posture(q);
  PairDistance measured = checker_.distance(pair);
  const ClearanceModel::Pair& p = checker_.model().pairs()[static_cast<std::size_t>(pair)];
  const auto& bodies = checker_.model().bodies();
  const int joint_a = bodies[static_cast<std::size_t>(p.body_a)].joint;
  const int joint_b = bodies[static_cast<std::size_t>(p.body_b)].joint;
  const Eigen::Vector3d towards_near =
      joint_a <= joint_b ? Eigen::Vector3d(-measured.normal) : measured.normal;
  directions_[static_cast<std::size_t>(pair)] =
      checker_.chain().frame(std::min(joint_a, joint_b)).linear().transpose() * towards_near;
  return measured;
}

}  // namespace wristwise
