#pragma once

#include <string>
#include <utility>
#include <vector>

#include "wristwise/geometry.hpp"
#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

enum class JointType { revolute, continuous, prismatic };

struct Joint {
  std::string name;
  JointType type = JointType::revolute;
  Pose origin = Pose::Identity();                   ///< at zero, in the previous joint's frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector in the joint's own frame
  double lower = 0;                                 ///< rad or m; -infinity if continuous
  double upper = 0;                                 ///< rad or m; +infinity if continuous
  double max_velocity = 0;      ///< rad/s or m/s; infinity where unknown (only for `info`)
  double max_acceleration = 0;  ///< rad/s^2 or m/s^2; infinity where the limits file gives none
  double max_jerk = 0;          ///< rad/s^3 or m/s^3; infinity where the limits file gives none
};

/// A link that carries collision shapes, fixed to the frame of the movable joint that moves it.
struct Link {
  std::string name;
  int joint = -1;                ///< index into joints; -1: fixed to the part's link
  Pose pose = Pose::Identity();  ///< of the link, in that joint's frame (base frame for -1)
  std::vector<Shape> collision;  ///< poses in the link frame; may be empty
};

/// A serial chain with its limits and collision geometry. An immutable value.
///
/// It runs from the link that carries the part to the TCP. Where the part stands still that is the
/// base link; where a positioner moves the part it is the positioner's last link, and the chain
/// leads through the positioner's joints, backwards, to what stands still and on through the arm.
/// *Base frame* means the frame of the chain's first link everywhere: seam, tolerance and weld
/// speed are then measured on the part.
class Robot {
 public:
  struct Parts {
    std::string name;
    std::string base_link;  ///< stands still; objects of the scene are placed in it
    std::string tip_link;
    std::vector<Joint> joints;
    std::vector<Link> links;
    Pose tcp = Pose::Identity();  ///< of the TCP, in the last joint's frame
    /// Indices into links of the pairs that a joint connects directly.
    std::vector<std::pair<int, int>> adjacent_links;
    std::vector<std::string> warnings;  ///< what the reader of the description should know
    std::string part_link = {};         ///< carries the part; empty: the base link
  };

  /// @throws InvalidInput for no joints, more than kMaxJoints, NaN, zero axes or inverted limits.
  explicit Robot(Parts parts);

  int joint_count() const { return static_cast<int>(parts_.joints.size()); }
  const Parts& parts() const { return parts_; }
  const std::string& name() const { return parts_.name; }
  const std::string& base_link() const { return parts_.base_link; }
  const std::string& tip_link() const { return parts_.tip_link; }
  /// The chain's first link.
  const std::string& part_link() const {
    return parts_.part_link.empty() ? parts_.base_link : parts_.part_link;
  }
  const std::vector<Joint>& joints() const { return parts_.joints; }
  const std::vector<Link>& links() const { return parts_.links; }
  const Link* find_link(const std::string& name) const;  ///< null where there is none
  const Pose& tcp() const { return parts_.tcp; }
  const std::vector<std::pair<int, int>>& adjacent_links() const { return parts_.adjacent_links; }
  const std::vector<std::string>& warnings() const { return parts_.warnings; }

  JointVector lower_limits() const;
  JointVector upper_limits() const;
  JointVector velocity_limits() const;
  JointVector acceleration_limits() const;
  JointVector jerk_limits() const;

 private:
  Parts parts_;
};

}  // namespace wristwise
