#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/input_file.hpp"
#include "wristwise/plan.hpp"

namespace wristwise {

/// What a report is made of.
struct ReportContents {
  const Problem& problem;
  const PlanResult& result;
  const PlanResult* graph_only = nullptr;  ///< to compare with; null: the seed, or the given path
  std::vector<InputFile> inputs;
};

/// The data of the page as JSON (docs/report.md), without '<', so that no name in it ends a script.
std::string report_data(const ReportContents& contents);

/// One self-contained page.
std::string report_html(const ReportContents& contents);

/// Writes folder/report.html.
void write_report(const std::filesystem::path& folder, const ReportContents& contents);

}  // namespace wristwise
