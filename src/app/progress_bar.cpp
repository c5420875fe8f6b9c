#include "app/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/interrupt.hpp"
#include "app/terminal.hpp"

namespace wristwise::app {

namespace {

constexpr std::chrono::milliseconds kFirst(200), kEvery(100);
constexpr double kAgain = 0.5;  // a share that falls by so much is of another run of the stage
constexpr const char* kClearLine = "\r\033[K";

double seconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

ProgressBar::ProgressBar(bool shown) {
  if (shown && is_terminal(STDERR_FILENO)) drawer_ = std::thread([this] { draw_until_ended(); });
}

ProgressBar::~ProgressBar() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  changed_.notify_one();
  if (drawer_.joinable()) drawer_.join();
}

void ProgressBar::show(const std::string& stage, double fraction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double done = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0;
  if (stage != stage_ || done < fraction_ - kAgain) {
    stage_ = stage;
    stage_start_ = Clock::now();
    fraction_ = 0;
    reports_ = 0;
  }
  ++reports_;
  fraction_ = std::max(fraction_, done);
}

void ProgressBar::print_line(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  clear();
  fmt::print(stderr, "{}\n", line);
}

void ProgressBar::draw_until_ended() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (auto pause = kFirst; !changed_.wait_for(lock, pause, [this] { return ended_; });
       pause = kEvery)
    draw();
  clear();
}

void ProgressBar::draw() {
  const Clock::time_point now = Clock::now();
  Progress progress{stage_, true, fraction_, seconds(now - start_), seconds(now - stage_start_)};
  const bool is_refinement = stage_.rfind("refine", 0) == 0;  // it reports once a round
  if (is_refinement) progress.stage += fmt::format(" round {}", reports_);
  progress.even = !is_refinement && stage_ != "search";
  if (interrupted()) {
    progress.stage = "stopping; Ctrl-C again ends at once";
    progress.fraction = 0;
  }
  std::string line = progress_line(progress, terminal_width(STDERR_FILENO) - 1);
  if (line == line_) return;
  clear_line_when_ended(true);
  line_ = std::move(line);
  fmt::print(stderr, "{}{}", kClearLine, line_);
  std::fflush(stderr);
}

void ProgressBar::clear() {
  if (line_.empty()) return;
  fmt::print(stderr, "{}", kClearLine);
  std::fflush(stderr);
  line_.clear();
  clear_line_when_ended(false);
}

}  // namespace wristwise::app
