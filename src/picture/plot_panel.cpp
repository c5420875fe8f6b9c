#include "picture/plot_panel.hpp"

#include <algorithm>
#include <cmath>

#include "picture/line_thinning.hpp"
#include "picture/text_width.hpp"

namespace wristwise {

namespace {

constexpr double kPixelsOfTimeTick = 55, kPixelsOfValueTick = 26;
constexpr double kDot = 2.2;            // px, of a single point
constexpr double kBetweenTexts = 6;     // px
constexpr std::size_t kLeastTicks = 3;  // of values

/// The frame of a panel, px.
struct Frame {
  double left, top, width, height;
};

Frame frame_of(const PlotAxis& time, const PlotAxis& value) {
  return {time.first_pixel, value.last_pixel, time.last_pixel - time.first_pixel,
          value.first_pixel - value.last_pixel};
}

std::vector<double> time_ticks(const PlotAxis& time) {
  return ticks(time, static_cast<int>((time.last_pixel - time.first_pixel) / kPixelsOfTimeTick));
}

/// As many as have room; more where round values would leave one or two.
std::vector<double> value_ticks(const PlotAxis& value) {
  const int room = static_cast<int>((value.first_pixel - value.last_pixel) / kPixelsOfValueTick);
  std::vector<double> values;
  for (int count = room; count <= 3 * room && values.size() < kLeastTicks; ++count)
    values = ticks(value, count);
  return values;
}

void draw_shades(const PlotPanel& panel, const PlotAxis& time, const PlotAxis& value,
                 SvgPicture& picture) {
  const Frame frame = frame_of(time, value);
  if (panel.allowed) {
    const double top = std::clamp(value.pixel(panel.allowed->to), frame.top, value.first_pixel);
    const double bottom =
        std::clamp(value.pixel(panel.allowed->from), frame.top, value.first_pixel);
    picture.rectangle(frame.left, top, frame.width, bottom - top, {plot::kAllowed, "none", 0, ""});
  }
  for (const PlotRange& span : panel.shaded) {
    const double from = std::clamp(time.pixel(span.from), frame.left, time.last_pixel);
    const double to = std::clamp(time.pixel(span.to), frame.left, time.last_pixel);
    if (to > from)
      picture.rectangle(from, frame.top, to - from, frame.height, {plot::kShade, "none", 0, ""});
  }
}

void draw_ticks(const PlotAxis& time, const PlotAxis& value, bool with_times, SvgPicture& picture) {
  const Frame frame = frame_of(time, value);
  const double bottom = frame.top + frame.height;
  const SvgStyle rule{"none", plot::kRule, 0.7, ""}, mark{"none", plot::kFrame, 1, ""};
  for (const double t : time_ticks(time)) {
    const double x = time.pixel(t);
    picture.line(x, frame.top, x, bottom, rule);
    picture.line(x, bottom, x, bottom + 4, mark);
    if (with_times) picture.text(x, bottom + 16, tick_text(t), SvgAnchor::middle, plot::kTickSize);
  }
  for (const double v : value_ticks(value)) {
    const double y = value.pixel(v);
    picture.line(frame.left, y, time.last_pixel, y, rule);
    picture.line(frame.left - 4, y, frame.left, y, mark);
    picture.text(frame.left - 7, y + 4, tick_text(v), SvgAnchor::end, plot::kTickSize);
  }
}

void draw_run(const std::vector<SvgPoint>& run, const PlotLine& line, double column,
              SvgPicture& picture) {
  if (run.size() == 1) picture.circle(run[0].x, run[0].y, kDot, {line.colour, "none", 0, ""});
  if (run.size() > 1)
    picture.polyline(thinned(run, column), {"none", line.colour, line.width, line.dash});
}

void draw_line(const PlotLine& line, const PlotAxis& time, const PlotAxis& value, double column,
               SvgPicture& picture) {
  const Frame frame = frame_of(time, value);
  picture.begin_group(line.name, frame.left, frame.top - 1, frame.width, frame.height + 2);
  std::vector<SvgPoint> run;
  for (std::size_t i = 0; i < line.series.times.size(); ++i) {
    const SvgPoint point{time.pixel(line.series.times[i]), value.pixel(line.series.values[i])};
    if (std::isfinite(point.x) && std::isfinite(point.y)) {
      run.push_back(point);
    } else {
      draw_run(run, line, column, picture);
      run.clear();
    }
  }
  draw_run(run, line, column, picture);
  picture.end_group();
}

void draw_limits(const PlotPanel& panel, const PlotAxis& time, const PlotAxis& value,
                 SvgPicture& picture) {
  for (const double limit : panel.limits) {
    if (!(limit >= value.from && limit <= value.to)) continue;
    const double y = value.pixel(limit);
    picture.line(time.first_pixel, y, time.last_pixel, y,
                 {"none", plot::kLimit, 1, plot::kLimitDash});
  }
}

void draw_texts(const PlotPanel& panel, const Frame& frame, SvgPicture& picture) {
  const std::string unit = panel.unit.empty() ? "" : ", " + panel.unit;
  const double room = frame.width - text_width(panel.note, plot::kTickSize) -
                      text_width(unit, plot::kTextSize) - kBetweenTexts;
  picture.text(frame.left, frame.top - 5, fitted(panel.title, plot::kTextSize, room) + unit,
               SvgAnchor::start, plot::kTextSize);
  if (!panel.note.empty())
    picture.text(frame.left + frame.width, frame.top - 5, panel.note, SvgAnchor::end,
                 plot::kTickSize);
  if (!panel.empty_text.empty())
    picture.text(frame.left + 0.5 * frame.width, frame.top + 0.5 * frame.height + 4,
                 panel.empty_text, SvgAnchor::middle, plot::kTextSize);
}

}  // namespace

std::optional<PlotRange> range_of(const std::vector<PlotLine>& lines) {
  std::optional<PlotRange> range;
  for (const PlotLine& line : lines) {
    for (const double value : line.series.values) {
      if (!std::isfinite(value)) continue;
      if (!range) range = PlotRange{value, value};
      range->from = std::min(range->from, value);
      range->to = std::max(range->to, value);
    }
  }
  return range;
}

void draw_panel(const PlotPanel& panel, const PlotAxis& time, const PlotAxis& value, double column,
                bool with_times, SvgPicture& picture) {
  const Frame frame = frame_of(time, value);
  picture.begin_group(panel.name);
  draw_shades(panel, time, value, picture);
  draw_ticks(time, value, with_times, picture);
  draw_limits(panel, time, value, picture);
  for (const PlotLine& line : panel.lines) draw_line(line, time, value, column, picture);
  picture.rectangle(frame.left, frame.top, frame.width, frame.height,
                    {"none", plot::kFrame, 1, ""});
  draw_texts(panel, frame, picture);
  picture.end_group();
}

}  // namespace wristwise
