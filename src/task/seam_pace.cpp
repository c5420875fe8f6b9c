#include "task/seam_pace.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kLeastTime = 1e-9;  // s, between two knots

/// A place whose rate is given, and the stretch after it.
struct Mark {
  PaceKnot knot;
  std::size_t stretch = 0;
};

bool is_move(const Stretch& stretch) { return stretch.piece.kind == SeamPiece::Kind::move; }

std::vector<Mark> find_marks(const std::vector<Stretch>& stretches, double start,
                             const std::vector<double>& ends) {
  std::vector<Mark> marks{{{start, 1}, 0}};
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
    const double rate = stretches[i].end_rate;
    if (rate < 1 || is_move(stretches[i]) || is_move(stretches[i + 1]))
      marks.push_back({{ends[i], rate}, i + 1});
  }
  marks.push_back({{ends.back(), 1}, stretches.size()});
  return marks;
}

/// The knots between two marks: a ramp from each of them to the full rate, or to the highest rate
/// that ramps of that time have room for.
class RampsBetween {
 public:
  RampsBetween(const PaceKnot& from, const PaceKnot& to, double ramp_time)
      : from_(from), to_(to), ramp_time_(ramp_time) {}

  /// False where one end is run through at full rate and the other's ramp is longer than the way.
  bool fit() const {
    const double low = std::min(from_.rate, to_.rate), high = std::max(from_.rate, to_.rate);
    return low == 1 || high < 1 || length() >= ramp(low, 1) - kLeastTime;
  }

  std::vector<PaceKnot> knots() const {
    if (from_.rate == 1 && to_.rate == 1) return {};
    if (from_.rate == 1) return {{to_.nominal - ramp(to_.rate, 1), 1}};
    if (to_.rate == 1) return {{from_.nominal + ramp(from_.rate, 1), 1}};
    const double peak = std::min(1.0, length() / ramp_time_ - 0.5 * (from_.rate + to_.rate));
    if (peak <= std::max(from_.rate, to_.rate)) return {};
    return {{from_.nominal + ramp(from_.rate, peak), peak},
            {to_.nominal - ramp(to_.rate, peak), peak}};
  }

 private:
  double length() const { return to_.nominal - from_.nominal; }
  /// s, nominal
  double ramp(double low, double high) const { return 0.5 * (low + high) * ramp_time_; }

  PaceKnot from_, to_;
  double ramp_time_;
};

}  // namespace

std::vector<PaceKnot> pace_of(const std::vector<Stretch>& stretches, double start,
                              const std::vector<double>& ends, double ramp_time) {
  const std::vector<Mark> marks = find_marks(stretches, start, ends);
  std::vector<PaceKnot> pace{marks.front().knot};
  const auto add = [&pace](const PaceKnot& knot) {
    if (knot.nominal > pace.back().nominal + kLeastTime) pace.push_back(knot);
  };
  for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
    const PaceKnot &from = marks[i].knot, &to = marks[i + 1].knot;
    const Stretch& first = stretches[marks[i].stretch];
    if (!first.stands) {
      const RampsBetween ramps(from, to, ramp_time);
      if (!ramps.fit())
        throw InvalidInput(
            first.where,
            fmt::format("{:.6g} s long at weld speed, too short for a ramp of {:.6g} "
                        "s at its corner",
                        to.nominal - from.nominal, ramp_time),
            "a shorter ramp, a longer segment, or a run-in or run-out");
      for (const PaceKnot& knot : ramps.knots())
        if (knot.nominal < to.nominal - kLeastTime) add(knot);
    }
    add(to);
  }
  const bool is_even =
      std::all_of(pace.begin(), pace.end(), [](const PaceKnot& knot) { return knot.rate == 1; });
  return is_even ? std::vector<PaceKnot>() : pace;
}

Trajectory seam_time_of(const std::vector<PaceKnot>& pace) {
  const auto number = [](double value) { return JointVector::Constant(1, value); };
  std::vector<double> times;
  std::vector<JointVector> nominal, rates;
  for (std::size_t i = 0; i < pace.size(); ++i) {
    double time = pace[i].nominal;
    if (i > 0) {
      const double step = pace[i].nominal - pace[i - 1].nominal;
      const double mean = 0.5 * (pace[i].rate + pace[i - 1].rate);
      time = times.back() + (mean > 0 ? step / mean : kRestToRest * step);
    }
    times.push_back(time);
    nominal.push_back(number(pace[i].nominal));
    rates.push_back(number(pace[i].rate));
  }
  const std::vector<JointVector> level(pace.size(), number(0));
  return {std::move(times), std::move(nominal), std::move(rates), level};
}

}  // namespace wristwise
