// Stage 2 against NLopt's SLSQP on small problems: the same formulation, written down a second time
// (tests/spline_oracle.hpp), from the same seed, ends at the same cost.

#include <gtest/gtest.h>

#include "kuka_kr5_arc.hpp"
#include "spline_oracle.hpp"
#include "temporary_folder.hpp"
#include "wristwise/wristwise.hpp"

namespace wristwise {
namespace {

namespace kr5 = test::kr5;
namespace oracle = test::oracle;

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kEpsilon = 1e-5;     // m, RefineOptions::clearance_epsilon
constexpr double kRateMargin = 1e-3;  // of the limit, by which rates are kept inside (F15)
constexpr int kIntervals = 8;         // between waypoints, each a span of the curve
constexpr int kClearancePerInterval = 8;

std::vector<double> equal_times(double duration, int intervals) {
  std::vector<double> times;
  for (int i = 0; i <= intervals; ++i) times.push_back(duration * i / intervals);
  return times;
}

Eigen::MatrixXd columns(const JointPath& path) {
  Eigen::MatrixXd postures(path.positions.front().size(), static_cast<Eigen::Index>(path.size()));
  for (Eigen::Index i = 0; i < postures.cols(); ++i) {
    postures.col(i) = path.positions[static_cast<std::size_t>(i)];
  }
  return postures;
}

/// The integral of |q'|^2 + tau^2 |q''|^2 + tau^4 |q'''|^2 of a trajectory, by the midpoint rule.
double objective_of(const Trajectory& trajectory, double duration, double tau) {
  constexpr int kSteps = 6000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = duration * (i + 0.5) / kSteps;
    for (int k = 1; k <= 3; ++k) {
      sum += std::pow(tau, 2 * (k - 1)) * trajectory.evaluate(t, k).squaredNorm();
    }
  }
  return sum * duration / kSteps;
}

double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                           const Eigen::Vector3d& to) {
  const Eigen::Vector3d along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - share * along).norm();
}

/// A problem, its seed, and the same in the oracle's words.
struct Example {
  Problem problem;
  JointPath seed;
  oracle::Formulation formulation;
  double duration = 0;  ///< s

  PlanResult wristwise() const { return smooth(problem, seed); }
  oracle::Solution nlopt() const {
    oracle::Solver solver(formulation);
    return solver.solve(solver.fit(seed.times, columns(seed)));
  }
};

std::vector<Eigen::VectorXd> rate_limits(const Robot& robot) {
  return {(1 - kRateMargin) * robot.velocity_limits(),
          (1 - kRateMargin) * robot.acceleration_limits(), (1 - kRateMargin) * robot.jerk_limits()};
}

oracle::Formulation formulation(const Problem& problem, double duration) {
  oracle::Formulation result{oracle::Basis(equal_times(duration, kIntervals)),
                             problem.refine.smoothing_time,
                             {},
                             {},
                             problem.robot->lower_limits(),
                             problem.robot->upper_limits(),
                             rate_limits(*problem.robot)};
  return result;
}

void expect_same_optimum(const Example& example, const PlanResult& result,
                         const oracle::Solution& solution) {
  ASSERT_EQ(result.status, Status::solved)
      << (result.diagnosis.empty() ? "" : result.diagnosis.front().detail);
  ASSERT_EQ(result.refine.control_points, example.formulation.basis.count());
  EXPECT_LT(result.refine.max_violation, 1e-6);
  EXPECT_LT(solution.violation, 1e-6);
  const double ours =
      objective_of(result.trajectory, example.duration, example.formulation.smoothing_time);
  EXPECT_NEAR(ours, solution.objective, 1e-3 * solution.objective);
  EXPECT_NEAR(result.refine.objective, ours, 1e-5 * ours);
  const JointVector middle = result.trajectory.evaluate(0.4 * example.duration);
  const Eigen::VectorXd theirs =
      solution.control * example.formulation.basis.at(0.4 * example.duration, 0);
  EXPECT_LT((middle - theirs).norm(), 1e-2);
}

// --- KUKA KR 5 arc: torch down along y, a ball beside it that the torch must lean away from.

constexpr double kTorch = 0.3;  // m
const Eigen::Vector3d kKukaBall(0.975, 0.03, 0.45);

std::string kuka_text() {
  const std::string robot = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  return "robot:\n  urdf: " + robot +
         "kuka_kr5_arc_round_torch.urdf\n  base_link: base_link\n  tip_link: torch_tip\n"
         "  limits: " +
         robot +
         "joint_limits.yaml\n"
         "scene:\n  collision: {pairs: [[torch, ball]]}\n"
         "  objects: [{name: ball, sphere: 0.05, xyz: [0.975, 0.03, 0.45]}]\n"
         "  clearance: 0.02\n"
         "path:\n  speed: 0.01\n  waypoints: 9\n"
         "  segments:\n    - line: {from: {xyz: [0.9, -0.12, 0.3], rpy: [0, 180 deg, 0]},\n"
         "             to: {xyz: [0.9, 0.12, 0.3], rpy: [0, 180 deg, 0]}}\n"
         "  tolerance: {rx: 10 deg, ry: 10 deg, rz: free, between: [0.1, 45 deg]}\n"
         "graph: {samples: {rz: 5 deg}}\n";
}

