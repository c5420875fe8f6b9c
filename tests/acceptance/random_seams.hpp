#pragma once

// The random test bed: welds for the KUKA KR 5 arc as problem files, one for each index. Lines,
// arcs and two lines that meet at a corner, at a random place in the cell, among random obstacles,
// with random tolerances; every third passes within 2 degrees of the wrist singularity half-way.
// Nothing of the library is used, so that the same index is the same text for ever.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <random>
#include <sstream>
#include <string>

#include "kuka_kr5_arc.hpp"

namespace wristwise::test::bed {

inline constexpr double kDegree = 3.14159265358979323846 / 180;
inline constexpr double kTorch = 0.38;  // m, from tool0 to the TCP

/// The same numbers with every compiler and standard library.
class Random {
 public:
  explicit Random(int index) : engine_(static_cast<std::uint64_t>(index) * 7919 + 20170912) {}

  double between(double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  bool chance(double probability) { return between(0, 1) < probability; }
  int whole(int lower, int upper) {
    return lower + static_cast<int>(between(0, upper - lower + 1));
  }
  double sign() { return chance(0.5) ? 1 : -1; }

 private:
  std::mt19937_64 engine_;
};

enum class Kind { line, arc, corner };

inline std::string name_of(Kind kind) {
  return kind == Kind::line ? "line" : kind == Kind::arc ? "arc" : "corner";
}

struct RandomSeam {
  int index = 0;
  Kind kind = Kind::line;
  bool singular = false;         ///< joint 5 within 2 degrees of zero half-way, torch as drawn
  Eigen::VectorXd posture;       ///< rad, half-way, torch as drawn
  Eigen::Isometry3d middle;      ///< path frame half-way, in the base
  double length = 0, speed = 0;  ///< m, m/s
  std::string problem;           ///< YAML
};

/// A posture that holds the torch downwards over the floor in front of the robot.
inline Eigen::VectorXd working_posture(Random& random, bool singular) {
  Eigen::VectorXd q(6);
  for (;;) {
    q << random.between(-70, 70), random.between(-130, 0), random.between(0, 150),
        random.between(-120, 120),
        singular ? random.between(-2, 2) : random.sign() * random.between(15, 100),
        random.between(-180, 180);
    q *= kDegree;
    const Eigen::Matrix4d tip = kr5::torch_tip(q, kTorch);
    const Eigen::Vector3d at = tip.topRightCorner<3, 1>();
    const double reach = at.head<2>().norm(), wrist_height = kr5::link_frame(q, 5)(2, 3);
    const bool points_down = tip(2, 2) < -0.3;
    if (points_down && at.z() > 0.1 && at.z() < 1.1 && reach > 0.5 && reach < 1.3 &&
        wrist_height > 0.25) {
      return q;
    }
  }
}

/// Roll, pitch and yaw about fixed axes, as in URDF.
inline Eigen::Vector3d rpy(const Eigen::Matrix3d& r) {
  return {std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2))),
          std::atan2(r(1, 0), r(0, 0))};
}

inline std::string text(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out << std::setprecision(12) << '[' << v.x() << ", " << v.y() << ", " << v.z() << ']';
  return out.str();
}

inline std::string text(const Eigen::Isometry3d& pose) {
  return "{xyz: " + text(Eigen::Vector3d(pose.translation())) +
         ", rpy: " + text(rpy(pose.linear())) + "}";
}

inline Eigen::Isometry3d placed(const Eigen::Vector3d& xyz, const Eigen::Matrix3d& turn) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = xyz;
  pose.linear() = turn;
  return pose;
}

