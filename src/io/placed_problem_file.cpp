#include "io/placed_problem_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/config_node.hpp"
#include "io/frame_keys.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

/// Keys whose value, or each value of whose list, is a path.
constexpr std::array<const char*, 6> kPathKeys = {"urdf", "limits", "srdf",
                                                  "mesh", "poses",  "packages"};

ConfigNode* find(ConfigNode& map, const std::string& key) {
  for (auto& [name, value] : map.entries)
    if (name == key) return &value;
  return nullptr;
}

ConfigNode& child(ConfigNode& map, const std::string& key) {
  if (ConfigNode* found = find(map, key)) return *found;
  map.kind = ConfigNode::Kind::map;
  map.entries.emplace_back(key, ConfigNode{});
  return map.entries.back().second;
}

ConfigNode list(const Eigen::Vector3d& values) {
  ConfigNode node;
  node.kind = ConfigNode::Kind::list;
  for (const double value : {values.x(), values.y(), values.z()})
    node.items.push_back({ConfigNode::Kind::scalar, 0, fmt::format("{}", value), {}, {}});
  return node;
}

void set_frame(const Pose& pose, ConfigNode& map) {
  const FrameKeys keys = frame_keys(pose);
  child(map, "xyz") = list(keys.xyz);
  child(map, "rpy") = list(keys.rpy);
}

const SceneObject& object_named(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const SceneObject& object) { return object.name == name; });
  if (found == scene.objects.end() || found->shapes.empty())
    throw InvalidInput("placed problem", "the problem file has no object '" + name + "'",
                       "the file that the problem was read from");
  return *found;
}

void move_objects(const PlacedProblem& placed, ConfigNode& root) {
  ConfigNode* scene = find(root, "scene");
  ConfigNode* objects = scene != nullptr ? find(*scene, "objects") : nullptr;
  if (objects == nullptr) return;
  for (ConfigNode& object : objects->items) {
    const std::string name = child(object, "name").text;
    if (std::find(placed.moved.begin(), placed.moved.end(), name) == placed.moved.end()) continue;
    // all shapes of an object have its pose
    set_frame(object_named(placed.problem.scene, name).shapes.front().pose, object);
  }
}

bool is_relative(const std::string& path) {
  return path.rfind("package://", 0) != 0 && std::filesystem::path(path).is_relative();
}

void lead_from(const std::filesystem::path& folder, const std::filesystem::path& old_folder,
               ConfigNode& path) {
  for (ConfigNode& item : path.items) lead_from(folder, old_folder, item);
  if (path.kind != ConfigNode::Kind::scalar || !is_relative(path.text)) return;
  path.text = std::filesystem::proximate(old_folder / path.text, folder).string();
}

void lead_paths_from(const std::filesystem::path& folder, const std::filesystem::path& old_folder,
                     ConfigNode& node) {
  for (ConfigNode& item : node.items) lead_paths_from(folder, old_folder, item);
  for (auto& [key, value] : node.entries) {
    if (std::find(kPathKeys.begin(), kPathKeys.end(), key) != kPathKeys.end())
      lead_from(folder, old_folder, value);
    else
      lead_paths_from(folder, old_folder, value);
  }
}

}  // namespace

std::string placed_problem_text(const std::filesystem::path& problem_file,
                                const PlacedProblem& placed, const std::filesystem::path& folder) {
  ConfigNode root = read_yaml(problem_file);
  root.entries.erase(std::remove_if(root.entries.begin(), root.entries.end(),
                                    [](const auto& entry) { return entry.first == "placement"; }),
                     root.entries.end());
  lead_paths_from(folder, std::filesystem::absolute(problem_file).parent_path(), root);
  set_frame(placed.part_frame, child(child(root, "path"), "frame"));
  move_objects(placed, root);
  return "# " + problem_file.filename().string() +
         " with its part where `wristwise place` found the best place for it\n" + yaml_text(root);
}

}  // namespace wristwise
