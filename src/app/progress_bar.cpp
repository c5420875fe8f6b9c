#include "app/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace wristwise::app {

namespace {

constexpr int kWidth = 40;
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

ProgressBar::ProgressBar(bool shown) : shown_(shown && isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const std::string& stage, double fraction) {
  if (!shown_) return;
  const double done = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0;
  const auto filled = static_cast<int>(done * kWidth);
  std::string line = fmt::format("{:<10}[{:#<{}}{:-<{}}] {:3.0f} %", stage, "", filled, "",
                                 kWidth - filled, 100 * done);
  if (line == line_) return;
  line_ = std::move(line);
  fmt::print(stderr, "{}{}", kClearLine, line_);
  std::fflush(stderr);
}

void ProgressBar::clear() {
  if (line_.empty()) return;
  fmt::print(stderr, "{}", kClearLine);
  std::fflush(stderr);
  line_.clear();
}

}  // namespace wristwise::app
