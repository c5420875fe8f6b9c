#include "app/pictures.hpp"

#include <fmt/format.h>

#include "picture/motion_picture.hpp"

namespace wristwise::app {

std::string write_pictures(bool asked_for, const std::filesystem::path& folder,
                           const Problem& problem, const PlanResult& result,
                           const PlanResult* graph_only) {
  if (!asked_for) return {};
  const auto names = write_motion_pictures(folder, problem, result, graph_only);
  if (names.empty()) return "no pictures: there is no motion\n";
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("picture {}\n", (folder / name).string());
  return text;
}

}  // namespace wristwise::app
