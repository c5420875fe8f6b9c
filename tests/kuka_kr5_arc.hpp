#pragma once

// The KUKA KR 5 arc as data and as plain matrix products, sharing nothing with the library.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <memory>

#include "wristwise/urdf.hpp"

namespace wristwise::test::kr5 {

struct Row {
  Eigen::Vector3d xyz, rpy;
  double lower_deg, upper_deg, velocity_deg;
};

inline std::array<Row, 6> table() {
  const double h = std::acos(0.0);
  return {Row{{0, 0, 0.4}, {2 * h, 0, 0}, -155, 155, 154},
          Row{{0.18, 0, 0}, {h, 0, 0}, -180, 65, 154},
          Row{{0.6, 0, 0}, {0, 0, 0}, -15, 158, 228},
          Row{{0, -0.12, 0}, {0, -h, 0}, -350, 350, 343},
          Row{{0, 0, -0.62}, {0, h, 0}, -130, 130, 384},
          Row{{0, 0, 0}, {0, -h, 0}, -350, 350, 721}};
}

inline Eigen::Matrix4d turn(int axis, double angle) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  m(a, a) = m(b, b) = std::cos(angle);
  m(b, a) = std::sin(angle);
  m(a, b) = -std::sin(angle);
  return m;
}

inline Eigen::Matrix4d shift(const Eigen::Vector3d& xyz) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topRightCorner<3, 1>() = xyz;
  return m;
}

inline Eigen::Matrix4d origin(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  return shift(xyz) * turn(2, rpy.z()) * turn(1, rpy.y()) * turn(0, rpy.x());
}

/// The frame of link `link` (1 to 6) at q.
inline Eigen::Matrix4d link_frame(const Eigen::VectorXd& q, int link) {
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  for (int j = 0; j < link; ++j) {
    const Row row = table()[static_cast<std::size_t>(j)];
    frame = frame * origin(row.xyz, row.rpy) * turn(2, q[j]);
  }
  return frame;
}

inline Eigen::Matrix4d tool0(const Eigen::VectorXd& q) {
  const double h = std::acos(0.0);
  return link_frame(q, 6) * origin({0, 0, -0.115}, {0, -2 * h, -h});
}

/// The TCP of a torch of the given length, tilted by 45 deg.
inline Eigen::Matrix4d torch_tip(const Eigen::VectorXd& q, double length) {
  return tool0(q) * turn(1, std::acos(0.0) / 2) * shift({0, 0, length});
}

inline RobotSource source(const std::string& file = "kuka_kr5_arc_round_torch.urdf") {
  const std::string folder = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
  RobotSource result;
  result.urdf = folder + file;
  result.base_link = "base_link";
  result.tip_link = "torch_tip";
  result.limits = folder + "joint_limits.yaml";
  return result;
}

inline std::shared_ptr<const Robot> load(
    const std::string& file = "kuka_kr5_arc_round_torch.urdf") {
  return std::make_shared<const Robot>(load_robot(source(file)));
}

}  // namespace wristwise::test::kr5
