#include "timing/speed_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "refine/breakpoints.hpp"
#include "refine/gauss_quadrature.hpp"
#include "refine/spline.hpp"
#include "timing/banded_program.hpp"
#include "timing/subdivision.hpp"
#include "timing/uniform_speed.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kDefaultSpans = 200;
constexpr double kMostSpans = 1e5;
constexpr double kGrowth = 2;         // of the squared speed from one control point to the next
constexpr double kInside = 0.995;     // of the margin: the rows hold at samples only
constexpr double kWatched = 0.8;      // of a limit; from here on a sample gets its rows
constexpr double kRoundOff = 1e-9;    // of a speed
constexpr double kSettled = 1e-4;     // relative change of the time
constexpr int kReach = 40;            // samples before and after one that is near a limit
constexpr int kMostPasses = 30;       // of the convex approximation
constexpr int kMostHalvings = 6;      // of the way to an approximation's optimum
constexpr int kMostCorrections = 6;   // where a limit is broken between the samples
constexpr double kCorrection = 0.98;  // more than what is needed
constexpr std::array<double, 5> kSamples = {1e-3, 0.25, 0.5, 0.75, 0.999};  // of a stretch
constexpr std::array<double, 7> kChecks = {1e-6, 0.12, 0.31, 0.5, 0.69, 0.88, 1 - 1e-6};

void validate(const Trajectory& motion, const Rates& limits, const SpeedProfileOptions& options) {
  if (motion.empty() || limits.rows() != motion.positions().front().size())
    throw InvalidInput("speed profile", "no motion, or limits of other joints");
  if (!(limits.minCoeff() > 0)) throw InvalidInput("limits", "not all positive");
  if (!(options.margin > 0 && options.margin <= 1))
    throw InvalidInput("margin", std::to_string(options.margin), "more than 0, at most 1");
  if (!(options.spacing >= 0) || !std::isfinite(options.spacing))
    throw InvalidInput("spacing", std::to_string(options.spacing), "0 or a time");
}

/// A time at which the limits are held, and the basis of b there.
struct Sample {
  std::size_t stretch = 0;
  SplineBasis::Values basis;
  Rates motion;
  double local = 1;  ///< b that holds the limits where it is constant
  bool watched = false;
};

/// b = (d tau / dt)^2 over tau as a spline with control points in (0, 1]: then the acceleration
/// and the jerk along the law, q'' b + q' b' / 2 and sqrt(b) (q''' b + 3/2 q'' b' + q' b'' / 2),
/// are linear in b but for a factor that the convex approximation takes care of (F27).
class SpeedProfile {
 public:
  SpeedProfile(const Trajectory& motion, const Rates& limits, const SpeedProfileOptions& options)
      : motion_(motion),
        limits_(limits),
        margin_(options.margin),
        spacing_(options.spacing > 0 ? std::max(options.spacing, duration() / kMostSpans)
                                     : duration() / kDefaultSpans),
        stretches_(subdivided(motion.times(), spacing_)),
        knots_(options.only_motion_times ? motion.times() : stretches_),
        basis_(choose_breakpoints(knots_, spacing_)),
        shares_(stretches_.size() - 1, kInside * margin_),
        b_(static_cast<std::size_t>(basis_.control_count()), 1.0) {}

  Trajectory run() {
    place_samples();
    Trajectory law = time_law();
    double slowdown = largest_slowdown(law);
    for (int i = 0; i < kMostCorrections && slowdown > 1; ++i) {
      maximise_speed();
      law = time_law();
      slowdown = largest_slowdown(law);
      if (slowdown > 1) lower_shares(law);
    }
    return slowdown > 1 ? stretched(law, slowdown) : law;
  }

 private:
  double duration() const { return motion_.times().back() - motion_.times().front(); }

  void place_samples() {
    for (std::size_t i = 0; i + 1 < stretches_.size(); ++i) {
      for (const double share : kSamples) {
        const double tau = stretches_[i] + share * (stretches_[i + 1] - stretches_[i]);
        samples_.push_back({i, basis_.at(tau), rates_at(motion_, tau)});
      }
    }
  }

