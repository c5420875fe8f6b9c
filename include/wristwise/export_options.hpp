#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wristwise/visibility.hpp"

namespace WRISTWISE_PUBLIC wristwise {

/// Where a joint of the chain is on the robot controller:
/// axis value = sign * joint value + offset, in deg for turning, in mm for sliding joints.
struct ControllerAxis {
  int number = 0;     ///< 0 to 5: axes 1 to 6 of the robot; 6 to 11: external axes E1 to E6
  double sign = 1;    ///< 1 or -1
  double offset = 0;  ///< rad or m
};

/// How a trajectory becomes a program of a robot controller (docs/exports.md).
struct ExportOptions {
  std::string name;  ///< of the program; empty: that of the problem
  /// One for each joint of the chain. Empty: turning joints are A1, A2, ..., sliding ones E1, ...
  std::vector<ControllerAxis> axes;
  /// Points are left out as long as straight joint-space moves at constant rates stay within this
  /// distance (m) and angle (rad) of the TCP's pose on the curve, at every time.
  double max_deviation = 5e-5;
  double max_angle_deviation = 0.05 * 0.017453292519943295;  ///< rad, see max_deviation
  std::optional<double> period;  ///< s; given: a point every period instead
  double approach_percent = 10;  ///< of the joint speeds, on the way to the first point; 1 to 100
  bool weld = true;              ///< false: no commands to weld

  /// What a KUKA controller needs to know.
  struct Krl {
    int tool = 1;                            ///< number of TOOL_DATA
    int base = 0;                            ///< number of BASE_DATA
    std::string weld_on = "$OUT[1]=TRUE";    ///< one statement
    std::string weld_off = "$OUT[1]=FALSE";  ///< one statement
  };
  Krl krl;  ///< of the KUKA program

  /// What an ABB controller needs to know.
  struct Rapid {
    std::string tool = "tool0";                               ///< name of the tooldata
    std::string wobj = "wobj0";                               ///< name of the wobjdata
    std::string zone = "z0";                                  ///< at all points but the last
    std::vector<std::string> weld_on = {"SetDO doWeld,1;"};   ///< lines
    std::vector<std::string> weld_off = {"SetDO doWeld,0;"};  ///< lines
  };
  Rapid rapid;  ///< of the ABB program

  /// What a Fanuc controller needs to know.
  struct Ls {
    int tool = 1;   ///< UTOOL_NUM
    int frame = 0;  ///< UFRAME_NUM
    int cnt = 100;  ///< 0 to 100, at all points but the last
    /// J3 on the controller = J3 + j3_coupling * J2; J3 measured from the upper arm, both with the
    /// controller's signs.
    int j3_coupling = -1;
    std::vector<std::string> weld_on = {"Arc Start[1]"};  ///< lines
    std::vector<std::string> weld_off = {"Arc End[1]"};   ///< lines
  };
  Ls ls;  ///< of the Fanuc program
};

}  // namespace wristwise
