#include "kinematics/joint_limits.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "similar_names.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

constexpr double kDegree = 0.017453292519943295;

// MoveIt's keys. The last six do not concern a planned trajectory and are only checked by name.
constexpr std::array<const char*, 19> kKeys = {"has_position_limits",
                                               "min_position",
                                               "max_position",
                                               "has_velocity_limits",
                                               "max_velocity",
                                               "max_acceleration",
                                               "max_deceleration",
                                               "has_acceleration_limits",
                                               "has_deceleration_limits",
                                               "max_jerk",
                                               "has_jerk_limits",
                                               "angle_wraparound",
                                               "has_effort_limits",
                                               "max_effort",
                                               "has_soft_limits",
                                               "k_position",
                                               "k_velocity",
                                               "soft_lower_limit",
                                               "soft_upper_limit"};

/// One joint's entry in the file.
class Entry {
 public:
  Entry(std::string file, std::string joint, const YAML::Node& node)
      : file_(std::move(file)), joint_(std::move(joint)), node_(node) {
    if (!node_.IsMap()) throw InvalidInput(where(node_, {}), "no mapping", "keys and values");
    check_keys();
  }

  std::optional<double> maximum(const std::string& quantity) const {
    const std::string key = "max_" + quantity;
    if (!enabled("has_" + quantity + "_limits", {key})) return {};
    const double value = number(key);
    if (value > 0) return value;
    throw InvalidInput(where(node_[key], key), "the limit is " + std::to_string(value),
                       "a positive number");
  }

  std::optional<std::pair<double, double>> position() const {
    if (!enabled("has_position_limits", {"min_position", "max_position"})) return {};
    const std::pair<double, double> range = {number("min_position"), number("max_position")};
    if (range.first <= range.second) return range;
    throw InvalidInput(where(node_["min_position"], "min_position"), "exceeds max_position",
                       "min_position <= max_position");
  }

 private:
  std::string where(const YAML::Node& node, const std::string& key) const {
    return file_ + ":" + std::to_string(node.Mark().line + 1) + ": joint '" + joint_ + "'" +
           (key.empty() ? "" : ", key '" + key + "'");
  }

  void check_keys() const {
    std::set<std::string> seen;
    for (const auto& item : node_) {
      const auto key = item.first.as<std::string>();
      if (!seen.insert(key).second) throw InvalidInput(where(item.first, key), "is given twice");
      if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
        const std::vector<std::string> known(kKeys.begin(), kKeys.end());
        throw InvalidInput(where(item.first, key), "unknown key", similar_names(key, known, 1));
      }
    }
  }

  /// A has_... flag that is false switches its values off; without the flag, values count.
  bool enabled(const std::string& flag, const std::vector<std::string>& values) const {
    if (const YAML::Node node = node_[flag]) {
      bool on = false;
      if (node.IsScalar() && YAML::convert<bool>::decode(node, on)) return on;
      throw InvalidInput(where(node, flag), "no truth value", "true or false");
    }
    return std::any_of(values.begin(), values.end(),
                       [this](const std::string& key) { return bool(node_[key]); });
  }

  double number(const std::string& key) const {
    const YAML::Node node = node_[key];
    if (!node) throw InvalidInput(where(node_, key), "is missing", "a number");
    double value = NAN;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
      throw InvalidInput(where(node, key), "no finite number", "a number in SI units");
    }
    if (node.Tag() == "!degrees") return value * kDegree;
    if (node.Tag().rfind('!', 0) == 0 && node.Tag().size() > 1 && node.Tag() != "!radians") {
      throw InvalidInput(where(node, key), "unknown tag " + node.Tag(), "!degrees or !radians");
    }
    return value;
  }

  std::string file_;
  std::string joint_;
  YAML::Node node_;
};

JointLimits read_entry(const Entry& entry) {
  JointLimits limits;
  limits.position = entry.position();
  limits.velocity = entry.maximum("velocity");
  limits.acceleration = entry.maximum("acceleration");
  if (const auto deceleration = entry.maximum("deceleration")) {
    limits.acceleration = std::min(limits.acceleration.value_or(*deceleration), *deceleration);
  }
  limits.jerk = entry.maximum("jerk");
  return limits;
}

YAML::Node load_yaml(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InvalidInput(file.string(), "no such file", "a joint limits file");
  }
  try {
    return YAML::LoadFile(file.string());
  } catch (const YAML::Exception& problem) {
    throw InvalidInput(file.string() + ":" + std::to_string(problem.mark.line + 1),
                       "not valid YAML: " + problem.msg);
  }
}

std::map<std::string, JointLimits> read_entries(const YAML::Node& joints, const std::string& file) {
  std::map<std::string, JointLimits> limits;
  for (const auto& item : joints) {
    const auto name = item.first.as<std::string>();
    const bool inserted = limits.emplace(name, read_entry(Entry(file, name, item.second))).second;
    if (!inserted) {
      throw InvalidInput(file + ":" + std::to_string(item.first.Mark().line + 1),
                         "joint '" + name + "' is given twice");
    }
  }
  return limits;
}

}  // namespace

std::map<std::string, JointLimits> read_joint_limits(const std::filesystem::path& file) {
  const YAML::Node document = load_yaml(file);
  const YAML::Node joints = document.IsMap() ? document["joint_limits"] : YAML::Node();
  if (!joints || !joints.IsMap()) {
    throw InvalidInput(file.string(), "no mapping 'joint_limits'", "MoveIt's joint_limits.yaml");
  }
  try {
    return read_entries(joints, file.string());
  } catch (const YAML::Exception& problem) {
    throw InvalidInput(file.string() + ":" + std::to_string(problem.mark.line + 1), problem.msg);
  }
}

}  // namespace wristwise
