#include "picture/tolerance_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture/percent.hpp"
#include "picture/picture_heading.hpp"
#include "report/motion_samples.hpp"

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295, kMillimetre = 1e-3, kTurn = 360 * kDegree;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kCoordinates = 6;
constexpr double kPanelWidth = 430, kPanelHeight = 92, kGap = 30, kBelow = 24, kHeading = 20;
constexpr double kRoom = 0.06;         // of the range, above and below the lines
constexpr double kLeastRange = 1e-3;   // mm or deg
constexpr double kMostShare = 2.5;     // in view
constexpr double kLeastShare = 1.15;   // likewise
constexpr std::size_t kSamples = 860;  // of a motion, or all its rows

double unit_of(int k) { return k < 3 ? kMillimetre : kDegree; }
const char* unit_name(int k) { return k < 3 ? "mm" : "deg"; }

/// Of a free angle without jumps by whole turns.
TimeSeries deviation_of(const MotionSamples& samples, int k) {
  TimeSeries series{samples.times, {}};
  double before = 0;  // rad
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    if (!samples.deviation[i]) {
      series.values.push_back(kNaN);
      continue;
    }
    double value = (*samples.deviation[i])[k];
    if (samples.boxes[i]->is_free(k)) value = before + std::remainder(value - before, kTurn);
    before = value;
    series.values.push_back(value / unit_of(k));
  }
  return series;
}

/// Below zero where the deviation is below the middle of the box.
TimeSeries share_of(const MotionSamples& samples, int k) {
  TimeSeries series{samples.times, {}};
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    const auto& box = samples.boxes[i];
    if (!box || box->is_free(k)) {
      series.values.push_back(kNaN);
      continue;
    }
    const double off = (*samples.deviation[i])[k] - 0.5 * (box->lower[k] + box->upper[k]);
    series.values.push_back(std::copysign((*samples.use[i])[k], off));
  }
  return series;
}

/// An edge of the box; without a width, that of what holds between waypoints.
/// @param side -1: the lower one, 1: the upper one
TimeSeries edge_of(const MotionSamples& samples, const Vector6& widening, int k, int side) {
  TimeSeries series{samples.times, {}};
  for (const auto& box : samples.boxes) {
    if (!box || box->is_free(k)) {
      series.values.push_back(kNaN);
      continue;
    }
    double edge = side < 0 ? box->lower[k] : box->upper[k];
    if (!(box->upper[k] > box->lower[k])) edge += side * widening[k];
    series.values.push_back(edge / unit_of(k));
  }
  return series;
}

bool any(const MotionSamples& samples, bool (*is_so)(const ToleranceBox&, int), int k) {
  return std::any_of(samples.boxes.begin(), samples.boxes.end(),
                     [&](const auto& box) { return box && is_so(*box, k); });
}

/// What the tolerance is, in words.
std::string kind_of(const MotionSamples& samples, int k) {
  const bool is_free = any(
      samples, [](const ToleranceBox& b, int i) { return b.is_free(i); }, k);
  const bool is_wide = any(
      samples, [](const ToleranceBox& b, int i) { return b.upper[i] > b.lower[i]; }, k);
  const bool is_exact = any(
      samples, [](const ToleranceBox& b, int i) { return !(b.upper[i] > b.lower[i]); }, k);
  if (is_free) return "free";
  if (is_wide && is_exact) return "partly without width";
  if (is_wide) return "";
  return is_exact ? "no width; edges: what holds between waypoints" : "not prescribed";
}

class TolerancePicture {
 public:
  explicit TolerancePicture(const MotionPicture& motions)
      : motions_(motions),
        legend_(legend()),
        width_(2 * (plot::kLeftMargin + kPanelWidth + kGap)),
        top_(heading_height(legend_, width_)),
        picture_(width_, top_ + kHeading + kCoordinates * line_height() + kBelow) {
    for (const ShownMotion& motion : motions.motions) {
      samples_.push_back(sample_tolerance(motion.task, motions.robot, *checked_motion(motion),
                                          std::max(kSamples, motion.path.size())));
      widenings_.push_back(widening_of(motion.task));
    }
  }

