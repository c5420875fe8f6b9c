#include "graph/smallest_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "cancelled.hpp"
#include "graph/sampling_grid.hpp"
#include "graph/sub_task.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr std::size_t kReach = 2;             // waypoints before and after the one that fails
constexpr std::size_t kChecksInTrial = 3000;  // of moves
constexpr std::size_t kChecksInAll = 12000;
constexpr std::size_t kMostSamples = 200000;  // of a trial
constexpr std::size_t kMostNamed = 3;

/// A task with something relaxed.
struct Trial {
  SubTask part;
  GraphOptions options;
  std::shared_ptr<const ClearanceModel> clearance;
  double slower = 1;
};

/// Something that can be relaxed in steps; the larger the step, the more.
class Relaxation {
 public:
  virtual ~Relaxation() = default;
  virtual int steps() const = 0;
  virtual double effort(int step) const = 0;  ///< to compare different things by
  /// false where the step makes no sense
  virtual bool apply(int step, Trial& trial) const = 0;
  virtual std::string text(int step) const = 0;
};

std::string range_text(int coordinate, double lower, double upper) {
  const double scale = coordinate < 3 ? 1e3 : 1 / kDegree;
  const char* const unit = coordinate < 3 ? "mm" : "deg";
  if (lower == 0 && upper == 0) return fmt::format("0 {}", unit);
  if (lower == -upper) return fmt::format("+-{:.4g} {}", scale * upper, unit);
  return fmt::format("[{:.4g}, {:.4g}] {}", scale * lower, scale * upper, unit);
}

class WiderTolerance : public Relaxation {
 public:
  WiderTolerance(int coordinate, const ToleranceBox& box, const GraphOptions& options)
      : coordinate_(coordinate),
        box_(box),
        has_step_(options.automatic_samples > 0 || options.step[coordinate] > 0) {}

  int steps() const override { return coordinate_ < 3 ? 60 : 45; }
  double effort(int step) const override { return coordinate_ < 3 ? 0.5 * step : 0.3 * step; }

  bool apply(int step, Trial& trial) const override {
    try {
      for (Waypoint& waypoint : trial.part.task.waypoints) {
        if (waypoint.joints || waypoint.tolerance.is_free(coordinate_)) continue;
        waypoint.tolerance = wider(waypoint.tolerance, step);
        waypoint.tolerance.validate("");
        if (waypoint.sampled) waypoint.sampled = wider(*waypoint.sampled, step);
      }
      if (!has_step_) trial.options.step[coordinate_] = step_size(step);
    } catch (const InvalidInput&) {
      return false;
    }
    return true;
  }

  std::string text(int step) const override {
    const ToleranceBox box = wider(box_, step);
    const char* const name = kCoordinateNames[static_cast<std::size_t>(coordinate_)];
    std::string change =
        fmt::format("{} {} instead of {}", name,
                    range_text(coordinate_, box.lower[coordinate_], box.upper[coordinate_]),
                    range_text(coordinate_, box_.lower[coordinate_], box_.upper[coordinate_]));
    if (has_step_) return change;
    return fmt::format("{} (and graph.samples.{} {})", change, name,
                       coordinate_ < 3 ? fmt::format("{:.4g} mm", 1e3 * step_size(step))
                                       : fmt::format("{:.4g} deg", step_size(step) / kDegree));
  }

 private:
  static constexpr int kIntervals = 8;  // of a coordinate without a step

  ToleranceBox wider(ToleranceBox box, int step) const {
    const double by = step * (coordinate_ < 3 ? 5e-4 : kDegree);
    box.lower[coordinate_] -= by;
    box.upper[coordinate_] += by;
    return box;
  }

  double step_size(int step) const {
    const ToleranceBox box = wider(box_, step);
    return (box.upper[coordinate_] - box.lower[coordinate_]) / kIntervals;
  }

  int coordinate_;
  ToleranceBox box_;
  bool has_step_;
};

