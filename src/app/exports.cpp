#include "app/exports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise::app {

namespace {

ProgramFormat find_format(const std::string& name) {
  std::vector<std::string> names;
  for (const ProgramFormat format : program_formats()) names.push_back(format_name(format));
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InvalidInput("--export", "unknown format '" + name + "'",
                       "one of krl, rapid, ls, trajectory_msgs, moveit; the nearest is " +
                           similar_names(name, names, 1));
  return program_formats()[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace

std::vector<ProgramFormat> export_formats(const std::vector<std::string>& names) {
  std::vector<ProgramFormat> formats;
  for (const std::string& list : names) {
    std::istringstream parts(list + ",");
    std::string name;
    while (std::getline(parts, name, ',')) {
      const ProgramFormat format = find_format(name);
      if (std::find(formats.begin(), formats.end(), format) == formats.end())
        formats.push_back(format);
    }
  }
  return formats;
}

void check_exports(const std::vector<ProgramFormat>& formats, const Problem& problem) {
  for (const ProgramFormat format : formats) check_export(format, problem);
}

std::string write_exports(const std::vector<ProgramFormat>& formats,
                          const std::filesystem::path& folder, const PlanResult& result,
                          const Problem& problem) {
  std::string text;
  for (const ProgramFormat format : formats) {
    const std::filesystem::path file = write_program(format, folder, result, problem);
    text += file.empty() ? fmt::format("no {} file: not solved\n", format_name(format))
                         : fmt::format("exported {}\n", file.string());
  }
  return text;
}

}  // namespace wristwise::app
