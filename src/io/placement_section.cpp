#include <algorithm>
#include <cmath>

#include "io/coordinate_keys.hpp"
#include "io/problem_sections.hpp"
#include "similar_names.hpp"

namespace wristwise {

namespace {

constexpr double kWholeTurn = 6.283185307179586;

/// A number to either side, or [lower, upper].
void read_range(const ConfigReader& reader, Quantity quantity, double& lower, double& upper) {
  if (reader.is_list()) {
    const auto bounds = reader.items(2, "a number or [lower, upper]");
    lower = bounds[0].quantity(quantity);
    upper = bounds[1].quantity(quantity);
  } else {
    upper = reader.not_negative(quantity);
    lower = -upper;
  }
  if (lower > upper) reader.fail("the lower bound is above the upper", "[lower, upper]");
  if (quantity == Quantity::angle && upper - lower > kWholeTurn + 1e-9)
    reader.fail("wider than a whole turn", "a range of at most 360 deg");
}

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneObject& object : scene.objects) names.push_back(object.name);
  return names;
}

std::vector<std::string> read_with(const ConfigReader& reader, const Scene& scene) {
  if (reader.is_word("all")) return names_of(scene);
  const std::vector<std::string> known = names_of(scene);
  if (!reader.is_list()) reader.fail("no list of objects", "all, or a list of their names");
  std::vector<std::string> names;
  for (const ConfigReader& item : reader.items()) {
    std::string name = item.text();
    if (std::find(known.begin(), known.end(), name) == known.end())
      item.fail("no object '" + name + "'",
                known.empty() ? "none, the scene has no objects"
                              : "one of the scene, such as " + similar_names(name, known));
    if (std::find(names.begin(), names.end(), name) != names.end())
      item.fail("'" + name + "' is given twice", "each object once");
    names.push_back(std::move(name));
  }
  return names;
}

void read_weights(const ConfigReader& reader, PlacementOptions& options) {
  reader.expect_keys({"speed", "singularity", "clearance"});
  const auto read = [&reader](const char* key, double& weight) {
    if (const auto value = reader.find(key)) weight = value->not_negative(Quantity::number);
  };
  read("speed", options.speed_weight);
  read("singularity", options.singularity_weight);
  read("clearance", options.clearance_weight);
}

void read_margins(const ConfigReader& reader, PlacementOptions& options) {
  reader.expect_keys({"singularity", "clearance"});
  if (const auto margin = reader.find("singularity")) {
    options.singularity_margin = margin->not_negative(Quantity::number);
    if (options.singularity_margin > 1) margin->fail("above 1", "0 to 1");
  }
  if (const auto margin = reader.find("clearance"))
    options.clearance_margin = margin->not_negative(Quantity::length);
}

int read_map(const ConfigReader& reader) {
  if (reader.is_word("off") || reader.is_word("false")) return 0;
  const int points = reader.whole_number(2);
  if (points > 1000) reader.fail("too many", "2 to 1000 points, or off");
  return points;
}

}  // namespace

PlacementOptions read_placement(const ConfigReader& reader, const Scene& scene) {
  std::vector<std::string> keys = {"move", "with",        "weights", "margins",
                                   "seed", "evaluations", "map",     "time_limit"};
  keys.insert(keys.end(), kCoordinateNames.begin(), kCoordinateNames.end());
  reader.expect_keys(keys);
  PlacementOptions options;
  if (const auto move = reader.find("move"))
    options.placed = move->choice({"part", "robot"}) == "part" ? Placed::part : Placed::robot;
  if (const auto with = reader.find("with")) {
    options.with = read_with(*with, scene);
  } else if (options.placed == Placed::part && !scene.objects.empty()) {
    reader.fail("nothing says which objects move with the part", "with: all, or a list of names");
  }
  for (int i = 0; i < 6; ++i) {
    if (const auto range = reader.find(kCoordinateNames[static_cast<std::size_t>(i)]))
      read_range(*range, coordinate_quantity(i), options.lower[i], options.upper[i]);
  }
  if (const auto weights = reader.find("weights")) read_weights(*weights, options);
  if (const auto margins = reader.find("margins")) read_margins(*margins, options);
  if (const auto seed = reader.find("seed"))
    options.seed = static_cast<std::uint32_t>(seed->whole_number(0));
  if (const auto evaluations = reader.find("evaluations"))
    options.evaluations = evaluations->whole_number(1);
  if (const auto map = reader.find("map")) options.map_points = read_map(*map);
  if (const auto limit = reader.find("time_limit"); limit && !limit->is_word("off"))
    options.time_limit = limit->positive(Quantity::time);
  return options;
}

}  // namespace wristwise