class SmallerClearance : public Relaxation {
 public:
  explicit SmallerClearance(std::shared_ptr<const ClearanceModel> model)
      : model_(std::move(model)) {}

  int steps() const override { return 10; }
  double effort(int step) const override { return step; }
  bool apply(int step, Trial& trial) const override {
    trial.clearance =
        std::make_shared<const ClearanceModel>(model_->with_clearance(clearance(step)));
    return true;
  }
  std::string text(int step) const override {
    return fmt::format("scene.clearance {:.4g} mm instead of {:.4g} mm", 1e3 * clearance(step),
                       1e3 * model_->clearance());
  }

 private:
  double clearance(int step) const { return model_->clearance() * (10 - step) / 10; }

  std::shared_ptr<const ClearanceModel> model_;
};

class SlowerWeld : public Relaxation {
 public:
  int steps() const override { return 100; }
  double effort(int step) const override { return 0.5 * step; }
  bool apply(int step, Trial& trial) const override {
    trial.slower = factor(step);
    return true;
  }
  std::string text(int step) const override {
    return fmt::format("{:.3g} times the time (path.speed / {:.3g})", factor(step), factor(step));
  }

 private:
  static double factor(int step) { return std::pow(1.1, step); }
};

class FinerSamples : public Relaxation {
 public:
  explicit FinerSamples(const GraphOptions& options) : automatic_(options.automatic_samples) {}

  int steps() const override { return 2; }
  double effort(int step) const override { return 0.1 * step; }
  bool apply(int step, Trial& trial) const override {
    constexpr double kDefaultIntervals = 2;  // the ends and the nominal
    const ToleranceBox& box = trial.part.task.waypoints.front().tolerance;
    trial.options.automatic_samples = automatic_samples(step);
    for (int k = 0; k < 6; ++k) {
      double& size = trial.options.step[k];
      if (size == 0) {
        size = box.is_free(k) ? 10 * kDegree : (box.upper[k] - box.lower[k]) / kDefaultIntervals;
      }
      size /= 1 << step;
    }
    return true;
  }
  std::string text(int step) const override {
    if (automatic_ == 0) return fmt::format("graph.samples {} times as fine", 1 << step);
    return fmt::format("graph.automatic_samples {} instead of {}", automatic_samples(step),
                       automatic_);
  }

 private:
  int automatic_samples(int step) const {
    constexpr int kMost = 1000000;
    return static_cast<int>(std::min<std::int64_t>(std::int64_t{automatic_} << (2 * step), kMost));
  }

  int automatic_;
};

class Search {
 public:
  Search(const SamplingInput& input, const Task& task, std::size_t failing, bool too_fast,
         double epsilon, const Monitor& monitor)
      : input_(input), task_(task), failing_(failing), epsilon_(epsilon), monitor_(monitor) {
    const ToleranceBox& box = task.waypoints[failing].tolerance;
    all_.push_back(std::make_unique<FinerSamples>(input.options));
    for (int k = 0; k < 6 && !task.waypoints[failing].joints; ++k) {
      if (!box.is_free(k)) all_.push_back(std::make_unique<WiderTolerance>(k, box, input.options));
    }
    if (!input.clearance->pairs().empty() && input.clearance->clearance() > 0) {
      all_.push_back(std::make_unique<SmallerClearance>(input.clearance));
    }
    if (too_fast) all_.push_back(std::make_unique<SlowerWeld>());
  }

  std::string run() {
    std::vector<Found> found;
    for (const auto& relaxation : all_) {
      if (const auto step = smallest_around(*relaxation))
        found.push_back({relaxation.get(), *step});
    }
    sort(found);
    std::vector<Found> enough;
    for (const Found& one : found) {
      if (const auto step = enough_for_seam(*one.relaxation, one.step)) {
        enough.push_back({one.relaxation, *step});
      }
    }
    sort(enough);
    if (!enough.empty()) {
      std::vector<std::string> texts;
      texts.reserve(enough.size());
      for (const Found& one : enough) texts.push_back(one.relaxation->text(one.step));
      if (texts.size() > kMostNamed) texts.resize(kMostNamed);
      return fmt::format("{} is enough for the whole seam", fmt::join(texts, ", or "));
    }
    if (found.empty()) return {};
    return fmt::format("{} would help at waypoint {}, but not on the whole seam",
                       found.front().relaxation->text(found.front().step), failing_);
  }

