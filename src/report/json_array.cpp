#include "report/json_array.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace wristwise::json {

Json rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const double whole = std::round(value * scale);
  constexpr double kLargest = 9007199254740992.0;  // 2^53: beyond it there is nothing to round
  if (!(std::abs(whole) < kLargest)) return number(value);
  return whole == 0 ? 0.0 : whole / scale;  // no -0
}

Json array(const std::vector<double>& values, int decimals) {
  Json json = Json::array();
  for (const double value : values) json.push_back(rounded(value, decimals));
  return json;
}

Json array(const Eigen::Vector3d& values, int decimals) {
  return {rounded(values.x(), decimals), rounded(values.y(), decimals),
          rounded(values.z(), decimals)};
}

Json by_joint(const std::vector<JointVector>& values, int decimals) {
  Json json = Json::array();
  if (values.empty()) return json;
  for (int j = 0; j < values.front().size(); ++j) {
    Json of_joint = Json::array();
    for (const JointVector& value : values) of_joint.push_back(rounded(value[j], decimals));
    json.push_back(std::move(of_joint));
  }
  return json;
}

Json pose(const Pose& pose) {
  const Eigen::Quaterniond turn(pose.linear());
  Json json = array(Eigen::Vector3d(pose.translation()), kExact);
  for (const double part : {turn.x(), turn.y(), turn.z(), turn.w()})
    json.push_back(rounded(part, 12));
  return json;
}

}  // namespace wristwise::json
