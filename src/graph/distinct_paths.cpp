#include "graph/distinct_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wristwise {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kPlaces = 9;

/// The first rung, the last, and some between.
std::vector<std::size_t> places(std::size_t rungs) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < kPlaces; ++k) {
    const std::size_t place = k * (rungs - 1) / (kPlaces - 1);
    if (result.empty() || result.back() != place) result.push_back(place);
  }
  return result;
}

bool is_near(const JointVector& q, const JointVector& other, const JointVector& period,
             double separation) {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    double step = q[j] - other[j];
    if (period[j] < kInfinity) step -= period[j] * std::round(step / period[j]);
    if (std::abs(step) > separation) return false;
  }
  return true;
}

/// Takes out what is near one of the paths; false where nothing is left.
bool exclude(Rung& rung, std::size_t place, const std::vector<DistinctPath>& paths,
             const JointVector& period, double separation) {
  for (Eigen::Index v = 0; v < rung.size(); ++v) {
    const JointVector q = rung.vertex(v);
    const bool known = std::any_of(paths.begin(), paths.end(), [&](const DistinctPath& other) {
      return is_near(q, other.path.positions[place], period, separation);
    });
    if (known) rung.cost[v] = kInfinity;
  }
  return rung.cost.minCoeff() < kInfinity;
}

}  // namespace

std::vector<DistinctPath> find_distinct_paths(GraphSearch& search, const std::vector<Rung>& rungs,
                                              const LadderPath& best, KnownChecks& known,
                                              std::size_t count, double separation) {
  std::vector<DistinctPath> paths = {{best, 0}};
  std::vector<Rung> some = rungs;
  while (paths.size() < count) {
    DistinctPath next;
    for (const std::size_t place : places(rungs.size())) {
      const bool left =
          exclude(some[place], place, paths, search.rules().period, separation);
      if (left) {
        LadderPath path = search.find_path(some, known);
        if (path.found && (!next.path.found || path.cost < next.path.cost)) {
          next = {std::move(path), place};
        }
      }
      some[place].cost = rungs[place].cost;
    }
    if (!next.path.found) break;
    paths.push_back(std::move(next));
  }
  return paths;
}

}  // namespace wristwise
