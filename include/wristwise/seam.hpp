#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "wristwise/joint_box.hpp"
#include "wristwise/pose.hpp"
#include "wristwise/tolerance.hpp"
#include "wristwise/trajectory.hpp"
#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// A way from one frame to another that is neither straight nor a circular arc.
class SeamCurve {
 public:
  virtual ~SeamCurve() = default;
  virtual double length() const = 0;                 ///< m, of the TCP's path
  virtual Pose frame_at(double fraction) const = 0;  ///< base frame; a share of its time, 0 .. 1
};

/// One piece of the nominal TCP path, run in a given time.
struct SeamPiece {
  /// The shape of the piece.
  enum class Kind {
    line,   ///< straight, turning at a constant rate about one axis
    arc,    ///< the first pose turned rigidly about an axis
    move,   ///< to or from a joint waypoint: no path is prescribed between its ends
    curve,  ///< a rounded corner, a run-in or a run-out
  };
  Kind kind = Kind::line;                            ///< says which members below count
  Pose from = Pose::Identity();                      ///< path frame at the start, in base
  Pose to = Pose::Identity();                        ///< path frame at the end, in base
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< arc: a point on its axis, base frame, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< arc: unit, base frame
  double angle = 0;                                  ///< arc: rad, right-handed
  std::shared_ptr<const SeamCurve> curve;            ///< curve: not null
  double start_time = 0;                             ///< s
  double end_time = 0;                               ///< s

  double length() const;                 ///< m, of the TCP's path
  Pose frame_at(double fraction) const;  ///< path frame in base; fraction of its time, 0 .. 1
};

/// The nominal TCP path over time, in the base frame. Its pieces are timed by the clock of the
/// weld, the nominal time, which runs at weld speed. Where the seam is stood still on or run
/// slower, a time law gives the nominal time at each real time (F22); without one the two are the
/// same.
class Seam {
 public:
  Seam() = default;  ///< of no pieces, as a place to put one
  /// Pieces in order, each starting when the one before it ends.
  /// @throws InvalidInput for no pieces, gaps in time or values that are not finite.
  explicit Seam(std::vector<SeamPiece> pieces);

  /// In the order in which they are run, at nominal times.
  const std::vector<SeamPiece>& pieces() const { return pieces_; }
  double start_time() const;  ///< s, real
  double end_time() const;    ///< s, real
  double length() const;      ///< m, of the TCP's path

  /// The same pieces under another time law, in place of the one there was.
  /// @param seam_time one joint: nominal time, s, over real time, s
  /// @throws InvalidInput where it decreases, has more than one joint, or does not run from the
  /// first piece's start to the last one's end (to 1e-9 s).
  Seam retimed(const Trajectory& seam_time) const;
  /// Whether there is a time law.
  bool is_retimed() const { return !seam_time_.empty(); }
  const Trajectory& seam_time() const { return seam_time_; }  ///< empty: real time is nominal

  double nominal_time(double t) const;  ///< s, at real time t
  double real_time(
      double nominal) const;           ///< s, the earliest at which that nominal time is reached
  double speed_ratio(double t) const;  ///< rate of the nominal time: the speed as a share of the
                                       ///< piece's own

  /// The piece that is run at real time t; at a corner the piece that ends there.
  const SeamPiece& piece_at(double t) const;
  Pose frame_at(double t) const;  ///< path frame in base, at real time t

 private:
  const SeamPiece& piece_at_nominal(double nominal) const;

  std::vector<SeamPiece> pieces_;
  Trajectory seam_time_;
};

/// A point of the seam that the planner must pass.
struct Waypoint {
  double time = 0;                 ///< s
  Pose frame = Pose::Identity();   ///< path frame, in base; of a joint waypoint the nominal TCP
  ToleranceBox tolerance;          ///< also for the stretch that ends here
  std::optional<JointBox> joints;  ///< given: a joint waypoint; its tolerance is unused
  bool welding = true;             ///< false: of the run-in or the run-out
  std::optional<ToleranceBox> sampled;  ///< the part that stage 1 samples; not given: all
};

/// What to do where a joint can't keep up with the weld speed.
enum class SpeedPolicy {
  hold,  ///< keep the weld speed: no trajectory where the limits forbid it
  slow,  ///< run slower there
};

/// What is to be done: the seam, its waypoints and what is allowed between them.
struct Task {
  Seam seam;                        ///< all of it, run-in and run-out included
  std::vector<Waypoint> waypoints;  ///< two or more, their times strictly increasing
  double between_position = 1e-4;   ///< m, added to the box between waypoints
  double between_angle = 0.1 * 0.017453292519943295;  ///< rad, added to the box between waypoints

  SpeedPolicy speed_policy = SpeedPolicy::hold;  ///< where limits forbid the weld speed
  /// Velocity and acceleration of all joints are zero at the first, at the last waypoint's time.
  bool rest_at_start = false;
  bool rest_at_end = false;  ///< likewise

  double weld_start() const;  ///< s, when the first welding waypoint is passed
  double weld_end() const;    ///< s, when the last one is

  /// The same waypoints at the times at which the retimed seam passes them (see Seam::retimed).
  /// @throws InvalidInput as Seam::retimed, or where two waypoints fall on one time.
  Task retimed(const Trajectory& seam_time) const;

  /// The same seam with waypoints at other times (s), for the repair of a joint path.
  /// @throws InvalidInput where times do not increase or leave the seam by more than 1e-6 s.
  Task with_waypoints_at(const std::vector<double>& times) const;

  /// The box, not widened yet, that holds between waypoints `interval` and `interval` + 1: that of
  /// the second of them, or of the run-in where it comes from there; nullopt
  /// where no path is prescribed (a move to or from a joint waypoint).
  std::optional<ToleranceBox> tolerance_between(std::size_t interval) const;
};

/// @throws InvalidInput where a joint waypoint does not fit the robot (see cut_to_limits).
void validate_joint_waypoints(const Task& task, const Robot& robot);

}  // namespace wristwise