  /// The largest constant b that a sample allows.
  double local_limit(const Sample& sample) const {
    double b = 1;
    const Rates ratios = sample.motion.cwiseAbs().cwiseQuotient(limits_) / shares_[sample.stretch];
    for (int k = 0; k < 3; ++k) {
      b = std::min(b, std::pow(std::max(1.0, ratios.col(k).maxCoeff()), -2.0 / (k + 1)));
    }
    return b;
  }

  /// d^k b / d tau^k.
  double value(const SplineBasis::Values& basis, int derivative) const {
    const auto first = static_cast<std::size_t>(basis.first);
    double sum = 0;
    for (int m = 0; m < SplineBasis::kLocal; ++m) {
      sum += basis.derivatives(m, derivative) * b_[first + static_cast<std::size_t>(m)];
    }
    return sum;
  }

  /// Derivatives 1 to 3 of the law at a sample.
  Eigen::Vector3d law_at(const Sample& sample) const {
    const double u = std::sqrt(value(sample.basis, 0));
    return {u, 0.5 * value(sample.basis, 1), 0.5 * u * value(sample.basis, 2)};
  }

  /// From what each sample allows by itself. Where that ends in a local optimum worse than the
  /// speed that can be held all along, from that speed, which each pass improves on.
  void maximise_speed() {
    std::vector<double> local;
    for (Sample& sample : samples_) local.push_back(sample.local = local_limit(sample));
    const double uniform = *std::min_element(local.begin(), local.end());
    if (approximate(local) <= total_time(std::vector<double>(local.size(), uniform))) return;
    b_.assign(b_.size(), uniform);
    approximate(std::vector<double>(local.size(), uniform));
  }