inline Eigen::Vector3d direction(Random& random) {
  const double z = random.between(-1, 1), angle = random.between(-180, 180) * kDegree;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

inline Eigen::Matrix3d turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

inline std::string line(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  return "    - line: {from: " + text(from) + ", to: " + text(to) + "}\n";
}

/// The segments in the frame half-way: y along the weld, z along the torch.
inline std::string segments(const RandomSeam& seam, Random& random) {
  const double half = 0.5 * seam.length;
  if (seam.kind == Kind::arc) {
    const double radius = random.between(0.5, 3) * seam.length;
    const Eigen::Vector3d center(random.sign() * radius, 0, 0), z = Eigen::Vector3d::UnitZ();
    const double angle = (center.x() > 0 ? -1 : 1) * seam.length / radius;
    const Eigen::Matrix3d back = turn(z, -0.5 * angle);
    std::ostringstream out;
    out << std::setprecision(12)
        << "    - arc: {from: " << text(placed(center - back * center, back))
        << ", center: " << text(center) << ", axis: [0, 0, 1], angle: " << angle << "}\n";
    return out.str();
  }
  if (seam.kind == Kind::corner) {
    const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
    const Eigen::Isometry3d corner = placed(Eigen::Vector3d::Zero(), same);
    const double angle = random.sign() * random.between(20, 90) * kDegree;
    const Eigen::Vector3d end(half * std::sin(angle), half * std::cos(angle), 0);
    return line(placed({0, -half, 0}, same), corner) + line(corner, placed(end, same));
  }
  const Eigen::Vector3d axis = direction(random);
  const double angle = random.chance(0.5) ? random.between(0, 20) * kDegree : 0;
  return line(placed({0, -half, 0}, turn(axis, -0.5 * angle)),
              placed({0, half, 0}, turn(axis, 0.5 * angle)));
}

inline std::string tolerances(const RandomSeam& seam, Random& random) {
  std::ostringstream out;
  out << std::setprecision(6) << "  tolerance: {";
  // A corner is rounded inside the box.
  if (seam.kind == Kind::corner) {
    out << "x: 2 mm, y: 2 mm, ";
  } else if (random.chance(0.2)) {
    out << "x: " << random.between(0.5, 2) << " mm, ";
  }
  if (random.chance(0.2)) out << "z: [-2 mm, " << random.between(0.5, 4) << " mm], ";
  for (const char* tilt : {"rx", "ry"}) {
    if (random.chance(0.75)) out << tilt << ": " << random.between(1, 20) << " deg, ";
  }
  if (random.chance(0.6)) {
    out << "rz: free}\n";
  } else {
    out << "rz: " << random.between(5, 60) << " deg}\n";
  }
  return out.str();
}

inline std::string shape(double size, Random& random) {
  std::ostringstream out;
  out << std::setprecision(6);
  switch (random.whole(0, 2)) {
    case 0:
      out << "box: "
          << text(Eigen::Vector3d(size, random.between(0.3, 2) * size,
                                  random.between(0.1, 1) * size));
      break;
    case 1:
      out << "sphere: " << 0.5 * size;
      break;
    default:
      out << "cylinder: [" << random.between(0.2, 0.5) * size << ", " << size << "]";
  }
  return out.str();
}

/// A plate that is welded on, in one cell of two, and up to three things beside the seam: some near
/// enough to be in the torch's way.
inline std::string objects(const RandomSeam& seam, Random& random) {
  std::string list;
  if (random.chance(0.5)) {
    const Eigen::Vector3d below(0, 0, 0.006);
    list += "    - {name: part, box: [0.25, " + std::to_string(seam.length + 0.1) +
            ", 0.01], xyz: " + text(Eigen::Vector3d(seam.middle * below)) +
            ", rpy: " + text(rpy(seam.middle.linear())) + "}\n";
  }
  const int count = random.whole(0, 3);
  for (int i = 0; i < count; ++i) {
    const double size = random.between(0.02, 0.12);
    const double gap = random.chance(0.3) ? random.between(0.005, 0.03) : random.between(0.03, 0.2);
    const Eigen::Vector3d at(random.sign() * (0.5 * size + gap),
                             random.between(-0.5, 0.5) * seam.length, random.between(-0.2, 0));
    list += "    - {name: object_" + std::to_string(i + 1) + ", " + shape(size, random) +
            ", xyz: " + text(Eigen::Vector3d(seam.middle * at)) +
            ", rpy: " + text(180 * kDegree * direction(random)) + "}\n";
  }
  return list.empty() ? "" : "  objects:\n" + list;
}

inline std::string problem_text(const RandomSeam& seam, Random& random) {
  const std::string robot = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  std::ostringstream out;
  out << std::setprecision(6) << "# Random seam " << seam.index << ": " << name_of(seam.kind)
      << (seam.singular ? ", past the wrist singularity" : "") << "\nrobot:\n  urdf: " << robot
      << "kuka_kr5_arc.urdf\n  base_link: base_link\n  tip_link: torch_tip\n  limits: " << robot
      << "joint_limits.yaml\nscene:\n  clearance: " << random.between(1, 8) << " mm\n"
      << objects(seam, random) << "path:\n  frame: " << text(seam.middle)
      << "\n  speed: " << seam.speed << "\n  waypoints: " << random.whole(25, 60)
      << "\n  segments:\n"
      << segments(seam, random) << tolerances(seam, random)
      << "graph: {automatic_samples: 400, try_relaxations: false}\n";
  return out.str();
}

inline RandomSeam random_seam(int index) {
  Random random(index);
  RandomSeam seam;
  seam.index = index;
  seam.kind =
      std::array{Kind::line, Kind::arc, Kind::corner}[static_cast<std::size_t>(random.whole(0, 2))];
  seam.singular = index % 3 == 0;
  seam.posture = working_posture(random, seam.singular);
  seam.middle.matrix() = kr5::torch_tip(seam.posture, kTorch);
  seam.length = random.between(0.08, 0.4);
  seam.speed = random.between(0.005, 0.015);
  seam.problem = problem_text(seam, random);
  return seam;
}

}  // namespace wristwise::test::bed
