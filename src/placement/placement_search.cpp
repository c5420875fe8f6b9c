#include "placement/placement_search.hpp"

#include <algorithm>
#include <random>

#include "parallel.hpp"
#include "placement/cube_search.hpp"
#include "placement/placement_options.hpp"

namespace wristwise {

namespace {

constexpr int kStarts = 4;            // not the number of threads: the result must not depend on it
constexpr double kGlobalShare = 0.6;  // of the evaluations

/// A search over some of the coordinates; the others are those of an origin.
class Subspace {
 public:
  Subspace(const PlacementOptions& options, std::vector<int> coordinates, Offset origin)
      : options_(options), coordinates_(std::move(coordinates)), origin_(std::move(origin)) {}

  Offset offset(const CubePoint& point) const {
    Offset offset = origin_;
    for (std::size_t k = 0; k < coordinates_.size(); ++k) {
      const int i = coordinates_[k];
      const double width = options_.upper[i] - options_.lower[i];
      offset[i] =
          std::clamp(options_.lower[i] + point[k] * width, options_.lower[i], options_.upper[i]);
    }
    return offset;
  }

  CubePoint point(const Offset& offset) const {
    CubePoint point;
    for (const int i : coordinates_)
      point.push_back(std::clamp(
          (offset[i] - options_.lower[i]) / (options_.upper[i] - options_.lower[i]), 0.0, 1.0));
    return point;
  }

 private:
  const PlacementOptions& options_;
  std::vector<int> coordinates_;
  Offset origin_;
};

/// One search, with what it has come upon until it ended for whatever reason.
class OneSearch {
 public:
  OneSearch(PlacementTrials& trials, const Subspace& space, int worker)
      : trials_(trials), space_(space), worker_(worker) {}

  PlacementSearch result;

  double operator()(const CubePoint& point) {
    Placement placement = trials_.measure(space_.offset(point), worker_);
    const double value = placement.measure.value;
    ++result.counts[placement.measure.obstacle];
    if (!result.best || value < result.best->measure.value) result.best = std::move(placement);
    return value;
  }

 private:
  PlacementTrials& trials_;
  const Subspace& space_;
  int worker_;
};

void merge(const PlacementSearch& other, PlacementSearch& into) {
  for (const auto& [reason, count] : other.counts) into.counts[reason] += count;
  if (!other.best) return;
  if (!into.best || other.best->measure.value < into.best->measure.value) into.best = other.best;
}

/// The first start is the given placement, or the one in the region that is nearest to it; the
/// others are random.
CubePoint start_point(const Subspace& space, int start, std::uint32_t seed) {
  CubePoint point = space.point(Offset::Zero());
  if (start == 0) return point;
  std::mt19937 random(seed);
  for (double& x : point) x = static_cast<double>(random()) / 4294967296.0;
  return point;
}

PlacementSearch look_at(PlacementTrials& trials, const Offset& offset) {
  PlacementSearch result;
  trials.begin("search", 1);
  try {
    result.best = trials.measure(offset, 0);
    ++result.counts[result.best->measure.obstacle];
  } catch (const OutOfTime&) {  // nothing is the result
  }
  return result;
}

}  // namespace

PlacementSearch search_region(PlacementTrials& trials, const PlacementOptions& options,
                              int threads) {
  const std::vector<int> coordinates = free_coordinates(options);
  const Subspace space(options, coordinates, options.lower);
  if (coordinates.empty()) return look_at(trials, options.lower);
  const auto starts = static_cast<std::size_t>(std::min(kStarts, evaluation_limit(options)));
  const int each = evaluation_limit(options) / static_cast<int>(starts);
  const int globally = std::max(1, static_cast<int>(kGlobalShare * each));
  trials.begin("search", starts * static_cast<std::size_t>(each));
  std::vector<PlacementSearch> searches(starts);
  parallel_for(starts, threads, [&](int worker, std::size_t k) {
    OneSearch search(trials, space, worker);
    const CubeFunction function = [&search](const CubePoint& point) { return search(point); };
    const std::uint32_t seed = kStarts * options.seed + static_cast<std::uint32_t>(k);
    try {
      const CubeMinimum coarse =
          search_globally(function, start_point(space, static_cast<int>(k), seed), seed, globally);
      if (each > globally) search_locally(function, coarse, each - globally);
    } catch (const OutOfTime&) {  // what was found until then is the result
    }
    searches[k] = std::move(search.result);
  });
  PlacementSearch result;
  for (const PlacementSearch& search : searches) merge(search, result);
  return result;
}

PlacementSearch search_nearby(PlacementTrials& trials, const PlacementOptions& options,
                              const Placement& start, const std::vector<int>& coordinates) {
  const Subspace space(options, coordinates, start.offset);
  const int evaluations = std::max(1, evaluation_limit(options) / kStarts);
  OneSearch search(trials, space, 0);
  search.result.best = start;
  trials.begin("search", static_cast<std::size_t>(evaluations));
  try {
    search_locally([&search](const CubePoint& point) { return search(point); },
                   {space.point(start.offset), start.measure.value}, evaluations);
  } catch (const OutOfTime&) {  // what was found until then is the result
  }
  return search.result;
}

}  // namespace wristwise
