#include "graph/distinct_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "disjoint_sets.hpp"

namespace wristwise {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kPlaces = 9;

/// The first rung, the last, and some between.
std::vector<std::size_t> places_on(std::size_t rungs) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < kPlaces; ++k) {
    const std::size_t place = k * (rungs - 1) / (kPlaces - 1);
    if (result.empty() || result.back() != place) result.push_back(place);
  }
  return result;
}

bool are_neighbours(const Rung& rung, Eigen::Index a, Eigen::Index b, const JointVector& period,
                    double gap) {
  for (Eigen::Index j = 0; j < period.size(); ++j) {
    const double straight = std::abs(rung.positions(a, j) - rung.positions(b, j));
    if (std::min(straight, period[j] - straight) > gap) return false;
  }
  return true;
}

/// The joint without a period whose values spread the most, or the first.
Eigen::Index sweep_joint(const Rung& rung, const JointVector& period) {
  Eigen::Index best = 0;
  double width = -1;
  for (Eigen::Index j = 0; j < period.size(); ++j) {
    const auto column = rung.positions.col(j);
    const double spread = period[j] < kInfinity ? 0 : column.maxCoeff() - column.minCoeff();
    if (spread <= width) continue;
    width = spread;
    best = j;
  }
  return best;
}

/// A rung on which paths may differ.
struct Place {
  std::size_t rung = 0;
  std::vector<int> region;
};

Place make_place(std::size_t rung, const std::vector<Rung>& rungs, const JointVector& period,
                 KnownChecks& known, double gap) {
  std::vector<bool> usable;
  for (Eigen::Index v = 0; v < rungs[rung].size(); ++v) {
    usable.push_back(known.is_usable(0, rung, v));
  }
  return {rung, find_regions(rungs[rung], period, gap, usable)};
}

/// Takes out the regions that the paths pass at a place; false where nothing is left.
bool exclude(Rung& rung, const Place& place, const std::vector<DistinctPath>& paths) {
  const auto region_of = [&place](Eigen::Index v) {
    return place.region[static_cast<std::size_t>(v)];
  };
  for (Eigen::Index v = 0; v < rung.size(); ++v) {
    const bool taken = std::any_of(paths.begin(), paths.end(), [&](const DistinctPath& other) {
      return region_of(v) == region_of(other.path.vertices[place.rung]);
    });
    if (taken || region_of(v) < 0) rung.cost[v] = kInfinity;
  }
  return rung.cost.minCoeff() < kInfinity;
}

}  // namespace

std::vector<int> find_regions(const Rung& rung, const JointVector& period, double gap,
                              const std::vector<bool>& usable) {
  std::vector<int> region(static_cast<std::size_t>(rung.size()), -1);
  if (rung.size() == 0) return region;
  const Eigen::Index joint = sweep_joint(rung, period);
  std::vector<Eigen::Index> order;
  for (Eigen::Index v = 0; v < rung.size(); ++v) {
    if (usable[static_cast<std::size_t>(v)]) order.push_back(v);
  }
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return rung.positions(a, joint) < rung.positions(b, joint);
  });
  const bool sweeps = std::isinf(period[joint]);
  DisjointSets regions(order.size());
  for (std::size_t a = 0; a < order.size(); ++a) {
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const double ahead = rung.positions(order[b], joint) - rung.positions(order[a], joint);
      if (sweeps && ahead > gap) break;
      if (regions.find(a) == regions.find(b)) continue;
      if (are_neighbours(rung, order[a], order[b], period, gap)) regions.unite(a, b);
    }
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    region[static_cast<std::size_t>(order[k])] = static_cast<int>(regions.find(k));
  }
  return region;
}

std::vector<DistinctPath> find_distinct_paths(GraphSearch& search, const std::vector<Rung>& rungs,
                                              const LadderPath& best, KnownChecks& known,
                                              std::size_t count, double gap) {
  std::vector<DistinctPath> paths = {{best, 0}};
  const JointVector& period = search.rules().period;
  std::vector<Place> places;
  for (const std::size_t rung : places_on(rungs.size())) {
    places.push_back(make_place(rung, rungs, period, known, gap));
  }
  std::vector<Rung> some = rungs;
  while (paths.size() < count) {
    DistinctPath next;
    for (const Place& place : places) {
      if (exclude(some[place.rung], place, paths)) {
        LadderPath path = search.find_path(some, known);
        if (path.found && (!next.path.found || path.cost < next.path.cost)) {
          next = {std::move(path), place.rung};
        }
      }
      some[place.rung].cost = rungs[place.rung].cost;
    }
    if (!next.path.found) break;
    paths.push_back(std::move(next));
  }
  return paths;
}

}  // namespace wristwise