/// Position, and the angles of R = Rx(alpha) Ry(beta) Rz(gamma), in the path frame at time t.
struct KukaDeviation {
  Eigen::Vector3d position;
  double alpha, beta;

  KukaDeviation(double t, const Eigen::VectorXd& q) {
    const Eigen::Matrix4d tip = kr5::torch_tip(q, kTorch);
    const Eigen::Vector3d down(-1, 1, -1);  // the diagonal of the path frame
    const Eigen::Vector3d nominal(0.9, -0.12 + 0.01 * t, 0.3), at = tip.topRightCorner<3, 1>();
    position = down.cwiseProduct(at - nominal);
    const Eigen::Vector3d z = down.cwiseProduct(Eigen::Vector3d(tip.block<3, 1>(0, 2)));
    beta = std::asin(z.x());
    alpha = std::atan2(-z.y(), z.z());
  }
};

double kuka_clearance(const Eigen::VectorXd& q) {
  const Eigen::Vector3d from = kr5::tool0(q).topRightCorner<3, 1>();
  const Eigen::Vector3d to = kr5::torch_tip(q, kTorch).topRightCorner<3, 1>();
  return distance_to_segment(kKukaBall, from, to) - 0.05 - 0.02;
}

Example kuka(const test::TemporaryFolder& folder) {
  Problem problem = load_problem(folder.write("kuka.yaml", kuka_text()));
  problem.refine.clearance_epsilon = kEpsilon;
  const double duration = problem.task.seam.end_time();
  problem.refine.knot_spacing = duration / kIntervals;
  Problem without_ball = problem;
  without_ball.scene.scope = CollisionScope::off;
  JointPath seed = plan_graph_only(without_ball).path;

  oracle::Formulation f = formulation(problem, duration);
  for (const double t : seed.times) {
    f.zero.push_back({t, [t](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                        return KukaDeviation(t, q).position;
                      }});
    f.not_positive.push_back({t, [t](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                                const KukaDeviation e(t, q);
                                return Eigen::Vector4d(e.alpha, -e.alpha, e.beta, -e.beta).array() -
                                       10 * kDegree;
                              }});
  }
  for (const double t : equal_times(duration, kClearancePerInterval * kIntervals)) {
    f.not_positive.push_back({t, [](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                                return Eigen::VectorXd::Constant(
                                    1, 0.02 + kEpsilon - kuka_clearance(q));
                              }});
  }
  return {std::move(problem), std::move(seed), std::move(f), duration};
}

TEST(NloptCrossCheck, KukaLeansAwayFromABall) {
  const test::TemporaryFolder folder;
  const Example example = kuka(folder);
  double seed_clearance = 1;
  for (const JointVector& q : example.seed.positions) {
    seed_clearance = std::min(seed_clearance, kuka_clearance(q));
  }
  EXPECT_LT(seed_clearance, 0.01);  // the ball matters
  const oracle::Solution solution = example.nlopt();
  EXPECT_GT(solution.active_stations, 0);
  expect_same_optimum(example, example.wristwise(), solution);
}

// --- A planar arm of three joints: redundant, as its tool may turn; limits of joints and rates.

constexpr double kUpperArm = 0.6, kForearm = 0.5, kTool = 0.2;  // m
constexpr double kLargestAngle = 60 * kDegree;                  // of the tool; the least is zero
constexpr double kPlanarDuration = 12;                          // s
constexpr double kWrist = 0.04, kPeg = 0.05;                    // m, radii
const Eigen::Vector3d kPegCentre(0.43, 0, 0);
constexpr double kNone = std::numeric_limits<double>::infinity();

struct PlanarPose {
  Eigen::Vector3d wrist, tip;
  double angle;

  explicit PlanarPose(const Eigen::VectorXd& q) {
    const double a = q[0], b = a + q[1];
    angle = b + q[2];
    wrist = {kUpperArm * std::cos(a) + kForearm * std::cos(b),
             kUpperArm * std::sin(a) + kForearm * std::sin(b), 0};
    tip = wrist + kTool * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  }
};

Eigen::Vector3d planar_seam(double t) { return {0.7, -0.3 + 0.6 * t / kPlanarDuration, 0}; }