 private:
  struct Found {
    const Relaxation* relaxation;
    int step;
  };
  static void sort(std::vector<Found>& found) {
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return a.relaxation->effort(a.step) < b.relaxation->effort(b.step);
    });
  }

  std::optional<int> smallest_around(const Relaxation& relaxation) {
    return smallest(relaxation, 1, around());
  }

  std::optional<int> enough_for_seam(const Relaxation& relaxation, int least) {
    const SubTask whole{task_, input_.cost};
    if (helps(relaxation, least, whole)) return least;
    return smallest(relaxation, least + 1, whole);
  }

  /// The first step from `least` on that helps, by halving.
  std::optional<int> smallest(const Relaxation& relaxation, int least, const SubTask& part) {
    int high = relaxation.steps();
    while (high >= least && !makes_sense(relaxation, high)) --high;
    if (high < least || !helps(relaxation, high, part)) return std::nullopt;
    for (int low = least - 1; high - low > 1;) {
      const int middle = low + (high - low) / 2;
      (helps(relaxation, middle, part) ? high : low) = middle;
    }
    return high;
  }

  bool makes_sense(const Relaxation& relaxation, int step) const {
    Trial trial{around(), input_.options, input_.clearance};
    return relaxation.apply(step, trial);
  }

  bool helps(const Relaxation& relaxation, int step, const SubTask& part) {
    throw_if_cancelled(monitor_);
    Trial trial{part, input_.options, input_.clearance};
    return relaxation.apply(step, trial) && is_feasible(trial);
  }

  /// Infinite where that is more than a waypoint may have.
  double sample_count(const Trial& trial) const {
    const std::vector<Waypoint>& waypoints = trial.part.task.waypoints;
    try {
      return static_cast<double>(waypoints.size() * input_.ik.samples()) *
             static_cast<double>(waypoint_grid(waypoints.front().tolerance, trial.options).size());
    } catch (const InvalidInput&) {
      return std::numeric_limits<double>::infinity();
    }
  }

  bool is_feasible(const Trial& trial) {
    const SamplingInput input{input_.robot, input_.ik, trial.clearance, trial.part.cost,
                              trial.options};
    if (sample_count(trial) > static_cast<double>(kMostSamples)) return false;
    const SampledPath sampled = sample_path(input, trial.part.task, 1, {});
    for (const Rung& rung : sampled.rungs) {
      if (rung.size() == 0) return false;
    }
    GraphSearch search(input, trial.part.task, epsilon_, 1, quiet_);
    search.slow_down(trial.slower);
    const std::size_t granted = std::min(kChecksInTrial, left_);
    std::size_t left = granted;
    KnownChecks known(sampled.rungs, search.rules());
    const auto path = search.find_path_within(left, sampled.rungs, known);
    left_ -= granted - left;
    return path && path->found;
  }

  SubTask around() const {
    return sub_task(task_, input_.cost, failing_ - std::min(failing_, kReach),
                    std::min(failing_ + kReach + 1, task_.waypoints.size()));
  }

  const SamplingInput& input_;
  const Task& task_;
  std::size_t failing_;
  double epsilon_;
  const Monitor& monitor_;
  const Monitor quiet_{};
  std::size_t left_ = kChecksInAll;
  std::vector<std::unique_ptr<Relaxation>> all_;
};

}  // namespace

std::string smallest_relaxation(const SamplingInput& input, const Task& task,
                                std::size_t failing_waypoint, bool too_fast, double epsilon,
                                const Monitor& monitor) {
  return Search(input, task, failing_waypoint, too_fast, epsilon, monitor).run();
}

}  // namespace wristwise
