// A problem built in code, without a problem file: robot, scene and seam.
//
// A bead on a plate, between a post that the torch has to lean away from, a gusset and a profile
// from CAD. All poses are in the frame of the robot's base link; m, rad, s.

#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <wristwise/wristwise.hpp>

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kPi = 180 * kDegree;

wristwise::Pose at(double x, double y, double z) {
  return wristwise::Pose(Eigen::Translation3d(x, y, z));
}

/// The chain of a URDF. The TCP is at the end of the wire, 25 mm beyond the tip link. Limits of
/// acceleration and jerk come from MoveIt's joint_limits.yaml.
std::shared_ptr<const wristwise::Robot> robot_from(const char* urdf, const char* limits) {
  wristwise::RobotSource source;
  source.urdf = urdf;  // or source.urdf_text, as ROS hands it over
  source.limits = limits;
  source.tip_link = "torch_tip";
  source.tool = at(0, 0, 0.025);
  return std::make_shared<const wristwise::Robot>(wristwise::load_robot(source));
}

/// A prism with a triangle for its base: 70 mm along x, 10 mm along y, 80 mm high.
wristwise::ConvexHull gusset() {
  return wristwise::convex_hull({{0, -0.005, 0},
                                 {0.07, -0.005, 0},
                                 {0, -0.005, 0.08},
                                 {0, 0.005, 0},
                                 {0.07, 0.005, 0},
                                 {0, 0.005, 0.08}},
                                "gusset");
}

/// A mesh in mm. Concave parts are cut into convex pieces that reach at most 2 mm beyond them.
wristwise::SceneObject profile(const char* mesh) {
  wristwise::MeshOptions options;
  options.convex_error = 0.002;
  const wristwise::MeshBody body =
      wristwise::load_mesh(mesh, Eigen::Vector3d::Constant(0.001), options);
  const wristwise::Pose pose = wristwise::pose_from_xyz_rpy({0.92, 0, 0.28}, {0, 0, kPi});
  wristwise::SceneObject object;
  object.name = "profile";
  for (const wristwise::ConvexHull& piece : body.pieces) object.shapes.push_back({piece, pose});
  return object;
}

/// An object has a name, and shapes that are each placed on their own.
wristwise::Scene scene_with(const char* mesh) {
  wristwise::Scene scene;
  scene.clearance = 0.004;
  scene.objects = {
      {"plate", {{wristwise::Box{{0.3, 0.4, 0.01}}, at(0.82, 0, 0.265)}}},
      {"post", {{wristwise::Cylinder{0.02, 0.2}, at(0.862, 0.05, 0.37)}}},
      {"gusset", {{gusset(), at(0.71, -0.1, 0.27)}}},
      profile(mesh),
  };
  return scene;
}

/// The seam: a line along y. z of its frame points along the torch, into the plate.
wristwise::Task task_for(const wristwise::Robot& robot) {
  const auto down = Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitY());
  wristwise::Segment bead;
  bead.shape = wristwise::LineSegment{at(0.82, -0.15, 0.27) * down, at(0.82, 0.15, 0.27) * down};
  // How far the TCP may be from the frame: x, y, z, rx, ry, rz. Work angle 10 deg, any spin.
  const double any = wristwise::ToleranceBox::kFree;
  bead.tolerance.upper << 0, 0, 0, 0, 10 * kDegree, any;
  bead.tolerance.lower = -bead.tolerance.upper;

  wristwise::SeamDescription seam;
  seam.segments = {bead};  // more segments join up: lines, arcs, poses, joint waypoints
  seam.speed = 0.01;
  seam.waypoints = 40;
  return build_task(robot, seam);
}

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  std::string link;
};

/// For each object the nearest link over all points of a path.
std::map<std::string, Nearest> nearest_links(const wristwise::Problem& problem,
                                             const wristwise::JointPath& path) {
  const auto model =
      std::make_shared<const wristwise::ClearanceModel>(problem.robot, problem.scene);
  wristwise::ClearanceChecker checker(model);  // one per thread
  std::map<std::string, Nearest> nearest;
  for (const wristwise::JointVector& q : path.positions) {
    checker.set_posture(q);
    for (int pair = 0; pair < static_cast<int>(model->pairs().size()); ++pair) {
      const auto [link, object] = model->names(pair);  // of two links: both are links
      Nearest& of = nearest[object];
      if (const double d = checker.distance(pair).distance; d < of.distance) of = {d, link};
    }
  }
  return nearest;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 5)
      throw wristwise::InvalidInput("usage", "ROBOT.urdf LIMITS.yaml PART.stl TRAJECTORY.csv");
    wristwise::Problem problem;
    problem.name = "bead_on_plate";
    problem.robot = robot_from(argv[1], argv[2]);
    problem.scene = scene_with(argv[3]);
    problem.task = task_for(*problem.robot);
    problem.graph.step << 0, 0, 0, 0, 2.5 * kDegree, 10 * kDegree;  // of the grid of stage 1

    const wristwise::PlanResult result = wristwise::plan(problem);
    for (const auto& diagnosis : result.diagnosis) std::cout << diagnosis.detail << '\n';
    if (result.trajectory.empty()) return 1;

    const auto nearest = nearest_links(problem, result.path);
    for (const wristwise::SceneObject& object : problem.scene.objects) {
      const Nearest& link = nearest.at(object.name);
      std::cout << object.name << ": " << 1000 * link.distance << " mm from " << link.link << '\n';
    }
    std::cout << "least clearance of all t: " << 1000 * result.verification.clearance.value()
              << " mm\n";
    write_trajectory(argv[4], problem.robot->joint_names(), result.trajectory);
    return result.status == wristwise::Status::solved ? 0 : 1;
  } catch (const wristwise::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