/// Closed form, elbow to the left, tool at the angle gamma.
JointVector planar_posture(double t, double gamma) {
  const Eigen::Vector3d wrist =
      planar_seam(t) - kTool * Eigen::Vector3d(std::cos(gamma), std::sin(gamma), 0);
  const double r = wrist.norm();
  const double elbow =
      std::acos((r * r - kUpperArm * kUpperArm - kForearm * kForearm) / (2 * kUpperArm * kForearm));
  JointVector q(3);
  q[0] = std::atan2(wrist.y(), wrist.x()) -
         std::atan2(kForearm * std::sin(elbow), kUpperArm + kForearm * std::cos(elbow));
  q[1] = elbow;
  q[2] = gamma - q[0] - q[1];
  return q;
}

struct PlanarRates {
  double velocity, acceleration, jerk;  ///< rad/s^k, of every joint
};

std::shared_ptr<const Robot> planar_robot(const PlanarRates& limits) {
  Robot::Parts parts;
  parts.name = "planar";
  const double before[] = {0, kUpperArm, kForearm};
  for (const char* name : {"shoulder", "elbow", "wrist"}) {
    Joint joint;
    joint.name = name;
    joint.origin.translation().x() = before[parts.joints.size()];
    joint.lower = -3;
    joint.upper = 3;
    joint.max_velocity = limits.velocity;
    joint.max_acceleration = limits.acceleration;
    joint.max_jerk = limits.jerk;
    parts.joints.push_back(joint);
  }
  parts.tcp.translation().x() = kTool;
  parts.links = {{"ball", 2, Pose::Identity(), {{Sphere{kWrist}}}}};
  return std::make_shared<const Robot>(parts);
}

Task planar_task() {
  SeamPiece piece;
  piece.from.translation() = planar_seam(0);
  piece.to.translation() = planar_seam(kPlanarDuration);
  piece.end_time = kPlanarDuration;
  Task task;
  task.seam = Seam({piece});
  task.between_position = 0.1;
  task.between_angle = 45 * kDegree;
  for (const double t : equal_times(kPlanarDuration, kIntervals)) {
    Waypoint waypoint;
    waypoint.time = t;
    waypoint.frame.translation() = planar_seam(t);
    waypoint.tolerance.upper[5] = kLargestAngle;
    task.waypoints.push_back(waypoint);
  }
  return task;
}

Example planar(const PlanarRates& limits) {
  Problem problem;
  problem.robot = planar_robot(limits);
  problem.scene.objects = {{"peg", {{Sphere{kPeg}, Pose(Eigen::Translation3d(kPegCentre))}}}};
  problem.scene.find_permanent_contacts = false;
  problem.scene.clearance = 0.02;
  problem.task = planar_task();
  problem.refine.smoothing_time = 2;
  problem.refine.clearance_epsilon = kEpsilon;
  problem.refine.knot_spacing = kPlanarDuration / kIntervals;
  JointPath seed;
  for (const Waypoint& waypoint : problem.task.waypoints) {
    seed.times.push_back(waypoint.time);
    seed.positions.push_back(planar_posture(waypoint.time, 30 * kDegree));
  }
  oracle::Formulation f = formulation(problem, kPlanarDuration);
  for (const double t : seed.times) {
    f.zero.push_back({t, [t](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                        return (PlanarPose(q).tip - planar_seam(t)).head<2>();
                      }});
    f.not_positive.push_back({t, [](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                                const double angle = PlanarPose(q).angle;
                                return Eigen::Vector2d(angle - kLargestAngle, -angle);
                              }});
  }
  for (const double t : equal_times(kPlanarDuration, kClearancePerInterval * kIntervals)) {
    f.not_positive.push_back({t, [](const Eigen::VectorXd& q) -> Eigen::VectorXd {
                                const double d =
                                    (PlanarPose(q).wrist - kPegCentre).norm() - kWrist - kPeg;
                                return Eigen::VectorXd::Constant(1, 0.02 + kEpsilon - d);
                              }});
  }
  return {std::move(problem), std::move(seed), std::move(f), kPlanarDuration};
}

TEST(NloptCrossCheck, PlanarArmPassesAPeg) {
  const Example example = planar({kNone, kNone, kNone});
  const oracle::Solution solution = example.nlopt();
  EXPECT_GT(solution.active_stations, 0);
  expect_same_optimum(example, example.wristwise(), solution);
}

TEST(NloptCrossCheck, PlanarArmAtItsSpeedLimit) {
  const Example example = planar({0.0815, kNone, kNone});
  const oracle::Solution solution = example.nlopt();
  EXPECT_GT(solution.active_rates, 0);
  expect_same_optimum(example, example.wristwise(), solution);
}

TEST(NloptCrossCheck, PlanarArmAtItsAccelerationLimit) {
  const Example example = planar({kNone, 0.0065, kNone});
  const oracle::Solution solution = example.nlopt();
  EXPECT_GT(solution.active_rates, 0);
  expect_same_optimum(example, example.wristwise(), solution);
}

}  // namespace
}  // namespace wristwise
