// Descriptions and meshes that cannot be used, at the command line: one clear line and status 2, or
// a warning.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "mesh_samples.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::file_text;
using test::ProgramRun;
using test::replaced;
using test::run_program;
using test::TemporaryFolder;
using test::Triangles;

const char* const kUrdf = R"(<robot name="r">
  <link name="a"><collision><geometry><mesh filename="part.stl"/></geometry></collision></link>
  <link name="b"/> <link name="c"/>
  <joint name="ab" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="0" velocity="1"/></joint>
  <joint name="bc" type="revolute"><parent link="b"/><child link="c"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="0" velocity="1"/></joint>
</robot>
)";

class BadDescription : public testing::Test {
 protected:
  BadDescription() {
    folder_.write("part.stl", test::binary_stl(cube_));
    folder_.write("r.urdf", kUrdf);
  }

  ProgramRun info(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"info", "r.urdf"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder_.path(), arguments);
  }

  void expect_refused(const ProgramRun& run, const std::string& part) {
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
  }

  void expect_urdf_refused(const std::string& old_part, const std::string& new_part,
                           const std::string& told) {
    folder_.write("r.urdf", replaced(kUrdf, old_part, new_part));
    expect_refused(info(), told);
    folder_.write("r.urdf", kUrdf);
  }

  void expect_mesh_refused(const std::string& bytes, const std::string& told) {
    folder_.write("part.stl", bytes);
    expect_refused(info(), told);
    folder_.write("part.stl", test::binary_stl(cube_));
  }

  const Triangles cube_ = test::prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  TemporaryFolder folder_;
};

TEST_F(BadDescription, SoundOneIsShown) {
  const ProgramRun run = info();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("r: a to c, 2 joints"), std::string::npos) << run.out;
}

TEST_F(BadDescription, OfChains) {
  expect_urdf_refused("</robot>",
                      "<joint name='ac' type='fixed'><parent link='a'/><child link='c'/></joint>"
                      "</robot>",
                      "r.urdf:8: link 'c' hangs on joint 'bc' and on 'ac'");
  expect_urdf_refused("<parent link=\"a\"/>", "<parent link=\"c\"/>", "is part of a loop");
  expect_urdf_refused("<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 0 0\"/>",
                      "joint 'bc': the axis has no direction");
  expect_urdf_refused("lower=\"-1\"", "lower=\"2\"",
                      "joint 'ab': its lower position limit exceeds");
  expect_urdf_refused("part.stl", "package://nowhere/part.stl",
                      "mesh 'package://nowhere/part.stl' is not found");
}

