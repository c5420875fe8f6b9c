#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/settings.hpp"
#include "wristwise/plan.hpp"

// The commands of the program. Each returns the exit status and throws InvalidInput.
namespace wristwise::app {

struct PlanCommand {
  std::filesystem::path problem;
  std::string mode = "two-stage";
  std::filesystem::path out;  ///< empty: out/<problem>
  std::vector<std::string> exports;
  bool no_report = false;
  bool plot = false;
};
int run_plan(const PlanCommand& command, const Settings& settings);

struct SmoothCommand {
  std::filesystem::path problem;  ///< empty: none, but a robot and what to keep
  std::filesystem::path joints;
  std::filesystem::path out;  ///< empty: out/<problem>, or out/<joints>
  std::string smoothing_time;
  std::filesystem::path urdf;
  std::string base_link, part_link, tip_link;
  std::filesystem::path limits;
  std::string keep;  ///< "0.5mm,0.5deg"
  bool no_self_collision = false;
  std::vector<std::string> exports;
  bool no_report = false;
  bool plot = false;
};
int run_smooth(const SmoothCommand& command, const Settings& settings);

struct CheckCommand {
  std::filesystem::path problem;
  std::filesystem::path trajectory;
  bool json = false;
};
int run_check(const CheckCommand& command, const Settings& settings);

struct CompareCommand {
  std::filesystem::path problem;
  std::filesystem::path out;
  bool no_report = false;
  bool plot = false;
};
int run_compare(const CompareCommand& command, const Settings& settings);

struct PlaceCommand {
  std::filesystem::path problem;
  std::filesystem::path out;  ///< empty: out/<problem>
};
int run_place(const PlaceCommand& command, const Settings& settings);

struct InfoCommand {
  std::filesystem::path urdf;
  std::string base_link, part_link, tip_link;
  std::filesystem::path limits, srdf;
  std::string group;
  std::vector<std::filesystem::path> packages;
  std::string collision_from = "collision";
};
int run_info(const InfoCommand& command, const Settings& settings);

struct NewCommand {
  std::filesystem::path file;  ///< "-": stdout
  bool force = false;
  std::filesystem::path urdf;  ///< empty: the robot that ships
  std::string base_link, part_link, tip_link;
  std::filesystem::path limits;  ///< empty: joint_limits.yaml beside the URDF, where there is one
  std::string seam = "line";     ///< line, arc or csv
};
int run_new(const NewCommand& command, const Settings& settings);

}  // namespace wristwise::app
