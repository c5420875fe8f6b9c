#include <algorithm>

#include "io/problem_sections.hpp"
#include "similar_names.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {

namespace {

const std::vector<std::string> kShapes = {"box", "cylinder", "sphere", "mesh"};
constexpr double kConvexError = 0.002;  // m

double read_size(const ConfigReader& reader) { return reader.positive(Quantity::length); }

Eigen::Vector3d read_scale(const std::optional<ConfigReader>& reader) {
  if (!reader) return Eigen::Vector3d::Ones();
  if (!reader->is_list()) return Eigen::Vector3d::Constant(reader->positive(Quantity::number));
  const auto parts = reader->items(3, "a number or a list of three");
  return {parts[0].positive(Quantity::number), parts[1].positive(Quantity::number),
          parts[2].positive(Quantity::number)};
}

MeshBody read_mesh(const ConfigReader& object, const Packages& packages,
                   const std::filesystem::path& mesh_cache) {
  MeshOptions options;
  options.convex_error = kConvexError;
  options.turn_up_axis = true;
  options.cache = mesh_cache;
  if (const auto error = object.find("convex_error"))
    options.convex_error = read_convex_error(*error);
  if (const auto sheet = object.find("sheet"))
    options.sheet = sheet->choice({"true", "false"}) == "true";
  return load_mesh(find_file(object.at("mesh"), packages), read_scale(object.find("scale")),
                   options);
}

Geometry read_geometry(const ConfigReader& object, const std::string& shape) {
  const ConfigReader reader = object.at(shape);
  if (shape == "box") {
    const auto sizes = reader.items(3, "[x, y, z], the full edge lengths in m");
    return Box{{read_size(sizes[0]), read_size(sizes[1]), read_size(sizes[2])}};
  }
  if (shape == "cylinder") {
    const auto sizes = reader.items(2, "[radius, length] in m");
    return Cylinder{read_size(sizes[0]), read_size(sizes[1])};
  }
  return Sphere{read_size(reader)};
}

std::string read_link(const ConfigReader& reader, const Robot& robot) {
  std::string name = reader.text();
  if (robot.find_link(name) != nullptr) return name;
  std::vector<std::string> known;
  for (const Link& link : robot.links()) known.push_back(link.name);
  reader.fail("no link '" + name + "'", "one of the robot, such as " + similar_names(name, known));
}

SceneObject read_object(const ConfigReader& reader, const Robot& robot, const Packages& packages,
                        const std::filesystem::path& mesh_cache,
                        std::vector<std::string>& warnings) {
  reader.expect_keys({"name", "link", "box", "cylinder", "sphere", "mesh", "scale", "convex_error",
                      "sheet", "xyz", "rpy"});
  std::vector<std::string> given;
  for (const std::string& shape : kShapes)
    if (reader.find(shape)) given.push_back(shape);
  if (given.size() != 1)
    reader.fail(given.empty() ? "no shape" : "both " + given[0] + " and " + given[1],
                "one of box, cylinder, sphere, mesh");
  for (const char* key : {"scale", "convex_error", "sheet"})
    if (const auto of_mesh = reader.find(key); of_mesh && given[0] != "mesh")
      of_mesh->fail("only a mesh has this key");

  SceneObject object;
  object.name = reader.at("name").text();
  if (const auto link = reader.find("link")) object.link = read_link(*link, robot);
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  if (const auto position = reader.find("xyz")) xyz = position->vector(Quantity::length);
  if (const auto angles = reader.find("rpy")) rpy = read_rpy(*angles);
  const Pose pose = pose_from_xyz_rpy(xyz, rpy);
  if (given[0] != "mesh") {
    object.shapes.push_back({read_geometry(reader, given[0]), pose});
    return object;
  }
  MeshBody body = read_mesh(reader, packages, mesh_cache);
  for (ConvexHull& piece : body.pieces) object.shapes.push_back({std::move(piece), pose});
  object.convex_error = body.error;
  for (const std::string& warning : body.warnings)
    warnings.push_back("object '" + object.name + "': " + warning);
  return object;
}

std::vector<std::string> body_names(const Robot& robot, const std::vector<SceneObject>& objects) {
  std::vector<std::string> names;
  for (const Link& link : robot.links()) names.push_back(link.name);
  for (const SceneObject& object : objects) names.push_back(object.name);
  return names;
}

std::string read_body_name(const ConfigReader& reader, const std::vector<std::string>& known) {
  std::string name = reader.text();
  if (std::find(known.begin(), known.end(), name) == known.end())
    reader.fail("no link or object '" + name + "'",
                "one of the robot or the scene, such as " + similar_names(name, known));
  return name;
}

std::vector<Scene::Names> read_pairs(const ConfigReader& reader,
                                     const std::vector<std::string>& known) {
  std::vector<Scene::Names> pairs;
  for (const ConfigReader& pair : reader.items()) {
    const auto names = pair.items(2, "[link or object, link or object]");
    pairs.emplace_back(read_body_name(names[0], known), read_body_name(names[1], known));
  }
  if (pairs.empty()) reader.fail("no pairs", "at least one, or `collision: off`");
  return pairs;
}

void read_collision(const ConfigReader& reader, const Robot& robot, Scene& scene) {
  if (reader.is_map()) {
    reader.expect_keys({"pairs"});
    scene.scope = CollisionScope::pairs;
    scene.pairs = read_pairs(reader.at("pairs"), body_names(robot, scene.objects));
  } else if (reader.is_word("off")) {
    scene.scope = CollisionScope::off;
  } else if (!reader.is_word("all")) {
    reader.fail("unknown scope", "all, off or {pairs: [[link, object], ...]}");
  }
}

}  // namespace

Scene read_scene(const std::optional<ConfigReader>& reader, const Robot& robot,
                 const Packages& packages, const std::filesystem::path& mesh_cache) {
  Scene scene;
  if (!reader) return scene;
  reader->expect_keys({"collision", "objects", "clearance"});
  if (const auto objects = reader->find("objects")) {
    for (const ConfigReader& item : objects->items()) {
      SceneObject object = read_object(item, robot, packages, mesh_cache, scene.warnings);
      const std::vector<std::string> taken = body_names(robot, scene.objects);
      if (std::find(taken.begin(), taken.end(), object.name) != taken.end())
        item.at("name").fail("'" + object.name + "' is the name of another link or object");
      scene.objects.push_back(std::move(object));
    }
  }
  if (const auto collision = reader->find("collision")) read_collision(*collision, robot, scene);
  if (const auto clearance = reader->find("clearance"))
    scene.clearance = clearance->not_negative(Quantity::length);
  return scene;
}

}  // namespace wristwise
