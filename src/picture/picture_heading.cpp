#include "picture/picture_heading.hpp"

#include "picture/text_width.hpp"

namespace wristwise {

namespace {

constexpr double kTitle = 15, kTitleBase = 24, kLegendBase = 46, kBelow = -6, kSide = 12;  // px

}  // namespace

double draw_heading(const std::string& title, const std::vector<LegendEntry>& legend, double width,
                    SvgPicture& picture) {
  picture.text(kSide, kTitleBase, fitted(title, kTitle, width - 2 * kSide), SvgAnchor::start,
               kTitle);
  return kLegendBase + kBelow + draw_legend(legend, kSide, kLegendBase, width - 2 * kSide, picture);
}

double heading_height(const std::vector<LegendEntry>& legend, double width) {
  SvgPicture nothing(width, 1);
  return draw_heading("", legend, width, nothing);
}

std::vector<LegendEntry> motion_legend(const MotionPicture& motions) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < motions.motions.size(); ++i)
    legend.push_back({motions.motions[i].name, LegendEntry::Sign::line, MotionPicture::colour(i)});
  if (!motions.runs.empty())
    legend.push_back({"run-in, run-out", LegendEntry::Sign::area, plot::kShade});
  return legend;
}

PlotAxis time_axis(const PlotRange& time, double left, double width) {
  constexpr double kAroundMoment = 0.5;  // s
  if (time.to > time.from) return {time.from, time.to, left, left + width};
  return {time.from - kAroundMoment, time.to + kAroundMoment, left, left + width};
}

}  // namespace wristwise
