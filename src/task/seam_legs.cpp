#include "task/seam_legs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kMostIntervals = 1e6;
constexpr double kRoundOff = 1e-9;   // relative, so that 0.3 m / 0.1 m counts as 3 intervals
constexpr double kLeastTime = 1e-9;  // s, of a leg
constexpr int kLeastOnRamp = 4;      // intervals on which the speed changes
constexpr double kLargestTurn = 10 * 0.017453292519943295;  // rad, in an interval on the spot

/// A leg and what decides on its intervals.
struct Measured {
  Leg leg;
  double travel = 0;  ///< m, of its longest interval times their number
  int least = 1;
  bool is_fixed = false;  ///< cut into `least`, whatever the spacing
};

std::vector<double> cuts_of(const SeamPiece& piece, const Seam& seam) {
  std::vector<double> cuts{piece.start_time};
  if (seam.is_retimed()) {
    for (const JointVector& knot : seam.seam_time().positions())
      if (knot[0] > cuts.back() + kLeastTime && knot[0] < piece.end_time - kLeastTime)
        cuts.push_back(knot[0]);
  }
  cuts.push_back(piece.end_time);
  return cuts;
}

Measured measure(const Stretch& stretch, const SeamPiece& piece, const Seam& seam, double from,
                 double to) {
  Measured measured;
  Leg& leg = measured.leg;
  leg.from = from;
  leg.to = to;
  leg.real_from = seam.real_time(from);
  leg.real_to = seam.real_time(to);
  const double first = seam.speed_ratio(leg.real_from), last = seam.speed_ratio(leg.real_to);
  leg.is_even = !stretch.stands && std::abs(first - last) < kRoundOff;
  const double share = (to - from) / (piece.end_time - piece.start_time);
  const double mean = (to - from) / (leg.real_to - leg.real_from);
  measured.travel = piece.length() * share * (leg.is_even ? 1 : std::max(first, last) / mean);
  measured.is_fixed = piece.kind == SeamPiece::Kind::move || stretch.stands;
  if (!leg.is_even) measured.least = kLeastOnRamp;
  if (stretch.stands) {
    const Eigen::AngleAxisd turn(piece.from.linear().transpose() * piece.to.linear());
    measured.least =
        std::max(kLeastOnRamp, static_cast<int>(std::ceil(turn.angle() / kLargestTurn)));
  }
  return measured;
}

std::vector<Measured> measure_all(const std::vector<Stretch>& stretches, const Seam& seam,
                                  std::size_t first) {
  std::vector<Measured> legs;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const SeamPiece& piece = seam.pieces()[first + i];
    const std::vector<double> cuts = cuts_of(piece, seam);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      legs.push_back(measure(stretches[i], piece, seam, cuts[k], cuts[k + 1]));
      legs.back().leg.stretch = i;
    }
    legs.back().leg.ends_stretch = true;
  }
  return legs;
}

/// Deals `total` intervals out in proportion to travel, at least as many as each needs, by the
/// method of the largest remainder.
void deal_out(const std::vector<Measured*>& legs, int total) {
  double whole = 0;
  for (const Measured* leg : legs) whole += leg->travel;
  std::vector<double> quota(legs.size());
  int left = total;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    quota[i] = whole > 0 ? total * legs[i]->travel / whole : 1;
    legs[i]->leg.intervals =
        std::max(legs[i]->least, static_cast<int>(std::floor(quota[i] * (1 + kRoundOff))));
    left -= legs[i]->leg.intervals;
  }
  for (; left != 0 && !legs.empty(); left += left > 0 ? -1 : 1) {
    std::size_t best = legs.size();
    double best_remainder = 0;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const int count = legs[i]->leg.intervals;
      if (left < 0 && count == legs[i]->least) continue;
      const double remainder = left > 0 ? quota[i] - count : count - quota[i];
      if (best == legs.size() || remainder > best_remainder + kRoundOff) {
        best = i;
        best_remainder = remainder;
      }
    }
    legs[best]->leg.intervals += left > 0 ? 1 : -1;
  }
}

void count_by_spacing(const SeamDescription& description, std::vector<Measured>& legs) {
  double total = 0;
  for (const Measured& leg : legs) total += leg.travel / *description.spacing;
  if (total > kMostIntervals)
    throw InvalidInput(
        description.where,
        fmt::format("spacing of {} m makes {:.0f} waypoints", *description.spacing, total),
        "at most a million");
  for (Measured& leg : legs)
    if (!leg.is_fixed)
      leg.leg.intervals =
          std::max(leg.least, intervals_by_spacing(leg.travel, *description.spacing));
}

void count_by_number(const SeamDescription& description, std::vector<Measured>& legs) {
  const int wanted = *description.waypoints;
  const int least = std::accumulate(legs.begin(), legs.end(), 1,
                                    [](int sum, const Measured& leg) { return sum + leg.least; });
  if (wanted < least)
    throw InvalidInput(description.where,
                       fmt::format("{} waypoints are too few to keep all segment ends", wanted),
                       fmt::format("at least {}", least));
  if (wanted > kMostIntervals)
    throw InvalidInput(description.where, fmt::format("{} waypoints", wanted), "at most a million");
  std::vector<Measured*> cut;
  int left = wanted - 1;
  for (Measured& leg : legs) {
    if (leg.is_fixed)
      left -= leg.least;
    else
      cut.push_back(&leg);
  }
  if (cut.empty() && left != 0)
    throw InvalidInput(
        description.where,
        fmt::format("{} waypoints, but moves between joint waypoints are not cut", wanted),
        fmt::format("{}", wanted - left));
  deal_out(cut, left);
}

}  // namespace

int intervals_by_spacing(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing * (1 - kRoundOff))));
}

std::vector<Leg> cut_into_legs(const SeamDescription& description,
                               const std::vector<Stretch>& stretches, const Seam& seam,
                               std::size_t first) {
  std::vector<Measured> measured = measure_all(stretches, seam, first);
  for (Measured& leg : measured) leg.leg.intervals = leg.least;
  if (description.spacing) count_by_spacing(description, measured);
  if (description.waypoints) count_by_number(description, measured);
  std::vector<Leg> legs;
  legs.reserve(measured.size());
  for (const Measured& leg : measured) legs.push_back(leg.leg);
  return legs;
}

}  // namespace wristwise
