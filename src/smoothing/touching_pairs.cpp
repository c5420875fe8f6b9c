#include "smoothing/touching_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace wristwise {

namespace {

bool has(const std::vector<Scene::Names>& pairs, const Scene::Names& pair) {
  return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
}

}  // namespace

std::vector<Scene::Names> touching_pairs(const std::shared_ptr<const Robot>& robot,
                                         const JointPath& path,
                                         std::vector<std::string>& warnings) {
  const auto model = std::make_shared<const ClearanceModel>(robot, Scene());
  ClearanceChecker checker(model);
  std::vector<int> clear(model->pairs().size());
  std::iota(clear.begin(), clear.end(), 0);
  std::vector<Scene::Names> touching;
  for (std::size_t i = 0; i < path.size() && !clear.empty(); ++i) {
    checker.set_posture(path.positions[i]);
    std::size_t known = touching.size();
    for (const int pair : clear) {
      if (checker.lower_bound(pair) >= 0 || checker.distance(pair).distance >= 0) continue;
      if (!has(touching, model->names(pair))) touching.push_back(model->names(pair));
    }
    if (known == touching.size()) continue;
    clear.erase(std::remove_if(clear.begin(), clear.end(),
                               [&](int pair) { return has(touching, model->names(pair)); }),
                clear.end());
    for (; known < touching.size(); ++known)
      warnings.push_back(
          fmt::format("{} and {} touch along the given path, first at {:.6g} s: not "
                      "checked against each other",
                      touching[known].first, touching[known].second, path.times[i]));
  }
  return touching;
}

}  // namespace wristwise