TEST_F(BadDescription, OfMeshes) {
  const std::string sound = test::binary_stl(cube_);
  expect_mesh_refused("", "part.stl: the file is empty");
  expect_mesh_refused(test::binary_stl({}), "part.stl");
  expect_mesh_refused(sound.substr(0, sound.size() - 10),
                      "12 triangles has 674 bytes; expected 684");
  Triangles broken = cube_;
  broken[3][1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_mesh_refused(test::binary_stl(broken), "part.stl: a vertex is not finite");
}

TEST_F(BadDescription, OfSrdf) {
  expect_refused(info({"--srdf", "none.srdf"}), "none.srdf: no such file");
  folder_.write("r.srdf",
                "<robot name='r'>\n<group name='arm'><chain base_link='a'/></group></robot>");
  expect_refused(info({"--srdf", "r.srdf"}), "r.srdf:2: chain has no tip_link");
  folder_.write("r.srdf", "<robot name='r'><group name='arm'>");
  expect_refused(info({"--srdf", "r.srdf"}), "not valid XML");
  folder_.write("r.srdf",
                "<robot name='r'><group name='arm'><chain base_link='a' tip_link='d'/>"
                "</group><disable_collisions link1='a' link2='bb'/></robot>");
  expect_refused(info({"--srdf", "r.srdf", "--group", "arm"}), "no link 'd' in the URDF");
  expect_refused(info({"--srdf", "r.srdf", "--group", "amr"}), "there is no group 'amr'");
  expect_refused(info({"--group", "arm"}), "no SRDF");
  const ProgramRun run = info({"--srdf", "r.srdf"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("warning: r.srdf names 'bb', which is no link of the robot; the nearest "
                         "is 'b'"),
            std::string::npos)
      << run.out;
}

TEST_F(BadDescription, MeshesInMillimetresAreWarnedOf) {
  folder_.write("part.stl", test::binary_stl(test::prism({{0, 0}, {300, 0}, {300, 9}}, 80)));
  const ProgramRun run = info();
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("part.stl: it is 300 m across; in mm it needs the scale 0.001"),
            std::string::npos)
      << run.out;
}

class BadPart : public testing::Test {
 protected:
  ProgramRun plan(const std::string& mesh_keys, const std::vector<std::string>& more = {}) {
    const std::string robot = std::string(WRISTWISE_SOURCE_DIR) + "/robots/kuka_kr5_arc/";
    folder_.write(
        "p.yaml",
        "robot: {urdf: " + robot + "kuka_kr5_arc.urdf, tip_link: tool0, limits: " + robot +
            "joint_limits.yaml}\nscene:\n  collision: {pairs: [[link_6, part]]}\n  objects:\n"
            "    - {name: part, mesh: part.stl, " +
            mesh_keys +
            "}\n"
            "path:\n  speed: 0.01\n  waypoints: 3\n  segments:\n    - line:\n"
            "        from: {xyz: [0.9, -0.01, 0.5], rpy: [0, 180 deg, 0]}\n"
            "        to: {xyz: [0.9, 0.01, 0.5], rpy: [0, 180 deg, 0]}\n");
    std::vector<std::string> arguments = {"plan", "p.yaml", "--mode", "graph-only", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder_.path(), arguments);
  }

  bool cached() const { return std::filesystem::exists(folder_.path() / ".wristwise_cache"); }

  TemporaryFolder folder_;
};

TEST_F(BadPart, InMillimetresIsWarnedOfInTheResult) {
  folder_.write("part.stl",
                test::binary_stl(test::prism({{0, 0}, {300, 0}, {300, 9}}, 80, {0, 0, -1e3})));
  const ProgramRun run = plan("xyz: [0, 0, -1]");
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const std::string told = "part.stl: it is 300 m across; in mm it needs the scale 0.001";
  EXPECT_NE(run.out.find(told), std::string::npos) << run.out;
  const auto result = nlohmann::json::parse(file_text(folder_.path() / "out" / "result.json"));
  ASSERT_FALSE(result["warnings"].empty());
  EXPECT_NE(result["warnings"][0].get<std::string>().find(told), std::string::npos);
}

TEST_F(BadPart, CacheIsWrittenBesideTheProblemUnlessSwitchedOff) {
  folder_.write("part.stl",
                test::ascii_stl(test::prism({{0, 0}, {.2, 0}, {.2, .1}, {.1, .1}, {0, .2}}, 0.1)));
  EXPECT_EQ(plan("xyz: [0, 0, -1]", {"--no-cache"}).exit_code, 0);
  EXPECT_FALSE(cached());
  EXPECT_EQ(plan("xyz: [0, 0, -1]").exit_code, 0);
  EXPECT_TRUE(cached());
  const std::string first = file_text(folder_.path() / "out" / "trajectory.csv");
  EXPECT_EQ(plan("xyz: [0, 0, -1]").exit_code, 0);
  EXPECT_EQ(file_text(folder_.path() / "out" / "trajectory.csv"), first);
}

TEST_F(BadPart, KeysOfMeshesBelongToMeshes) {
  folder_.write("part.stl", test::ascii_stl(test::prism({{0, 0}, {.2, 0}, {.2, .1}}, 0.1)));
  for (const char* keys : {"convex_error: 0", "convex_error: -1 mm", "convex_error: 2 deg",
                           "convex_error: fine", "sheet: maybe", "scale: 0"}) {
    const ProgramRun run = plan(keys);
    EXPECT_EQ(run.exit_code, 2) << keys;
    EXPECT_NE(run.err.find("p.yaml:5: scene.objects[0]."), std::string::npos) << run.err;
  }
  folder_.write("part.stl", "");
  EXPECT_EQ(plan("scale: 1").exit_code, 2);
}

}  // namespace
}  // namespace wristwise
