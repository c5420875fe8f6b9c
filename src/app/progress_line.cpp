#include "app/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wristwise::app {

namespace {

constexpr int kStageWidth = 10;
constexpr int kLeastBar = 8, kWidestBar = 40;
constexpr double kTellAfter = 2, kTellFrom = 0.1;  // s, share of the stage

/// "0:07", "12:30", "1:02:03"
std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(std::floor(std::max(0.0, seconds)));
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string left_text(const Progress& progress) {
  if (!progress.even || progress.stage_elapsed < kTellAfter || progress.fraction < kTellFrom)
    return {};
  const double left = progress.stage_elapsed * (1 - progress.fraction) / progress.fraction;
  return ", about " + clock_text(std::ceil(left)) + " left";
}

std::string bar_text(double fraction, int width) {
  const int filled = static_cast<int>(fraction * width);
  return fmt::format(" [{:#<{}}{:-<{}}]", "", filled, "", width - filled);
}

}  // namespace

std::string progress_line(const Progress& progress, int width) {
  const std::string stage = fmt::format("{:<{}}", progress.stage, kStageWidth);
  const bool is_known = progress.fraction > 0;
  const std::string share =
      is_known ? fmt::format(" {:3.0f} %", std::floor(100 * progress.fraction)) : "";
  const std::string time = "  " + clock_text(progress.elapsed);
  const auto room = [&](const std::string& text) { return width - static_cast<int>(text.size()); };

  std::string end = share + time;
  const std::string left = is_known ? left_text(progress) : "";
  if (room(stage + end + left) >= kLeastBar + 3) end += left;
  const int bar = std::min(kWidestBar, room(stage + end) - 3);
  std::string line = stage;
  if (is_known && bar >= kLeastBar) line += bar_text(progress.fraction, bar);
  line += room(line + end) >= 0 ? end : share;
  return line.substr(0, static_cast<std::size_t>(std::max(0, width)));
}

}  // namespace wristwise::app
