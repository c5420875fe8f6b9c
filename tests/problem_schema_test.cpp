// The readers, docs/problem-file.schema.json and docs/problem-file.md know the same keys. What the
// readers know they say themselves: a word where a map belongs is answered by the list of its keys.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "gantry_urdf.hpp"
#include "invalid_input.hpp"
#include "temporary_folder.hpp"
#include "wristwise/placement.hpp"
#include "wristwise/problem.hpp"

namespace wristwise {
namespace {

using Json = nlohmann::json;
using Keys = std::set<std::string>;

const std::string kDocs = std::string(WRISTWISE_SOURCE_DIR) + "/docs/";
constexpr const char* kRobot = "robot: {urdf: gantry.urdf}\n";
constexpr const char* kPath =
    "path: {speed: 1, waypoints: 3, segments: [line: {from: {xyz: [0, 0, 0]}, "
    "to: {xyz: [1, 0, 0]}}]}\n";

/// A map of the problem file, with a word in its place.
struct Place {
  std::string schema;   ///< where the schema has it
  std::string section;  ///< of the docs
  std::string problem;  ///< text of a problem
};

std::vector<Place> places() {
  const std::string robot = kRobot, with_path = robot + kPath;
  const auto segment = [&](const std::string& text) {
    return robot + "path: {speed: 1, waypoints: 3, segments: [" + text + "]}\n";
  };
  const std::string path = "/properties/path", item = path + "/properties/segments/items";
  return {
      {"", "", "word: 1\n"},
      {"/properties/robot", "robot", "robot: word\npath: word\n"},
      {"/properties/robot/properties/ik", "robot",
       std::string("robot: {urdf: gantry.urdf, ik: word}\n") + kPath},
      {"/properties/scene", "scene", with_path + "scene: word\n"},
      {"/properties/scene/properties/objects/items", "scene",
       with_path + "scene: {objects: [word]}\n"},
      {path, "path", robot + "path: word\n"},
      {path + "/properties/tolerance", "path", robot + "path: {tolerance: word}\n"},
      {item, "path", segment("word")},
      {item + "/properties/line", "path", segment("line: word")},
      {item + "/properties/arc", "path", segment("arc: word")},
      {item + "/properties/tolerance", "path",
       segment("{line: {from: {xyz: [0, 0, 0]}, to: {xyz: [1, 0, 0]}}, tolerance: word}")},
      {"/$defs/pose", "path", robot + "path: {frame: word}\n"},
      {"/$defs/end_pose", "path", segment("line: {from: word}")},
      {"/properties/cost", "cost", with_path + "cost: word\n"},
      {"/properties/cost/properties/euler", "cost", with_path + "cost: {euler: word}\n"},
      {"/properties/cost/properties/position", "cost", with_path + "cost: {position: word}\n"},
      {"/properties/cost/properties/singularity", "cost",
       with_path + "cost: {singularity: word}\n"},
      {"/properties/cost/properties/posture", "cost", with_path + "cost: {posture: word}\n"},
      {"/properties/graph", "graph", with_path + "graph: word\n"},
      {"/properties/graph/properties/samples", "graph", with_path + "graph: {samples: word}\n"},
      {"/properties/refine", "refine", with_path + "refine: word\n"},
      {"/properties/controller", "controller", with_path + "controller: word\n"},
      {item + "/properties/poses/oneOf/1", "path", segment("poses: {word: 1}")},
      {"/properties/export", "export", with_path + "export: word\n"},
      {"/properties/export/properties/krl", "export", with_path + "export: {krl: word}\n"},
      {"/properties/export/properties/rapid", "export", with_path + "export: {rapid: word}\n"},
      {"/properties/export/properties/ls", "export", with_path + "export: {ls: word}\n"},
      {"/properties/placement", "placement", with_path + "placement: word\n"},
      {"/properties/placement/properties/weights", "placement",
       with_path + "placement: {weights: word}\n"},
      {"/properties/placement/properties/margins", "placement",
       with_path + "placement: {margins: word}\n"},
  };
}

/// The keys that the complaint lists.
Keys accepted_keys(const std::string& problem) {
  test::TemporaryFolder folder;
  folder.write("gantry.urdf", test::kGantryUrdf);
  const std::string message =
      test::invalid_input([&] { load_problem(folder.write("a.yaml", problem)); });
  std::smatch match;
  if (!std::regex_search(message, match, std::regex("expected (?:keys:|one of) (.*)"))) {
    ADD_FAILURE() << message;
    return {};
  }
  Keys keys;
  std::istringstream list(match[1]);
  for (std::string key; std::getline(list >> std::ws, key, ',');) keys.insert(key);
  keys.erase("turn");  // a joint of the gantry, which may be sampled
  return keys;
}

Json schema() { return Json::parse(std::ifstream(kDocs + "problem-file.schema.json")); }

Keys keys_of_schema(const Json& schema, const std::string& place) {
  Keys keys;
  for (const auto& item : schema.at(Json::json_pointer(place)).at("properties").items())
    keys.insert(item.key());
  return keys;
}

/// The whole page, or one of its sections.
std::string docs(const std::string& section) {
  std::ostringstream text;
  text << std::ifstream(kDocs + "problem-file.md").rdbuf();
  const std::string page = text.str();
  if (section.empty()) return page;
  const std::size_t start = page.find("\n## " + section);
  if (start == std::string::npos) return {};
  return page.substr(start, page.find("\n## ", start + 1) - start);
}

/// The words of headings and of code, which is between backticks.
Keys documented(const std::string& text) {
  Keys words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    bool is_code = line.rfind("## ", 0) == 0;
    for (std::string part; std::getline(parts, part, '`'); is_code = !is_code) {
      const std::regex word("\\w+");
      if (!is_code) continue;
      for (std::sregex_iterator i(part.begin(), part.end(), word), end; i != end; ++i)
        words.insert(i->str());
    }
  }
  return words;
}

TEST(ProblemSchema, HasTheKeysThatAreRead) {
  const Json of_docs = schema();
  for (const Place& place : places()) {
    const Keys accepted = accepted_keys(place.problem);
    EXPECT_FALSE(accepted.empty()) << place.schema;
    EXPECT_EQ(keys_of_schema(of_docs, place.schema), accepted) << place.schema;
  }
}

// Closed, or by names of joints with values of one kind.
TEST(ProblemSchema, EveryMapOfItIsClosed) {
  const Json flat = schema().flatten();
  std::size_t maps = 0;
  for (const auto& [pointer, value] : flat.items()) {
    const std::size_t end = pointer.rfind("/type");
    if (end == std::string::npos || end + 5 != pointer.size() || value != "object") continue;
    ++maps;
    const std::string others = pointer.substr(0, end) + "/additionalProperties";
    const bool of_joints = flat.contains(others + "/$ref") || flat.contains(others + "/type");
    EXPECT_TRUE(of_joints || flat.value(others, Json(true)) == false) << pointer;
  }
  EXPECT_GE(maps, places().size());
}

TEST(ProblemSchema, TheDocsNameEveryKey) {
  for (const Place& place : places()) {
    const Keys words = documented(docs(place.section));
    for (const std::string& key : accepted_keys(place.problem))
      EXPECT_EQ(words.count(key), 1U) << place.schema << ": " << key;
  }
  const Keys words = documented(docs("graph"));
  EXPECT_EQ(words.count("posture"), 0U);   // of another section
  EXPECT_EQ(words.count("distinct"), 0U);  // prose
}

TEST(ProblemSchema, NumbersOfItsDefaultsAreThoseOfTheHeaders) {
  const Json of_docs = schema();
  const auto number = [&](const std::string& section, const std::string& key) {
    return of_docs.at("properties")
        .at(section)
        .at("properties")
        .at(key)
        .at("default")
        .get<double>();
  };
  EXPECT_EQ(number("graph", "seeds"), GraphOptions().seeds);
  EXPECT_EQ(number("graph", "spare_seeds"), GraphOptions().spare_seeds);
  EXPECT_EQ(number("graph", "seed_separation"), GraphOptions().seed_separation);
  EXPECT_EQ(number("graph", "max_stray"), GraphOptions().max_stray);
  EXPECT_EQ(number("graph", "sparse_deviation"), GraphOptions().sparse_deviation);
  EXPECT_EQ(number("refine", "max_rounds"), RefineOptions().max_rounds);
  EXPECT_EQ(number("refine", "max_iterations"), RefineOptions().max_iterations);
  EXPECT_EQ(number("cost", "joint_motion"), CostOptions().joint_motion);
  EXPECT_EQ(number("cost", "acceleration"), CostOptions().acceleration);
  EXPECT_EQ(number("cost", "jerk"), CostOptions().jerk);
  EXPECT_EQ(number("placement", "map"), PlacementOptions().map_points);
  EXPECT_EQ(number("placement", "seed"), PlacementOptions().seed);
}

}  // namespace
}  // namespace wristwise
