#include "refine/active_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

// (F33) The Lagrangian is J / 2 + sum_i lambda_i c_i with lambda_i > 0 at an upper and < 0 at a
// lower bound. Where all bounds of a group move out by w, dJ/dw = -2 sum_i |lambda_i| (the envelope
// theorem; Nocedal & Wright, Numerical Optimization, sec. 12.3). J is convex in w where
// the problem is, so that this forecast is the most that a finite w can bring; for what is held
// without tolerance its range is short.

namespace wristwise {

namespace {

using Kind = PointConstraint::Kind;

constexpr double kNoticeable = 1e-3;  ///< share of J; what brings less is not listed
constexpr double kDegree = 0.017453292519943295;

enum class Side {
  lower,
  upper,
  either,  ///< whichever of the two
  both,    ///< a width of zero
};

/// One kind of constraint over a stretch of the motion.
struct Stretch {
  std::string name;
  Side side = Side::upper;
  ActiveConstraint::Unit unit = ActiveConstraint::Unit::metre;
  bool is_clearance = false;
  double from = 0, to = 0;
  double sum = 0;  ///< of |lambda|
};

struct Sample {
  std::ptrdiff_t position = 0;  ///< among all points
  double time = 0;
  double multiplier = 0;
};

constexpr std::ptrdiff_t kGap = 3;  ///< positions without a sample that end a stretch

/// Cuts the samples (in time order) of one constraint into stretches on which it presses. What is
/// held without tolerance presses everywhere.
void add_stretches(const Stretch& kind, const std::vector<Sample>& samples,
                   std::vector<Stretch>& stretches) {
  double largest = 0;
  for (const Sample& sample : samples) largest = std::max(largest, std::abs(sample.multiplier));
  if (kind.side == Side::both) {
    stretches.push_back(kind);
    stretches.back().from = samples.front().time;
    stretches.back().to = samples.back().time;
    for (const Sample& sample : samples) stretches.back().sum += std::abs(sample.multiplier);
    return;
  }
  bool open = false;
  std::ptrdiff_t last = 0;
  for (const Sample& sample : samples) {
    if (std::abs(sample.multiplier) <= 1e-3 * largest) {
      open = false;
      continue;
    }
    open = open && sample.position <= last + kGap;
    last = sample.position;
    if (!open) {
      stretches.push_back(kind);
      stretches.back().from = sample.time;
    }
    open = true;
    stretches.back().to = sample.time;
    stretches.back().sum += std::abs(sample.multiplier);
  }
}

ActiveConstraint::Unit unit_of(const Robot& robot, const PointConstraint::Row& row) {
  const bool turns =
      row.kind == Kind::deviation ? row.index >= 3
      : row.kind == Kind::joint
          ? robot.joints()[static_cast<std::size_t>(row.index)].type != JointType::prismatic
          : false;
  return turns ? ActiveConstraint::Unit::radian : ActiveConstraint::Unit::metre;
}

std::string name_of(const ClearanceModel& clearance, const PointConstraint::Row& row) {
  const auto index = static_cast<std::size_t>(row.index);
  switch (row.kind) {
    case Kind::deviation:
      return kCoordinateNames[index];
    case Kind::joint:
      return clearance.robot().joints()[index].name;
    case Kind::clearance:
      break;
  }
  const auto names = clearance.names(row.index);
  return names.first + " - " + names.second;
}

void add_points(const ClearanceModel& clearance, const std::vector<PointConstraint>& points,
                std::vector<Stretch>& stretches) {
  std::map<std::tuple<Kind, int, Side>, std::pair<Stretch, std::vector<Sample>>> groups;
  std::ptrdiff_t position = 0;
  for (const PointConstraint& point : points) {
    ++position;
    for (const PointConstraint::Row& row : point.rows) {
      const double multiplier = row.bounds.multiplier;
      const bool fixed = row.bounds.lower == row.bounds.upper;
      for (const Side side : {Side::lower, Side::upper, Side::both}) {
        if ((side == Side::both) != fixed) continue;
        auto& [kind, samples] = groups[{row.kind, row.index, side}];
        if (samples.empty())
          kind = {name_of(clearance, row), side, unit_of(clearance.robot(), row),
                  row.kind == Kind::clearance};
        const bool presses = fixed || (side == Side::upper ? multiplier > 0 : multiplier < 0);
        samples.push_back({position, point.time, presses ? multiplier : 0});
      }
    }
  }
  for (const auto& group : groups)
    add_stretches(group.second.first, group.second.second, stretches);
}

void add_limits(const Robot& robot, const SplineBasis& basis,
                const std::vector<LimitConstraint>& limits, std::vector<Stretch>& stretches) {
  constexpr std::array<const char*, 4> kOf = {"position", "velocity", "acceleration", "jerk"};
  std::map<std::pair<int, int>, std::pair<Stretch, std::vector<Sample>>> groups;
  for (const LimitConstraint& limit : limits) {
    const int last = limit.first + static_cast<int>(limit.weights.size()) - 1;
    // Greville's abscissa of the derivative's control point, about where it is felt.
    double time = 0;
    for (int k = last + 1; k <= limit.first + SplineBasis::kDegree; ++k) time += basis.knot(k);
    time /= SplineBasis::kDegree - limit.derivative;
    for (std::size_t r = 0; r < limit.rows.size(); ++r) {
      const Joint& joint = robot.joints()[static_cast<std::size_t>(limit.joints[r])];
      auto& [kind, samples] = groups[{limit.derivative, limit.joints[r]}];
      kind.name = joint.name + " " + kOf[static_cast<std::size_t>(limit.derivative)];
      kind.side = Side::either;
      kind.unit = limit.derivative > 0                 ? ActiveConstraint::Unit::share
                  : joint.type == JointType::prismatic ? ActiveConstraint::Unit::metre
                                                       : ActiveConstraint::Unit::radian;
      samples.push_back({limit.first, time, limit.rows[r].multiplier});
    }
  }
  for (const auto& group : groups)
    add_stretches(group.second.first, group.second.second, stretches);
}

/// The step for which the linear forecast is told: one that a user would think of.
double told_step(ActiveConstraint::Unit unit) {
  switch (unit) {
    case ActiveConstraint::Unit::radian:
      return kDegree;
    case ActiveConstraint::Unit::metre:
      return 1e-3;
    case ActiveConstraint::Unit::share:
      break;
  }
  return 0.01;
}

std::string step_text(ActiveConstraint::Unit unit, double step) {
  switch (unit) {
    case ActiveConstraint::Unit::radian:
      return fmt::format("{:.3g} deg", step / kDegree);
    case ActiveConstraint::Unit::metre:
      return fmt::format("{:.3g} mm", step * 1e3);
    case ActiveConstraint::Unit::share:
      break;
  }
  return fmt::format("{:.3g}%", step * 100);
}

std::string sentence(const Stretch& stretch, double relative, const std::string& held_by) {
  double step = told_step(stretch.unit);
  while (relative * step > 0.3) step /= 10;  // a linear forecast says nothing about large steps
  const std::string gain =
      fmt::format("lower the cost by {} {:.2g}%", stretch.side == Side::both ? "up to" : "about",
                  100 * relative * step);
  const std::string when = fmt::format("from {:.4g} to {:.4g} s", stretch.from, stretch.to);
  const std::string amount = step_text(stretch.unit, step);
  if (stretch.is_clearance)
    return fmt::format("{} are at their clearance {}; {} less would {}", stretch.name, when, amount,
                       gain);
  const std::string at = stretch.side == Side::lower    ? "at its lower limit"
                         : stretch.side == Side::upper  ? "at its upper limit"
                         : stretch.side == Side::either ? "at its limit"
                                                        : "held without tolerance";
  const std::string by = held_by.empty() ? "" : fmt::format(" ({} is in the way)", held_by);
  return fmt::format("{} is {} {}{}; {} more would {}", stretch.name, at, when, by, amount, gain);
}

bool overlap(const Stretch& a, const Stretch& b) { return a.from <= b.to && b.from <= a.to; }

}  // namespace

std::vector<ActiveConstraint> active_constraints(const ClearanceModel& clearance,
                                                 const Spline& spline,
                                                 std::vector<PointConstraint> points,
                                                 const std::vector<LimitConstraint>& limits,
                                                 double objective) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.time < b.time; });
  std::vector<Stretch> stretches;
  add_points(clearance, points, stretches);
  add_limits(clearance.robot(), spline.basis, limits, stretches);
  std::vector<ActiveConstraint> result;
  for (const Stretch& stretch : stretches) {
    const double relative = 2 * stretch.sum / objective;
    if (!(relative * told_step(stretch.unit) >= kNoticeable)) continue;
    std::string held_by;
    for (const Stretch& other : stretches) {
      if (!stretch.is_clearance && stretch.side != Side::both && other.is_clearance &&
          overlap(stretch, other))
        held_by = other.name;
    }
    result.push_back({stretch.name, stretch.unit, stretch.from, stretch.to, relative,
                      sentence(stretch, relative, held_by)});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.relative_gain * told_step(a.unit) > b.relative_gain * told_step(b.unit);
  });
  return result;
}

}  // namespace wristwise
