#include "import/ros_message.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "import/file_extension.hpp"
#include "io/config_reader.hpp"
#include "similar_names.hpp"

namespace wristwise {

namespace {

/// Where in a message's lists the robot's joints are.
std::vector<std::size_t> places(const ConfigReader& names, const std::vector<std::string>& joints) {
  std::vector<std::string> given;
  for (const ConfigReader& name : names.items()) given.push_back(name.text());
  std::vector<std::size_t> places;
  for (const std::string& joint : joints) {
    const auto found = std::find(given.begin(), given.end(), joint);
    if (found == given.end())
      names.fail("no joint '" + joint + "'",
                 given.empty() ? "it" : "it; the nearest is " + similar_names(joint, given, 1));
    if (std::find(found + 1, given.end(), joint) != given.end())
      names.fail("two joints '" + joint + "'", "one");
    places.push_back(static_cast<std::size_t>(found - given.begin()));
  }
  return places;
}

/// sec and nanosec, or secs and nsecs of ROS 1.
double read_time(const ConfigReader& reader) {
  const bool ros1 = reader.find("secs").has_value();
  const double seconds = reader.at(ros1 ? "secs" : "sec").quantity(Quantity::number);
  const double rest = reader.at(ros1 ? "nsecs" : "nanosec").quantity(Quantity::number);
  return seconds + 1e-9 * rest;
}

}  // namespace

bool is_ros_message(const std::filesystem::path& file) {
  const std::string extension = file_extension(file);
  return extension == ".yaml" || extension == ".yml";
}

JointPath read_ros_message(const std::filesystem::path& file,
                           const std::vector<std::string>& joint_names) {
  const ConfigNode root = read_yaml(file);
  const ConfigReader top(root, file);
  const ConfigReader message = top.find("joint_trajectory").value_or(top);
  const ConfigReader names = message.at("joint_names");
  const std::size_t count = names.items().size();
  const std::vector<std::size_t> at = places(names, joint_names);
  JointPath path;
  const ConfigReader points = message.at("points");
  for (const ConfigReader& point : points.items()) {
    const auto values =
        point.at("positions").items(count, fmt::format("{} values, one per joint", count));
    JointVector joints(static_cast<Eigen::Index>(at.size()));
    for (std::size_t j = 0; j < at.size(); ++j)
      joints[static_cast<Eigen::Index>(j)] = values[at[j]].quantity(Quantity::number);
    const double time = read_time(point.at("time_from_start"));
    if (!path.times.empty() && time <= path.times.back()) point.fail("time does not increase");
    path.times.push_back(time);
    path.positions.push_back(joints);
  }
  if (path.size() < 2) points.fail(fmt::format("{} points", path.size()), "at least two");
  return path;
}

}  // namespace wristwise
