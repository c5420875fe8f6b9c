#include "picture/motion_picture.hpp"

#include <gtest/gtest.h>

#include "plotted_motion.hpp"

namespace wristwise {
namespace {

namespace gantry = test::gantry;
using test::gantry_problem;
using test::PlotReader;
using test::Plotted;
using test::swinging_result;

const std::vector<std::string> kFiles = {"joints.svg", "joint_positions.svg", "tolerance.svg"};

TEST(MotionPictures, AreTheSameBytesEveryTime) {
  const Problem problem = gantry_problem();
  const PlanResult result = swinging_result(problem);
  const Plotted one(problem, result);
  EXPECT_EQ(one.names, kFiles);
  std::vector<std::string> first;
  for (const std::string& name : kFiles) first.push_back(one.text(name));
  const Plotted again(problem, result);
  for (std::size_t i = 0; i < kFiles.size(); ++i) EXPECT_EQ(again.text(kFiles[i]), first[i]);
}

TEST(MotionPictures, WithoutAMotionAreNoneAndTheOldOnesGo) {
  const Problem problem = gantry_problem();
  test::TemporaryFolder folder;
  EXPECT_EQ(write_motion_pictures(folder.path(), problem, swinging_result(problem), nullptr),
            kFiles);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    files += entry.path().extension() == ".svg" ? 1U : 100U;  // no drafts are left
  EXPECT_EQ(files, 3U);
  EXPECT_TRUE(write_motion_pictures(folder.path(), problem, {}, nullptr).empty());
  EXPECT_TRUE(write_motion_pictures(folder.path(), {}, {}, nullptr).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(MotionPictures, IntoAFolderThatIsNoneFail) {
  const Problem problem = gantry_problem();
  EXPECT_THROW(
      write_motion_pictures("/dev/null/nowhere", problem, swinging_result(problem), nullptr),
      std::runtime_error);
}

TEST(MotionPictures, TakeAnyNameAsText) {
  Problem problem = gantry_problem();
  problem.name = "</svg><script>\"&";
  Robot::Parts parts = problem.robot->parts();
  parts.joints[0].name = "<b>&\"";
  problem.robot = gantry::robot(parts);
  const Plotted plotted(problem, swinging_result(problem));
  for (const std::string& name : kFiles) {
    const PlotReader reader = plotted.read(name);
    EXPECT_EQ(reader.texts(reader.root())[0], problem.name + ": solved");
  }
  EXPECT_NE(plotted.read("joints.svg").panel("<b>&\" velocity"), nullptr);
}

TEST(JointPositions, AreOnePanelForEachMotionAndUnitToOneScale) {
  const Problem problem = gantry_problem();
  const PlanResult result = swinging_result(problem);
  const PlotReader reader = Plotted(problem, result).read("joint_positions.svg");
  for (const std::string motion : {"two-stage", "graph-only"}) {
    EXPECT_EQ(reader.lines(motion + ", rad"), std::vector<std::string>{"tilt"});
    EXPECT_EQ(reader.lines(motion + ", mm"), (std::vector<std::string>{"x", "y", "z"}));
    const auto line = reader.line(motion + ", rad", "tilt", motion + ", rad");
    const double pixel = std::abs(reader.value_axis(motion + ", rad").per_pixel);
    for (const double t : test::times_of(problem.task)) {
      const double tilt = motion == "two-stage" ? test::swing(t)[3] : 0;
      EXPECT_NEAR(test::at(line, t, 1e-2), tilt, 0.7 * pixel) << motion << t;
    }
  }
  EXPECT_EQ(reader.value_axis("two-stage, rad").per_pixel,
            reader.value_axis("graph-only, rad").per_pixel);
  EXPECT_LT(reader.frame("graph-only, rad", "x"), reader.frame("two-stage, rad", "x"));
}

}  // namespace
}  // namespace wristwise
