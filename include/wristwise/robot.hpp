#pragma once

#include <string>
#include <utility>
#include <vector>

#include "wristwise/geometry.hpp"
#include "wristwise/joints.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// How a joint moves.
enum class JointType {
  revolute,    ///< turns between limits
  continuous,  ///< turns without limits
  prismatic,   ///< slides between limits
};

/// A movable joint of the chain. It turns about, or slides along, `axis` in the positive sense of
/// the right-hand rule.
struct Joint {
  std::string name;                                 ///< as in the URDF
  JointType type = JointType::revolute;             ///< gives the unit of its value: rad or m
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
  std::string name;              ///< as in the URDF
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
  /// What a robot is made of.
  struct Parts {
    std::string name;             ///< of the robot, as in the URDF
    std::string base_link;        ///< stands still; objects of the scene are placed in it
    std::string tip_link;         ///< carries the TCP
    std::vector<Joint> joints;    ///< from the part's link to the tip; 1 to kMaxJoints
    std::vector<Link> links;      ///< those that may collide, in any order
    Pose tcp = Pose::Identity();  ///< of the TCP, in the last joint's frame
    /// Indices into links of the pairs that a joint connects directly.
    std::vector<std::pair<int, int>> adjacent_links;
    std::vector<std::string> warnings;  ///< what the reader of the description should know
    std::string part_link = {};         ///< carries the part; empty: the base link
  };

  /// @throws InvalidInput for no joints, more than kMaxJoints, NaN, zero axes or inverted limits.
  explicit Robot(Parts parts);

  /// n, the length of every JointVector of this robot.
  int joint_count() const { return static_cast<int>(parts_.joints.size()); }
  /// All that the robot was made of; the members below name its parts one by one.
  const Parts& parts() const { return parts_; }
  /// @copydoc Parts::name
  const std::string& name() const { return parts_.name; }
  /// @copydoc Parts::base_link
  const std::string& base_link() const { return parts_.base_link; }
  /// @copydoc Parts::tip_link
  const std::string& tip_link() const { return parts_.tip_link; }
  /// The chain's first link.
  const std::string& part_link() const {
    return parts_.part_link.empty() ? parts_.base_link : parts_.part_link;
  }
  /// @copydoc Parts::joints
  const std::vector<Joint>& joints() const { return parts_.joints; }
  /// @copydoc Parts::links
  const std::vector<Link>& links() const { return parts_.links; }
  const Link* find_link(const std::string& name) const;  ///< null where there is none
  /// @copydoc Parts::tcp
  const Pose& tcp() const { return parts_.tcp; }
  /// @copydoc Parts::adjacent_links
  const std::vector<std::pair<int, int>>& adjacent_links() const { return parts_.adjacent_links; }
  /// @copydoc Parts::warnings
  const std::vector<std::string>& warnings() const { return parts_.warnings; }

  std::vector<std::string> joint_names() const;  ///< in chain order
  JointVector lower_limits() const;              ///< rad or m; -infinity for continuous joints
  JointVector upper_limits() const;              ///< rad or m; +infinity for continuous joints
  JointVector velocity_limits() const;           ///< rad/s or m/s, of either sign
  JointVector acceleration_limits() const;       ///< rad/s^2 or m/s^2; infinity where there is none
  JointVector jerk_limits() const;               ///< rad/s^3 or m/s^3; infinity where there is none

 private:
  Parts parts_;
};

}  // namespace wristwise