  std::string draw() {
    draw_heading(motions_.title, legend_, width_, picture_);
    head(0, "deviation");
    head(1, "share of the tolerance");
    for (int k = 0; k < kCoordinates; ++k) {
      draw_deviation(k);
      draw_share(k);
    }
    return picture_.str();
  }

 private:
  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries = motion_legend(motions_);
    entries.push_back(
        {"edge of the tolerance", LegendEntry::Sign::line, plot::kLimit, plot::kLimitDash});
    entries.push_back({"inside the tolerance", LegendEntry::Sign::area, plot::kAllowed});
    return entries;
  }

  static double line_height() { return plot::kTitleHeight + kPanelHeight + kGap; }
  static double left(int column) {
    return plot::kLeftMargin + column * (plot::kLeftMargin + kPanelWidth + kGap);
  }
  double frame_top(int k) const { return top_ + kHeading + k * line_height() + plot::kTitleHeight; }

  void head(int column, const std::string& text) {
    const double middle = left(column) + 0.5 * kPanelWidth;
    picture_.text(middle, top_ + 12, text, SvgAnchor::middle, 14);
    picture_.text(middle, frame_top(kCoordinates - 1) + kPanelHeight + 32, "time, s",
                  SvgAnchor::middle, plot::kTextSize);
  }

  std::vector<PlotLine> lines(int k, TimeSeries (*series)(const MotionSamples&, int)) const {
    std::vector<PlotLine> drawn;
    for (std::size_t i = samples_.size(); i-- > 0;)
      drawn.push_back({motions_.motions[i].name, MotionPicture::colour(i), series(samples_[i], k)});
    return drawn;
  }

  void draw(const PlotPanel& panel, int column, int k, const PlotRange& range) {
    draw_panel(panel, time_axis(motions_.time, left(column), kPanelWidth),
               {range.from, range.to, frame_top(k) + kPanelHeight, frame_top(k)}, 1, true,
               picture_);
  }

  void draw_deviation(int k) {
    PlotPanel panel;
    const std::string name = kCoordinateNames[static_cast<std::size_t>(k)];
    panel.name = name + " deviation";
    panel.title = name;
    panel.unit = unit_name(k);
    panel.note = kind_of(samples_.front(), k);
    panel.shaded = motions_.runs;
    for (const int side : {-1, 1})
      panel.lines.push_back({side < 0 ? "lower edge" : "upper edge", plot::kLimit,
                             edge_of(samples_.front(), widenings_.front(), k, side), 1,
                             plot::kLimitDash});
    for (PlotLine& line : lines(k, deviation_of)) panel.lines.push_back(std::move(line));
    const PlotRange range = range_of(panel.lines).value_or(PlotRange{0, 0});
    const double room = std::max(kRoom * (range.to - range.from), kLeastRange);
    draw(panel, 0, k, {range.from - room, range.to + room});
  }

  void draw_share(int k) {
    PlotPanel panel;
    const std::string name = kCoordinateNames[static_cast<std::size_t>(k)];
    panel.name = name + " share";
    panel.title = name;
    panel.shaded = motions_.runs;
    panel.lines = lines(k, share_of);
    PlotRange range{-kLeastShare, kLeastShare};
    if (const auto own = range_of(panel.lines)) {
      range.from = std::clamp((1 + kRoom) * own->from, -kMostShare, range.from);
      range.to = std::clamp((1 + kRoom) * own->to, range.to, kMostShare);
      panel.allowed = PlotRange{-1, 1};
      panel.limits = {-1, 1};
    } else {
      panel.empty_text = kind_of(samples_.front(), k);
    }
    if (const auto own = range_of({panel.lines.back()}))
      panel.note = percent(std::max(-own->from, own->to)) + " used";
    draw(panel, 1, k, range);
  }

  const MotionPicture& motions_;
  std::vector<LegendEntry> legend_;
  double width_, top_;
  SvgPicture picture_;
  std::vector<MotionSamples> samples_;  // of each motion
  std::vector<Vector6> widenings_;
};

}  // namespace

std::string tolerance_svg(const MotionPicture& motions) { return TolerancePicture(motions).draw(); }

}  // namespace wristwise
