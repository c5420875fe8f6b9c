#include <algorithm>

#include "import/program_move.hpp"

namespace wristwise {

AxisValues all_percent(double percent) {
  AxisValues values;
  values.fill(percent);
  return values;
}

std::optional<ProgramMoves> read_moves(const std::filesystem::path& file, int j3_coupling) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  if (extension == ".src") return read_krl(file);
  if (extension == ".mod" || extension == ".prg" || extension == ".modx") return read_rapid(file);
  if (extension == ".ls") return read_ls(file, j3_coupling);
  return std::nullopt;
}

}  // namespace wristwise
