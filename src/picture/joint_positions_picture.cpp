#include "picture/joint_positions_picture.hpp"

#include <algorithm>
#include <array>

#include "picture/joint_series.hpp"
#include "picture/joint_unit.hpp"
#include "picture/picture_heading.hpp"

namespace wristwise {

namespace {

/// Okabe and Ito's, told apart by colour-blind people too; the ninth and later joints are dashed.
constexpr std::array<const char*, 8> kColours = {"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                                 "#cc79a7", "#56b4e9", "#7a5c00", "#000000"};
constexpr const char* kDash = "6 3";
constexpr double kPanelWidth = 420, kPanelHeight = 280, kGap = 16, kBelow = 40;
constexpr double kRoom = 0.06;         // of the range, above and below the lines
constexpr double kLeastRange = 1e-3;   // rad or mm
constexpr std::size_t kSamples = 840;  // of a curve, or more

/// The joints that are shown in one unit.
struct JointKind {
  bool prismatic;
  std::vector<std::size_t> joints;
};

std::vector<JointKind> kinds_of(const Robot& robot) {
  std::vector<JointKind> kinds;
  for (const bool prismatic : {false, true}) {
    JointKind kind{prismatic, {}};
    for (std::size_t j = 0; j < robot.joints().size(); ++j)
      if ((robot.joints()[j].type == JointType::prismatic) == prismatic) kind.joints.push_back(j);
    if (!kind.joints.empty()) kinds.push_back(std::move(kind));
  }
  return kinds;
}

const char* colour_of(std::size_t joint) { return kColours[joint % kColours.size()]; }
std::string dash_of(std::size_t joint) { return joint < kColours.size() ? "" : kDash; }

std::vector<LegendEntry> legend_of(const MotionPicture& motions) {
  std::vector<LegendEntry> legend;
  for (std::size_t j = 0; j < motions.robot.joints().size(); ++j)
    legend.push_back(
        {motions.robot.joints()[j].name, LegendEntry::Sign::line, colour_of(j), dash_of(j)});
  if (!motions.runs.empty())
    legend.push_back({"run-in, run-out", LegendEntry::Sign::area, plot::kShade});
  return legend;
}

PlotPanel panel_of(const MotionPicture& motions, std::size_t motion, const JointKind& kind) {
  const JointSeries series = joint_series(motions.motions[motion], 0, kSamples);
  PlotPanel panel;
  const JointUnit unit = joint_unit(motions.robot.joints()[kind.joints.front()]);
  panel.name = motions.motions[motion].name + ", " + unit.name;
  panel.title = motions.motions[motion].name;
  panel.unit = unit.name;
  panel.shaded = motions.runs;
  for (const std::size_t j : kind.joints)
    panel.lines.push_back({motions.robot.joints()[j].name, colour_of(j),
                           series.joint(static_cast<int>(j), unit.factor), 1.6, dash_of(j)});
  return panel;
}

PlotRange range_in_view(const std::vector<PlotPanel>& panels) {
  std::vector<PlotLine> lines;
  for (const PlotPanel& panel : panels)
    lines.insert(lines.end(), panel.lines.begin(), panel.lines.end());
  const PlotRange range = range_of(lines).value_or(PlotRange{0, 0});
  const double room = std::max(kRoom * (range.to - range.from), kLeastRange);
  return {range.from - room, range.to + room};
}

}  // namespace

std::string joint_positions_svg(const MotionPicture& motions) {
  const auto columns = static_cast<double>(motions.motions.size());
  const std::vector<JointKind> kinds = kinds_of(motions.robot);
  const std::vector<LegendEntry> legend = legend_of(motions);
  const double width = columns * (plot::kLeftMargin + kPanelWidth + kGap);
  const double line_height = plot::kTitleHeight + kPanelHeight + kBelow;
  double top = heading_height(legend, width);
  SvgPicture picture(width, top + static_cast<double>(kinds.size()) * line_height);
  draw_heading(motions.title, legend, width, picture);
  for (const JointKind& kind : kinds) {
    std::vector<PlotPanel> panels;
    for (std::size_t i = motions.motions.size(); i-- > 0;)
      panels.push_back(panel_of(motions, i, kind));
    const PlotRange range = range_in_view(panels);
    double left = plot::kLeftMargin;
    for (const PlotPanel& panel : panels) {
      const double frame_top = top + plot::kTitleHeight;
      draw_panel(panel, time_axis(motions.time, left, kPanelWidth),
                 {range.from, range.to, frame_top + kPanelHeight, frame_top}, 1, true, picture);
      picture.text(left + 0.5 * kPanelWidth, frame_top + kPanelHeight + 32, "time, s",
                   SvgAnchor::middle, plot::kTextSize);
      left += kPanelWidth + kGap + plot::kLeftMargin;
    }
    top += line_height;
  }
  return picture.str();
}

}  // namespace wristwise
