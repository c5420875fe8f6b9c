#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "export/controller_axes.hpp"
#include "wristwise/pose.hpp"

namespace wristwise {

/// A move of a robot program: to values of the axes, or to a pose of the tool.
struct ProgramMove {
  bool linear = false;  ///< of the TCP; else of the joints
  std::optional<AxisValues> axes{};
  std::optional<Pose> pose{};  ///< m, in the base or work object of the program
  // How fast, as far as the program says; time before speed before percent.
  std::optional<double> time{};         ///< s
  std::optional<double> speed{};        ///< m/s, of the TCP
  std::optional<AxisValues> percent{};  ///< of the axes' speed limits
  std::string where;                    ///< file:line
};

using ProgramMoves = std::vector<ProgramMove>;

/// The same percentage for all axes.
AxisValues all_percent(double percent);

// Readers of each language: joint and linear moves. What else can move the robot, or change where,
// is not understood: @throws InvalidInput with file and line. Outputs, waits and comments are left
// out.

/// KRL; declarations also in the file of the same name with .dat, where there is one.
ProgramMoves read_krl(const std::filesystem::path& file);
ProgramMoves read_rapid(const std::filesystem::path& file);
/// @param j3_coupling see ExportOptions::Ls; taken out of the axes
ProgramMoves read_ls(const std::filesystem::path& file, int j3_coupling);

/// By the extension: .src, .mod, .prg or .ls.
bool is_program(const std::filesystem::path& file);
ProgramMoves read_moves(const std::filesystem::path& file, int j3_coupling);

}  // namespace wristwise