  /// From values of b at the samples; the time that it ends with, s.
  double approximate(std::vector<double> around) {
    double time = INFINITY;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const bool more = watch_more();
      const std::vector<double> best = maximise(gains(around), rows(around), start(around));
      const double last =
          std::exchange(time, more || pass == 0 ? take(best, 1) : take_share(best, time));
      for (std::size_t i = 0; i < samples_.size(); ++i) around[i] = value(samples_[i].basis, 0);
      if (!more && std::abs(time - last) <= kSettled * time) break;
    }
    return time;
  }

  /// The way to the optimum of the approximation, whose gain is linear, may overshoot that of the
  /// time: the largest share of it, by halving, that saves time.
  double take_share(const std::vector<double>& best, double time) {
    const std::vector<double> from = b_;
    for (int halvings = 0; halvings < kMostHalvings; ++halvings) {
      b_ = from;
      const double after = take(best, std::ldexp(1.0, -halvings));
      if (after < time) return after;
    }
    b_ = from;
    return time;
  }

  double take(const std::vector<double>& to, double share) {
    for (std::size_t i = 0; i < b_.size(); ++i) b_[i] += share * (to[i] - b_[i]);
    double time = 0;
    for (const Sample& sample : samples_) time += width(sample) / std::sqrt(value(sample.basis, 0));
    return time;
  }

  /// Samples at which a limit is near get rows, and so do those around them, to which the optimum
  /// would only shift its ramps. False where none is new.
  bool watch_more() {
    const int count = static_cast<int>(samples_.size());
    std::vector<bool> watched(samples_.size(), false);
    int until = 0;
    for (int i = 0; i < count; ++i) {
      if (!is_near_limit(samples_[static_cast<std::size_t>(i)])) continue;
      for (int k = std::max(until, i - kReach); k < std::min(i + kReach, count); ++k) {
        watched[static_cast<std::size_t>(k)] = true;
      }
      until = std::min(i + kReach, count);
    }
    bool more = false;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      more = more || (watched[i] && !samples_[i].watched);
      samples_[i].watched = samples_[i].watched || watched[i];
    }
    return more;
  }

  bool is_near_limit(const Sample& sample) const {
    const Rates along = along_law(sample.motion, law_at(sample));
    return along.cwiseAbs().cwiseQuotient(limits_).maxCoeff() > kWatched * shares_[sample.stretch];
  }

  /// Of the time, the integral of b^(-1/2), the derivative by each control point, negated.
  std::vector<double> gains(const std::vector<double>& around) const {
    std::vector<double> gains(b_.size(), 0.0);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      const double factor = width(sample) * std::pow(around[i], -1.5);
      const auto first = static_cast<std::size_t>(sample.basis.first);
      for (int m = 0; m < SplineBasis::kLocal; ++m) {
        gains[first + static_cast<std::size_t>(m)] += factor * sample.basis.derivatives(m, 0);
      }
    }
    return gains;
  }

  double total_time(const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) sum += width(samples_[i]) / std::sqrt(b[i]);
    return sum;
  }

  double width(const Sample& sample) const {
    return stretches_[sample.stretch + 1] - stretches_[sample.stretch];
  }

  std::vector<BandedRow> rows(const std::vector<double>& around) const {
    std::vector<BandedRow> rows;
    const int last = basis_.control_count() - SplineBasis::kLocal;
    for (int i = 0; i < basis_.control_count(); ++i) {
      const int first = std::min(i, last);
      BandedRow most{first, {}, 1};
      most.weights[static_cast<std::size_t>(i - first)] = 1;
      rows.push_back(most);
      if (i + 1 < basis_.control_count()) add_growth_rows(i, std::min(i, last), rows);
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i].watched) add_limit_rows(samples_[i], around[i], rows);
    }
    return rows;
  }

  /// b > 0, and ramps that the waypoints can follow: no control point is more than kGrowth times
  /// its neighbour.
  static void add_growth_rows(int i, int first, std::vector<BandedRow>& rows) {
    BandedRow up{first, {}, 0}, down{first, {}, 0};
    const auto k = static_cast<std::size_t>(i - first);
    up.weights[k] = down.weights[k + 1] = -kGrowth;
    up.weights[k + 1] = down.weights[k] = 1;
    rows.push_back(up);
    rows.push_back(down);
  }

  void add_limit_rows(const Sample& sample, double around, std::vector<BandedRow>& rows) const {
    const double share = shares_[sample.stretch];
    const auto derivatives = sample.basis.derivatives.leftCols<3>();
    const double fastest =
        share /
        std::max(1e-300, sample.motion.col(0).cwiseAbs().cwiseQuotient(limits_.col(0)).maxCoeff());
    if (fastest < 1) rows.push_back(row(sample, derivatives.col(0), fastest * fastest));
    for (int j = 0; j < limits_.rows(); ++j) {
      const double q1 = sample.motion(j, 0), q2 = sample.motion(j, 1), q3 = sample.motion(j, 2);
      if (std::isfinite(limits_(j, 1))) {
        const BasisRow acceleration =
            derivatives * Eigen::Vector3d(q2, 0.5 * q1, 0) / (share * limits_(j, 1));
        rows.push_back(row(sample, acceleration, 1));
        rows.push_back(row(sample, -acceleration, 1));
      }
      if (!std::isfinite(limits_(j, 2))) continue;
      // The limit over sqrt(b), convex in b, lies above its tangent at `around`.
      const BasisRow jerk = derivatives * Eigen::Vector3d(q3, 1.5 * q2, 0.5 * q1) *
                            (std::sqrt(around) / (share * limits_(j, 2)));
      const BasisRow tangent = derivatives.col(0) * (0.5 / around);
      rows.push_back(row(sample, tangent + jerk, 1.5));
      rows.push_back(row(sample, tangent - jerk, 1.5));
    }
  }

  using BasisRow = Eigen::Matrix<double, SplineBasis::kLocal, 1>;
  static BandedRow row(const Sample& sample, const BasisRow& weights, double limit) {
    BandedRow row{sample.basis.first, {}, limit};
    for (int m = 0; m < SplineBasis::kLocal; ++m)
      row.weights[static_cast<std::size_t>(m)] = weights[m];
    return row;
  }

  /// Constant, slow enough everywhere, and not above the tangents of `around` either.
  std::vector<double> start(const std::vector<double>& around) const {
    double least = *std::min_element(around.begin(), around.end());
    for (const Sample& sample : samples_) least = std::min(least, sample.local);
    return std::vector<double>(b_.size(), 0.5 * least);
  }

  Trajectory time_law() const {
    std::vector<JointVector> positions, velocities, accelerations;
    for (const double tau : knots_) {
      const SplineBasis::Values basis = basis_.at(tau);
      positions.emplace_back(JointVector::Constant(1, tau));
      velocities.emplace_back(JointVector::Constant(1, std::sqrt(value(basis, 0))));
      accelerations.emplace_back(JointVector::Constant(1, 0.5 * value(basis, 1)));
    }
    return {real_times(), std::move(positions), std::move(velocities), std::move(accelerations)};
  }

  /// At the knots.
  std::vector<double> real_times() const {
    std::vector<double> times = {knots_.front()};
    double t = knots_.front();
    for (std::size_t i = 0; i + 1 < stretches_.size(); ++i) {
      for (const QuadraturePoint& point : gauss_points({stretches_[i], stretches_[i + 1]})) {
        t += point.weight / std::sqrt(value(basis_.at(point.time), 0));
      }
      if (stretches_[i + 1] == knots_[times.size()]) times.push_back(t);
    }
    return times;
  }

  /// |rates| / (margin x limits) along the law at time t, the largest of the joints.
  Eigen::RowVector3d excess(const Trajectory& law, double t) const {
    const Rates along =
        along_law(rates_at(motion_, law.evaluate(t)[0]), rates_at(law, t).row(0).transpose());
    return along.cwiseAbs().cwiseQuotient(limits_).colwise().maxCoeff() / margin_;
  }

  /// Real times at which the law is checked.
  std::vector<double> check_times(const Trajectory& law) const {
    std::vector<double> times;
    for (std::size_t i = 0; i + 1 < law.times().size(); ++i) {
      const double t0 = law.times()[i], t1 = law.times()[i + 1];
      const int parts = part_count(knots_[i + 1] - knots_[i], spacing_);
      for (int part = 0; part < parts; ++part) {
        for (const double share : kChecks) times.push_back(t0 + (t1 - t0) * (part + share) / parts);
      }
    }
    return times;
  }

  /// The factor of time by which the law as a whole is too fast.
  double largest_slowdown(const Trajectory& law) const {
    double largest = fastest(law);
    for (const double t : check_times(law)) {
      const Eigen::RowVector3d ratio = excess(law, t);
      largest = std::max({largest, ratio[0], std::sqrt(ratio[1]), std::cbrt(ratio[2])});
    }
    return largest;
  }

  /// Of its speeds between the knots, where the quintic may pass 1.
  static double fastest(const Trajectory& law) {
    double fastest = 0;
    for (std::size_t i = 0; i + 1 < law.times().size(); ++i) {
      JointVector least, largest;
      law.extremes(i, 1, least, largest);
      fastest = std::max(fastest, largest[0]);
    }
    return fastest > 1 + kRoundOff ? fastest : 0;
  }

  /// Around stretches on which the law is too fast.
  void lower_shares(const Trajectory& law) {
    const std::size_t count = shares_.size();
    std::vector<double> largest(count, 0.0);
    for (const double t : check_times(law)) {
      double& stretch = largest[stretch_at(law.evaluate(t)[0])];
      stretch = std::max(stretch, excess(law, t).maxCoeff());
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double around = std::max({largest[i - std::min<std::size_t>(i, 1)], largest[i],
                                      largest[std::min(i + 1, count - 1)]});
      if (around > 1) shares_[i] *= kCorrection / around;
    }
  }

  std::size_t stretch_at(double tau) const {
    const auto after = std::upper_bound(stretches_.begin() + 1, stretches_.end() - 1, tau);
    return static_cast<std::size_t>(after - stretches_.begin()) - 1;
  }

  const Trajectory& motion_;
  const Rates& limits_;
  const double margin_;
  const double spacing_;
  /// s, in the motion's time: ends of the stretches that are sampled; of the pieces of the law.
  const std::vector<double> stretches_, knots_;
  const SplineBasis basis_;
  std::vector<double> shares_;  ///< of the limits that may be used, on each stretch
  std::vector<double> b_;       ///< control points
  std::vector<Sample> samples_;
};

}  // namespace

Trajectory speed_profile(const Trajectory& motion, const Rates& limits,
                         const SpeedProfileOptions& options) {
  validate(motion, limits, options);
  return SpeedProfile(motion, limits, options).run();
}

}  // namespace wristwise
