#include "app/new_problem/seam_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "wristwise/kinematics.hpp"

namespace wristwise::app {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kPostures = 1000;       // that say how far the robot reaches
constexpr int kOwnPostures = 60;      // around which a seam is tried
constexpr int kPosesOnSeam = 13;      // that have to be reached
constexpr int kSpins = 12;            // about the torch's axis
constexpr std::size_t kStarts = 12;   // postures of the first pose that are followed, about
constexpr double kLongestStep = 0.5;  // rad or m, of a joint from pose to pose
constexpr double kGrid = 0.01;        // m, to which places are rounded

double rounded(double value, double grid) { return std::round(value / grid) * grid; }

/// Postures spread evenly over `share` of the joints' ranges; the same on every machine.
std::vector<JointVector> spread_postures(const Robot& robot, int count, double share) {
  std::mt19937 random(1);
  const auto unit = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<JointVector> postures;
  for (int i = 0; i < count; ++i) {
    JointVector q(robot.joint_count());
    for (int j = 0; j < robot.joint_count(); ++j) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(j)];
      const double lower = std::max(joint.lower, -kPi), upper = std::min(joint.upper, kPi);
      q[j] = 0.5 * (lower + upper) + share * (unit() - 0.5) * (upper - lower);
    }
    postures.push_back(q);
  }
  return postures;
}

/// Corners of the box that holds the TCP.
struct Reach {
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d upper = -lower;
  double size() const { return (upper - lower).norm(); }
};

Reach reach_of(const Robot& robot) {
  Reach reach;
  for (const JointVector& q : spread_postures(robot, kPostures, 1)) {
    const Eigen::Vector3d tcp = tcp_pose(robot, q).translation();
    reach.lower = reach.lower.cwiseMin(tcp);
    reach.upper = reach.upper.cwiseMax(tcp);
  }
  return reach;
}

double seam_length(const Reach& reach) {
  return std::clamp(rounded(0.08 * reach.size(), kGrid), 2 * kGrid, 0.3);
}

SeamPlace place_at(const Eigen::Vector3d& position, double length) {
  SeamPlace place;
  for (int i = 0; i < 3; ++i) place.frame.translation()[i] = rounded(position[i], kGrid);
  place.length = length;
  return place;
}

/// Torch straight down onto a part that stands still: in front of the robot first, then beside it.
std::vector<SeamPlace> places_around(const Reach& reach, double length) {
  std::vector<SeamPlace> places;
  const std::array<Eigen::Vector3d, 4> corners = {
      Eigen::Vector3d(reach.upper.x(), 0, 0), Eigen::Vector3d(0, reach.upper.y(), 0),
      Eigen::Vector3d(0, reach.lower.y(), 0), Eigen::Vector3d(reach.lower.x(), 0, 0)};
  for (const Eigen::Vector3d& corner : corners) {
    for (const double height : {0.2, 0.1, 0.3, 0.0, 0.45, 0.6, -0.2, -0.4, -0.6}) {
      const double z = height * (height > 0 ? reach.upper.z() : -reach.lower.z());
      for (const double share : {0.6, 0.5, 0.7, 0.4, 0.8, 0.3})
        places.push_back(place_at(share * corner + Eigen::Vector3d(0, 0, z), length));
    }
  }
  return places;
}

/// Torch straight down onto a part that moves.
std::vector<SeamPlace> places_on_part(double length) {
  std::vector<SeamPlace> places;
  for (const double z : {0.05, 0.1, 0.2, 0.0, 0.3})
    for (const double x : {0.0, 0.1, -0.1, 0.2, -0.2})
      places.push_back(place_at({x, 0, z}, length));
  return places;
}

SeamPlace place_of_posture(const Pose& tcp, double length) {
  SeamPlace place;
  place.frame = tcp;
  place.torch_down = false;
  place.length = length;
  return place;
}

/// Lines through the TCP, and arcs from there.
std::vector<SeamPlace> places_of_postures(const Robot& robot, SeamShape shape, double length) {
  std::vector<SeamPlace> places;
  for (const JointVector& q : spread_postures(robot, kOwnPostures, 0.5)) {
    SeamPlace place = place_of_posture(tcp_pose(robot, q), length);
    if (shape == SeamShape::line) {
      for (place.axis = 1; place.axis >= 0; --place.axis) places.push_back(place);
      place.axis = 2;
      places.push_back(place);
      continue;
    }
    for (const double angle : {kPi, kPi / 3}) {
      place.angle = angle;
      place.frame = tcp_pose(robot, q) * Eigen::Translation3d(arc_radius(place), 0, 0);
      places.push_back(place);
    }
  }
  return places;
}

