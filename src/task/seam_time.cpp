#include <algorithm>
#include <cmath>

#include "wristwise/error.hpp"
#include "wristwise/seam.hpp"

// The time law of a seam (F22).

namespace wristwise {

namespace {

constexpr double kCoverTolerance = 1e-9;  // s, by which a law may miss the seam's ends
constexpr double kRateTolerance = 1e-7;   // by which a rate may be negative, for round-off
constexpr double kRoundOff = 1e-13;       // relative, of a time

double round_off(double time) { return kRoundOff * std::max(1.0, std::abs(time)); }

double value(const Trajectory& law, double t, int derivative = 0) {
  return law.evaluate(t, derivative)[0];
}

void check_increases(const Trajectory& law) {
  for (std::size_t i = 0; i + 1 < law.times().size(); ++i) {
    JointVector least, largest;
    law.extremes(i, 1, least, largest);
    if (least[0] < -kRateTolerance)
      throw InvalidInput("seam time",
                         "decreases between " + std::to_string(law.times()[i]) + " s and " +
                             std::to_string(law.times()[i + 1]) + " s",
                         "a time law that does not run back");
  }
}

void check_covers(const Trajectory& law, double start, double end) {
  const double first = law.positions().front()[0], last = law.positions().back()[0];
  if (first > start + kCoverTolerance || last < end - kCoverTolerance)
    throw InvalidInput(
        "seam time", "runs from " + std::to_string(first) + " s to " + std::to_string(last) + " s",
        "the whole seam, " + std::to_string(start) + " s to " + std::to_string(end) + " s");
}

/// The earliest time in [before, after] at which the law reaches `nominal`, by bisection: safe
/// where the rate is zero.
double first_time_of(const Trajectory& law, double nominal, double before, double after) {
  while (true) {
    const double middle = 0.5 * (before + after);
    if (middle <= before || middle >= after) return after;
    (value(law, middle) < nominal ? before : after) = middle;
  }
}

}  // namespace

Seam Seam::retimed(const Trajectory& seam_time) const {
  if (pieces_.empty()) throw InvalidInput("seam", "no pieces", "at least one");
  if (seam_time.empty()) throw InvalidInput("seam time", "empty", "a time law");
  const auto joints = seam_time.positions().front().size();
  if (joints != 1)
    throw InvalidInput("seam time", std::to_string(joints) + " joints", "one: the nominal time");
  check_increases(seam_time);
  check_covers(seam_time, pieces_.front().start_time, pieces_.back().end_time);
  Seam seam = *this;
  seam.seam_time_ = seam_time;
  return seam;
}

double Seam::start_time() const {
  return pieces_.empty() ? 0 : real_time(pieces_.front().start_time);
}

double Seam::end_time() const { return pieces_.empty() ? 0 : real_time(pieces_.back().end_time); }

double Seam::nominal_time(double t) const { return is_retimed() ? value(seam_time_, t) : t; }

double Seam::speed_ratio(double t) const { return is_retimed() ? value(seam_time_, t, 1) : 1; }

double Seam::real_time(double nominal) const {
  if (!is_retimed()) return nominal;
  const auto& times = seam_time_.times();
  const auto& reached = seam_time_.positions();
  const auto knot =
      std::lower_bound(reached.begin(), reached.end(), nominal - round_off(nominal),
                       [](const JointVector& position, double time) { return position[0] < time; });
  if (knot == reached.end()) return times.back();
  const auto i = static_cast<std::size_t>(knot - reached.begin());
  if (i == 0 || (*knot)[0] <= nominal + round_off(nominal)) return times[i];
  return first_time_of(seam_time_, nominal, times[i - 1], times[i]);
}

}  // namespace wristwise
