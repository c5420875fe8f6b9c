#include "picture/joint_profiles_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/peaks.hpp"
#include "picture/joint_series.hpp"
#include "picture/joint_unit.hpp"
#include "picture/percent.hpp"
#include "picture/picture_heading.hpp"

namespace wristwise {

namespace {

constexpr std::array<const char*, 4> kNames = {"position", "velocity", "acceleration", "jerk"};
constexpr std::size_t kColumns = kNames.size();
constexpr double kPanelWidth = 240, kPanelHeight = 92, kGap = 14, kBelow = 28, kHeading = 20;
constexpr std::array<double, kColumns> kNearLimit = {0.9, 0.4, 0.4, 0.4};  // share, then in view
constexpr double kRoom = 0.06;        // of the range, above and below the lines
constexpr double kLeastRange = 1e-6;  // in a panel, in its unit
constexpr double kLeastShareOfLimits = 1e-6;
constexpr double kLeastShareOfValue = 1e-4;
constexpr double kJointsInOnePixel = 8;  // of more joints the lines are thinned more
constexpr std::size_t kSamples = 480;    // of a curve, or more

/// The lower and the upper limit of a joint's derivative in the unit it is shown in; infinite where
/// there is none.
PlotRange limits_of(const Robot& robot, std::size_t j, int derivative) {
  const Joint& joint = robot.joints()[j];
  const double factor = joint_unit(joint).factor;
  if (derivative == 0) return {factor * joint.lower, factor * joint.upper};
  const double limit = factor * derivative_limits(robot, derivative)[static_cast<Eigen::Index>(j)];
  return {-limit, limit};
}

/// Smaller motion is drawn as none: it is noise, and its ticks would have too many digits.
double least_range(const PlotRange& values, const PlotRange& limits) {
  const double size = std::max(std::abs(values.from), std::abs(values.to));
  const double width = limits.to - limits.from;
  return std::max({kLeastRange, kLeastShareOfValue * size,
                   std::isfinite(width) ? kLeastShareOfLimits * width : 0});
}

PlotRange with(const PlotRange& range, double value) {
  return {std::min(range.from, value), std::max(range.to, value)};
}

/// What is in view: all lines, and the limits that they come near or exceed.
PlotRange range_in_view(const std::vector<PlotLine>& lines, const PlotRange& limits, double near) {
  PlotRange range = range_of(lines).value_or(PlotRange{0, 0});
  if (limits.to > 0 && range.to > near * limits.to) range = with(range, limits.to);
  if (limits.from < 0 && range.from < near * limits.from) range = with(range, limits.from);
  const double least = least_range(range, limits);
  if (range.to - range.from < least) {
    const double middle = 0.5 * (range.from + range.to);
    range = {middle - 0.5 * least, middle + 0.5 * least};
  }
  const double room = kRoom * (range.to - range.from);
  return {range.from - room, range.to + room};
}

/// Four digits, or a whole number.
std::string shown(double limit) {
  return std::abs(limit) < 1e4 ? fmt::format("{:.4g}", limit) : fmt::format("{:.0f}", limit);
}

std::string limit_note(const PlotRange& limits, int derivative, const PlotLine& result) {
  if (!std::isfinite(limits.from) || !std::isfinite(limits.to)) return "no limit";
  if (derivative == 0) return fmt::format("limits {} to {}", shown(limits.from), shown(limits.to));
  const auto range = range_of({result});
  if (!range) return "limit " + shown(limits.to);
  const double peak = std::max(std::abs(range->from), std::abs(range->to));
  return percent(peak / limits.to) + " of limit " + shown(limits.to);
}

/// A joint in each line, a derivative in each column.
class ProfilesPicture {
 public:
  explicit ProfilesPicture(const MotionPicture& motions)
      : motions_(motions),
        joints_(motions.robot.joints().size()),
        legend_(motion_legend(motions)),
        width_(kColumns * (plot::kLeftMargin + kPanelWidth + kGap)),
        top_(heading_height_with_limit()),
        picture_(width_, top_ + kHeading + static_cast<double>(joints_) * line_height() + kBelow) {
    for (const ShownMotion& motion : motions.motions)
      for (std::size_t k = 0; k < kColumns; ++k)
        series_[k].push_back(joint_series(motion, static_cast<int>(k), kSamples));
  }

  std::string draw() {
    draw_heading(motions_.title, legend_, width_, picture_);
    for (std::size_t k = 0; k < kColumns; ++k) {
      picture_.text(left(k) + 0.5 * kPanelWidth, top_ + 12, kNames[k], SvgAnchor::middle, 14);
      for (std::size_t j = 0; j < joints_; ++j) draw_joint(j, k);
      picture_.text(left(k) + 0.5 * kPanelWidth,
                    top_ + kHeading + static_cast<double>(joints_) * line_height() + 18, "time, s",
                    SvgAnchor::middle, plot::kTextSize);
    }
    return picture_.str();
  }

 private:
  double heading_height_with_limit() {
    legend_.push_back({"limit", LegendEntry::Sign::line, plot::kLimit, plot::kLimitDash});
    return heading_height(legend_, width_);
  }

  static double line_height() { return plot::kTitleHeight + kPanelHeight + kGap; }
  static double left(std::size_t k) {
    return plot::kLeftMargin + static_cast<double>(k) * (plot::kLeftMargin + kPanelWidth + kGap);
  }

  void draw_joint(std::size_t j, std::size_t k) {
    const Joint& joint = motions_.robot.joints()[j];
    const auto derivative = static_cast<int>(k);
    PlotPanel panel;
    panel.name = joint.name + " " + kNames[k];
    panel.title = joint.name;
    panel.unit = derivative_unit(joint, derivative);
    panel.shaded = motions_.runs;
    for (std::size_t i = motions_.motions.size(); i-- > 0;)
      panel.lines.push_back({motions_.motions[i].name, MotionPicture::colour(i),
                             series_[k][i].joint(static_cast<int>(j), joint_unit(joint).factor)});
    const PlotRange limits = limits_of(motions_.robot, j, derivative);
    panel.limits = {limits.from, limits.to};
    panel.note = limit_note(limits, derivative, panel.lines.back());
    if (!range_of(panel.lines)) panel.empty_text = "too few points";
    const PlotRange range = range_in_view(panel.lines, limits, kNearLimit[k]);
    const double top =
        top_ + kHeading + static_cast<double>(j) * line_height() + plot::kTitleHeight;
    draw_panel(panel, time_axis(motions_.time, left(k), kPanelWidth),
               {range.from, range.to, top + kPanelHeight, top},
               std::max(1.0, static_cast<double>(joints_) / kJointsInOnePixel), j + 1 == joints_,
               picture_);
  }

  const MotionPicture& motions_;
  std::size_t joints_;
  std::vector<LegendEntry> legend_;
  double width_, top_;
  SvgPicture picture_;
  std::array<std::vector<JointSeries>, kColumns> series_;
};

}  // namespace

std::string joint_profiles_svg(const MotionPicture& motions) {
  return ProfilesPicture(motions).draw();
}

}  // namespace wristwise
