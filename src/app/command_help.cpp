#include "app/command_help.hpp"

namespace wristwise::app {

const std::vector<CommandHelp>& command_help() {
  static const std::vector<CommandHelp> all = {
      {"new",
       "Write a commented problem file to start from",
       "A file that plans at once: a seam where the robot reaches it, every section with units, "
       "defaults and a comment; change what is different in your cell.",
       {{"a line for the robot that ships", "wristwise new my_seam.yaml"},
        {"an arc for a robot of your own",
         "wristwise new my_arc.yaml --robot robots/seven_axis_arm/seven_axis_arm.urdf --seam arc"},
        {"then", "wristwise plan my_seam.yaml"}},
       {"problem-file.md", "robots.md"}},
      {"plan",
       "Plan a seam: a smooth, collision-free, checked joint trajectory",
       "Writes trajectory.csv, trajectory_dense.csv, result.json and report.html.",
       {{"past a wrist singularity", "wristwise plan problems/task_c_wrist_singularity.yaml"},
        {"with programs for KUKA and ABB",
         "wristwise plan problems/corner_stop.yaml --out out/corner --export krl,rapid"},
        {"the first stage alone",
         "wristwise plan problems/task_b_l_profile.yaml --mode graph-only --no-report"}},
       {"problem-file.md", "report.md", "exports.md"}},
      {"smooth",
       "Repair an existing joint path: recorded, taught or planned elsewhere",
       "Times are kept, the joints move; with a problem inside its tolerance, without one inside "
       "--keep.",
       {{"a recording, without a problem",
         "wristwise smooth --urdf robots/kuka_kr5_arc/kuka_kr5_arc_round_torch.urdf --limits "
         "robots/kuka_kr5_arc/joint_limits.yaml --joints problems/recorded_path.csv --keep "
         "0.5mm,0.5deg"},
        {"a path of the first stage, with its problem",
         "wristwise plan problems/corner_stop.yaml --mode graph-only --out out/graph && wristwise "
         "smooth problems/corner_stop.yaml --joints out/graph/trajectory.csv"}},
       {"smoothing.md"}},
      {"check",
       "Check any trajectory independently",
       "Tolerance, joint limits, clearance and speed between the rows too, from wherever the "
       "trajectory comes.",
       {{"what was planned",
         "wristwise plan problems/corner_stop.yaml --out out/corner && wristwise check "
         "problems/corner_stop.yaml out/corner/trajectory.csv"},
        {"for a script",
         "wristwise check problems/corner_stop.yaml out/corner/trajectory.csv --json"}},
       {"concepts.md"}},
      {"compare",
       "Graph-only beside two-stage",
       "Plans both ways and prints what the second stage gains; the report shows both.",
       {{"the wrist singularity", "wristwise compare problems/task_c_wrist_singularity.yaml"},
        {"without a report",
         "wristwise compare problems/planar_3r.yaml --out out/both --no-report"}},
       {"report.md"}},
      {"place",
       "Find where in a region the part or the robot should stand",
       "The region is the section placement of the problem file. Writes placement.json, a map, and "
       "the problem with the part where it should stand.",
       {{"the profile of task C",
         "wristwise place problems/task_c_wrist_singularity.yaml --out out/placed"},
        {"plan it there", "wristwise plan out/placed/problem_placed.yaml"}},
       {"placement.md"}},
      {"info",
       "Look at a robot description",
       "The chain, its limits, the inverse kinematics that was recognised, and what collides.",
       {{"an arm", "wristwise info robots/kuka_kr5_arc/kuka_kr5_arc.urdf"},
        {"with limits of acceleration and jerk",
         "wristwise info robots/kuka_kr5_arc/kuka_kr5_arc.urdf --limits "
         "robots/kuka_kr5_arc/joint_limits.yaml"},
        {"beside a positioner that carries the part",
         "wristwise info robots/kuka_kr5_arc_positioner/kuka_kr5_arc_positioner.urdf --part "
         "table"}},
       {"robots.md"}},
  };
  return all;
}

}  // namespace wristwise::app
