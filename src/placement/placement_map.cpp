#include "placement/placement_map.hpp"

#include <algorithm>

#include "parallel.hpp"
#include "placement/placement_options.hpp"

namespace wristwise {

namespace {

/// Evenly from one end of the range to the other, or its middle.
double coordinate_at(const PlacementOptions& options, int i, int index, int points) {
  if (points == 1) return 0.5 * (options.lower[i] + options.upper[i]);
  if (index + 1 == points) return options.upper[i];
  return options.lower[i] + index * (options.upper[i] - options.lower[i]) / (points - 1);
}

PlacementMap empty_map(const PlacementOptions& options, const Offset& through) {
  PlacementMap map;
  map.axes = free_coordinates(options);
  map.axes.resize(std::min<std::size_t>(map.axes.size(), 2));
  map.points.assign(map.axes.size(), options.map_points);
  Placement unmeasured{through, {}};
  unmeasured.measure.obstacle = "not_measured";
  map.samples.assign(1, unmeasured);
  for (std::size_t axis = 0; axis < map.axes.size(); ++axis) {
    const std::vector<Placement> line = std::move(map.samples);
    map.samples.clear();
    for (int k = 0; k < options.map_points; ++k) {
      for (Placement sample : line) {
        sample.offset[map.axes[axis]] =
            coordinate_at(options, map.axes[axis], k, options.map_points);
        map.samples.push_back(std::move(sample));
      }
    }
  }
  return map;
}

}  // namespace

PlacementMap draw_map(PlacementTrials& trials, const PlacementOptions& options,
                      const Offset& through, int threads) {
  if (options.map_points == 0 || free_coordinates(options).empty()) return {};
  PlacementMap map = empty_map(options, through);
  trials.begin("map", map.samples.size());
  parallel_for(map.samples.size(), threads, [&](int worker, std::size_t i) {
    try {
      map.samples[i] = trials.measure(map.samples[i].offset, worker);
    } catch (const OutOfTime&) {  // stays unmeasured
    }
  });
  return map;
}

}  // namespace wristwise
