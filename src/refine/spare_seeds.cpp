#include "refine/spare_seeds.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace wristwise {

namespace {

constexpr std::size_t kMovesOfACheapSearch = 5000;  // checked

bool is_among(const std::vector<Seed>& seeds, const Seed& seed) {
  return std::any_of(seeds.begin(), seeds.end(), [&seed](const Seed& other) {
    return other.path.positions == seed.path.positions;
  });
}

}  // namespace

bool may_try_spare_seeds(const GraphOptions& options, const GraphStatistics& first_search) {
  return options.spare_seeds > 0 && options.planner == Planner::dense &&
         first_search.edges_checked <= kMovesOfACheapSearch;
}

Refined try_spare_seeds(Refined best, std::vector<Seed>& tried,
                        const std::function<std::vector<Seed>()>& find,
                        const std::function<Refined(std::vector<Seed>&)>& refine) {
  std::vector<Seed> spare = find();
  spare.erase(std::remove_if(spare.begin(), spare.end(),
                             [&tried](const Seed& seed) { return is_among(tried, seed); }),
              spare.end());
  if (spare.empty()) return best;
  Refined other = refine(spare);
  std::move(spare.begin(), spare.end(), std::back_inserter(tried));
  return is_better(other, best) ? std::move(other) : std::move(best);
}

}  // namespace wristwise
