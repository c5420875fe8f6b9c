#pragma once

// A gantry that carries a ball and turns it about x. Its TCP is at (q0, q1, q2), turned by q3:
// tasks on it have answers that can be written down.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "wristwise/clearance.hpp"
#include "wristwise/seam.hpp"
#include "wristwise/trajectory.hpp"

namespace wristwise::test::gantry {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kReach = 2;  // m

inline Joint slide(const std::string& name, const Eigen::Vector3d& axis) {
  return {name,   JointType::prismatic, Pose::Identity(), axis,      -kReach,
          kReach, kUnlimited,           kUnlimited,       kUnlimited};
}

inline Robot::Parts parts(double ball_radius = 0.05) {
  Robot::Parts result;
  result.name = "gantry";
  result.joints = {slide("x", Eigen::Vector3d::UnitX()), slide("y", Eigen::Vector3d::UnitY()),
                   slide("z", Eigen::Vector3d::UnitZ()), slide("tilt", Eigen::Vector3d::UnitX())};
  result.joints[3].type = JointType::revolute;
  result.joints[3].lower = -3;
  result.joints[3].upper = 3;
  result.links = {{"ball", 3, Pose::Identity(), {{Sphere{ball_radius}}}}};
  return result;
}

inline std::shared_ptr<const Robot> robot(const Robot::Parts& of = parts()) {
  return std::make_shared<const Robot>(of);
}

inline JointVector posture(double x, double y, double z, double tilt = 0) {
  JointVector q(4);
  q << x, y, z, tilt;
  return q;
}

/// Nothing but the ball and these objects.
inline std::shared_ptr<const ClearanceModel> clearance(std::shared_ptr<const Robot> of,
                                                       std::vector<SceneObject> objects = {},
                                                       double required = 0) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.find_permanent_contacts = false;
  scene.clearance = required;
  return std::make_shared<const ClearanceModel>(std::move(of), scene);
}

inline SceneObject obstacle(const Geometry& geometry, double x, double y, double z) {
  return {"obstacle", {{geometry, Pose(Eigen::Translation3d(x, y, z))}}};
}

inline ToleranceBox box(double position, double angle) {
  ToleranceBox result;
  result.upper << position, position, position, angle, angle, angle;
  result.lower = -result.upper;
  return result;
}

/// Straight lines through the given positions, in equal times, each cut into equal intervals.
inline Task task(const std::vector<Eigen::Vector3d>& corners, double duration,
                 int intervals_per_line, const ToleranceBox& tolerance) {
  Task result;
  std::vector<SeamPiece> pieces;
  const auto lines = static_cast<double>(corners.size() - 1);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    SeamPiece piece;
    piece.from.translation() = corners[i];
    piece.to.translation() = corners[i + 1];
    piece.start_time = duration * static_cast<double>(i) / lines;
    piece.end_time = duration * static_cast<double>(i + 1) / lines;
    pieces.push_back(piece);
  }
  result.seam = Seam(pieces);
  const int count = intervals_per_line * static_cast<int>(lines);
  for (int i = 0; i <= count; ++i) {
    Waypoint waypoint;
    waypoint.time = i == count ? duration : duration * i / count;
    waypoint.frame = result.seam.frame_at(waypoint.time);
    waypoint.tolerance = tolerance;
    result.waypoints.push_back(waypoint);
  }
  return result;
}

/// The postures that follow the seam exactly.
inline JointPath path_along(const Task& of) {
  JointPath path;
  for (const Waypoint& waypoint : of.waypoints) {
    const Eigen::Vector3d p = waypoint.frame.translation();
    path.times.push_back(waypoint.time);
    path.positions.push_back(posture(p.x(), p.y(), p.z()));
  }
  return path;
}

}  // namespace wristwise::test::gantry
