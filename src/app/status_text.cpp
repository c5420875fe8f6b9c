#include "app/status_text.hpp"

#include <fmt/format.h>

#include "io/result_file.hpp"

namespace wristwise::app {

std::string status_text(Status status, const Paint& paint) {
  const std::string name = status_name(status);
  if (status == Status::solved) return paint.good(name);
  return status == Status::interrupted ? paint.warning(name) : paint.bad(name);
}

std::string diagnosis_text(const std::vector<Diagnosis>& diagnosis, const Paint& paint) {
  std::string text;
  for (const Diagnosis& entry : diagnosis) {
    if (entry.reason == "verification") continue;  // the table of the check says it
    text += "  " + paint.bad(entry.reason);
    if (entry.waypoint) text += fmt::format(" at waypoint {}", *entry.waypoint);
    text += ": " + entry.detail + "\n";
    if (!entry.suggestion.empty())
      text += "    " + paint.bold("what would help:") + " " + entry.suggestion + "\n";
  }
  return text;
}

}  // namespace wristwise::app
