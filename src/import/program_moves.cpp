#include "import/file_extension.hpp"
#include "import/program_move.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

enum class Language { krl, rapid, ls };

std::optional<Language> language_of(const std::filesystem::path& file) {
  const std::string extension = file_extension(file);
  if (extension == ".src") return Language::krl;
  if (extension == ".mod" || extension == ".prg") return Language::rapid;
  if (extension == ".ls") return Language::ls;
  return std::nullopt;
}

}  // namespace

AxisValues all_percent(double percent) {
  AxisValues values;
  values.fill(percent);
  return values;
}

bool is_program(const std::filesystem::path& file) { return language_of(file).has_value(); }

ProgramMoves read_moves(const std::filesystem::path& file, int j3_coupling) {
  const auto language = language_of(file);
  if (!language)
    throw InvalidInput(file.string(), "the extension '" + file.extension().string() + "'",
                       "a program: .src, .mod, .prg or .ls");
  switch (*language) {
    case Language::krl:
      return read_krl(file);
    case Language::rapid:
      return read_rapid(file);
    case Language::ls:
      break;
  }
  return read_ls(file, j3_coupling);
}

}  // namespace wristwise