double distance(const JointVector& a, const JointVector& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

/// Asks for postures along one seam.
class SeamReach {
 public:
  SeamReach(const Robot& robot, const InverseKinematics& solver) : robot_(robot), solver_(solver) {}

  /// Sets the posture at the start where one can be followed to the end.
  bool reaches(SeamPlace& place, SeamShape shape) const {
    const SeamPiece seam = seam_piece(place, shape);
    const int spins = solver_.meets_every_pose() ? kSpins : 1;
    for (int spin = 0; spin < spins; ++spin) {
      const Pose turn(Eigen::AngleAxisd(2 * kPi * spin / spins, Eigen::Vector3d::UnitZ()));
      const std::vector<JointVector> starts = postures(seam.frame_at(0) * turn);
      const std::size_t stride = 1 + starts.size() / kStarts;
      for (std::size_t i = 0; i < starts.size(); i += stride) {
        if (!can_follow(starts[i], seam, turn)) continue;
        place.posture = starts[i];
        return true;
      }
    }
    return false;
  }

 private:
  std::vector<JointVector> postures(const Pose& tcp) const {
    std::vector<JointVector> branches, inside;
    if (solver_.meets_every_pose())
      solver_.solve(tcp, branches);
    else
      solver_.solve_near(near(tcp), branches);
    for (const JointVector& branch : branches)
      append_turns(robot_, branch, Turns::all, inside, nullptr);
    return inside;
  }

  /// Whatever a seam to start from leaves to the torch: tilt and spin.
  static ToleranceSample near(const Pose& tcp) {
    ToleranceSample sample;
    sample.path_frame = tcp;
    sample.upper.tail<3>() = Eigen::Vector3d(kTravelAngle, kWorkAngle, kPi);
    sample.lower = -sample.upper;
    sample.box.upper = sample.upper;
    sample.box.upper[5] = ToleranceBox::kFree;
    sample.box.lower = -sample.box.upper;
    return sample;
  }

  bool can_follow(JointVector posture, const SeamPiece& seam, const Pose& turn) const {
    for (int i = 1; i < kPosesOnSeam; ++i) {
      const auto next = postures(seam.frame_at(static_cast<double>(i) / (kPosesOnSeam - 1)) * turn);
      const auto nearest =
          std::min_element(next.begin(), next.end(), [&](const auto& a, const auto& b) {
            return distance(a, posture) < distance(b, posture);
          });
      if (nearest == next.end() || distance(*nearest, posture) > kLongestStep) return false;
      posture = *nearest;
    }
    return true;
  }

  const Robot& robot_;
  const InverseKinematics& solver_;
};

}  // namespace

double arc_radius(const SeamPlace& place) { return rounded(place.length / place.angle, 1e-3); }

SeamPiece seam_piece(const SeamPlace& place, SeamShape shape) {
  const Pose torch = pose_from_xyz_rpy({0, 0, 0}, {0, place.torch_down ? kPi : 0, 0});
  const auto frame_at = [&](const Eigen::Vector3d& position) {
    return Pose(place.frame * Eigen::Translation3d(position) * torch);
  };
  SeamPiece piece;
  piece.end_time = 1;
  if (shape == SeamShape::line) {
    const Eigen::Vector3d half = 0.5 * place.length * Eigen::Vector3d::Unit(place.axis);
    piece.from = frame_at(-half);
    piece.to = frame_at(half);
    return piece;
  }
  piece.kind = SeamPiece::Kind::arc;
  piece.from = frame_at({-arc_radius(place), 0, 0});
  piece.center = place.frame.translation();
  piece.axis = -place.frame.linear().col(2);
  piece.angle = place.angle;
  piece.to = Eigen::Translation3d(piece.center) * Eigen::AngleAxisd(piece.angle, piece.axis) *
             Eigen::Translation3d(-piece.center) * piece.from;
  return piece;
}

std::vector<SeamPlace> reachable_places(const Robot& robot, const InverseKinematics& solver,
                                        SeamShape shape, std::size_t most) {
  const Reach reach = reach_of(robot);
  const double length = seam_length(reach);
  std::vector<SeamPlace> tried;
  if (solver.meets_every_pose())
    tried = robot.part_link() == robot.base_link() ? places_around(reach, length)
                                                   : places_on_part(length);
  const std::vector<SeamPlace> own = places_of_postures(robot, shape, length);
  tried.insert(tried.end(), own.begin(), own.end());

  const SeamReach asked(robot, solver);
  std::vector<SeamPlace> places;
  for (SeamPlace& place : tried) {
    if (places.size() == most) break;
    if (asked.reaches(place, shape)) places.push_back(place);
  }
  return places;
}

}  // namespace wristwise::app
