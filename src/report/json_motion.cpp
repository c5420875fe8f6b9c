#include "report/json_motion.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "report/json_array.hpp"

namespace wristwise::json {

namespace {

/// One array for each coordinate, over time.
Json by_coordinate(const std::vector<std::optional<Vector6>>& values, int decimals) {
  Json json = Json::array();
  for (int k = 0; k < 6; ++k) {
    Json of_coordinate = Json::array();
    for (const auto& value : values)
      of_coordinate.push_back(value ? rounded((*value)[k], decimals) : Json(nullptr));
    json.push_back(std::move(of_coordinate));
  }
  return json;
}

void append(const Eigen::Vector3d& point, Json& json) {
  for (const double x : point) json.push_back(rounded(x, 5));
}

/// The names of the pairs of bodies that are nearest at some time, and when.
class PairList {
 public:
  explicit PairList(const ClearanceModel& model) : model_(model) {}

  std::size_t index(int pair) {
    const ClearanceModel::Names pair_names = model_.names(pair);
    const auto [entry, is_new] = known_.emplace(pair_names, known_.size());
    if (is_new) json_.push_back(names(pair_names));
    return entry->second;
  }
  const Json& json() const { return json_; }

 private:
  const ClearanceModel& model_;
  std::map<ClearanceModel::Names, std::size_t> known_;
  Json json_ = Json::array();
};

Json clearance(const MotionSamples& samples, const ClearanceModel& model) {
  Json distance = Json::array(), pair = Json::array(), points = Json::array();
  PairList pairs(model);
  for (const auto& nearest : samples.nearest) {
    if (!nearest) return nullptr;
    distance.push_back(rounded(nearest->distance, 7));
    pair.push_back(pairs.index(nearest->pair));
    append(nearest->point_a, points);
    append(nearest->point_b, points);
  }
  return {{"distance", std::move(distance)},
          {"pair", std::move(pair)},
          {"pairs", pairs.json()},
          {"points", std::move(points)}};
}

}  // namespace

Json knots(const Trajectory& trajectory) {
  return {{"time", array(trajectory.times(), kExact)},
          {"position", by_joint(trajectory.positions(), kExact)},
          {"velocity", by_joint(trajectory.velocities(), kExact)},
          {"acceleration", by_joint(trajectory.accelerations(), kExact)}};
}

Json knots(const JointPath& path) {
  return {{"time", array(path.times, kExact)}, {"position", by_joint(path.positions, kExact)}};
}

Json samples(const MotionSamples& samples, const ClearanceModel& model) {
  Json seam = Json::array();
  for (const Eigen::Vector3d& point : samples.seam) append(point, seam);
  return {{"time", array(samples.times, kExact)},
          {"seam", std::move(seam)},
          {"deviation", by_coordinate(samples.deviation, 7)},
          {"use", by_coordinate(samples.use, 4)},
          {"clearance", clearance(samples, model)}};
}

}  // namespace wristwise::json
