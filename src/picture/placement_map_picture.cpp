#include "picture/placement_map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "picture/plot_axis.hpp"
#include "picture/svg.hpp"

namespace wristwise {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kLeft = 80, kTop = 60, kSide = 440, kStrip = 60, kBelow = 60;
constexpr double kBarGap = 30, kBarWidth = 18, kRight = 90;

const SvgStyle kFrame{"none", "#333333", 1};

/// From good to bad; perceived about evenly, and told apart without colour.
constexpr std::array<std::array<double, 3>, 6> kColours = {
    {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};

std::string colour(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * (kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  const double share = place - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i)
    rgb[i] = static_cast<int>(
        std::lround((1 - share) * kColours[below][i] + share * kColours[below + 1][i]));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

double in_plot_units(int coordinate, double value) {
  return coordinate < 3 ? value : value / kDegree;
}

std::string axis_label(int coordinate) {
  return fmt::format("moved by {}, {}", kCoordinateNames[static_cast<std::size_t>(coordinate)],
                     coordinate < 3 ? "m" : "deg");
}

std::string fixed_text(const PlacementResult& result) {
  std::string text;
  for (int i = 0; i < 6; ++i) {
    const double value = result.found.offset[i];
    const bool is_axis =
        std::find(result.map.axes.begin(), result.map.axes.end(), i) != result.map.axes.end();
    if (is_axis || value == 0) continue;
    text += fmt::format("{}{} = {:.4g} {}", text.empty() ? "at " : ", ",
                        kCoordinateNames[static_cast<std::size_t>(i)], in_plot_units(i, value),
                        i < 3 ? "m" : "deg");
  }
  return text;
}

/// A map of one or two axes; of one it is a strip.
class MapPicture {
 public:
  explicit MapPicture(const PlacementResult& result)
      : result_(result),
        map_(result.map),
        height_(map_.axes.size() > 1 ? kSide : kStrip),
        picture_(kLeft + kSide + kBarGap + kBarWidth + kRight, kTop + height_ + kBelow) {
    x_ = axis(0, kLeft, kLeft + kSide);
    if (map_.axes.size() > 1) y_ = axis(1, kTop + height_, kTop);
    for (const Placement& sample : map_.samples) {
      if (!sample.measure.feasible) continue;
      least_ = std::min(least_, sample.measure.value);
      most_ = std::max(most_, sample.measure.value);
    }
    if (!(least_ <= most_)) least_ = 0, most_ = 1;
    if (most_ - least_ < 1e-9) most_ = least_ + std::max(1e-9, std::abs(least_));
  }

  std::string draw(const std::string& title) {
    picture_.text(kLeft, 24, title, SvgAnchor::start, 15);
    picture_.text(kLeft, 44, fixed_text(result_), SvgAnchor::start, 12);
    draw_cells();
    draw_axes();
    draw_scale();
    mark(Offset::Zero(), "given");
    mark(result_.found.offset, result_.found.measure.feasible ? "found" : "nearest");
    return picture_.str();
  }

 private:
  /// Wider than the region by half a cell, as samples are the middles of cells.
  PlotAxis axis(std::size_t k, double first_pixel, double last_pixel) const {
    const int i = map_.axes[k];
    const double from = in_plot_units(i, map_.samples.front().offset[i]);
    const double to = in_plot_units(i, map_.samples.back().offset[i]);
    const double half = map_.points[k] > 1 ? 0.5 * (to - from) / (map_.points[k] - 1)
                                           : std::max(1e-3, std::abs(from));
    return {from - half, to + half, first_pixel, last_pixel};
  }

  double x(const Offset& offset) const {
    return x_.pixel(in_plot_units(map_.axes[0], offset[map_.axes[0]]));
  }

  double y(const Offset& offset) const {
    if (map_.axes.size() < 2) return kTop + 0.5 * height_;
    return y_.pixel(in_plot_units(map_.axes[1], offset[map_.axes[1]]));
  }

  void draw_cells() {
    const double width = kSide / map_.points[0];
    const double height = map_.axes.size() > 1 ? height_ / map_.points[1] : height_;
    for (const Placement& sample : map_.samples) {
      const std::string fill = sample.measure.feasible
                                   ? colour((sample.measure.value - least_) / (most_ - least_))
                               : sample.measure.obstacle == "not_measured" ? "white"
                                                                           : SvgPicture::kHatched;
      picture_.rectangle(x(sample.offset) - 0.5 * width, y(sample.offset) - 0.5 * height,
                         width + 0.3, height + 0.3, {fill, "none", 0});
    }
    picture_.rectangle(kLeft, kTop, kSide, height_, kFrame);
  }

  void draw_axes() {
    const double bottom = kTop + height_;
    for (const double value : ticks(x_)) {
      picture_.line(x_.pixel(value), bottom, x_.pixel(value), bottom + 5, kFrame);
      picture_.text(x_.pixel(value), bottom + 20, tick_text(value), SvgAnchor::middle, 12);
    }
    picture_.text(kLeft + 0.5 * kSide, bottom + 44, axis_label(map_.axes[0]), SvgAnchor::middle);
    if (map_.axes.size() < 2) return;
    for (const double value : ticks(y_)) {
      picture_.line(kLeft - 5, y_.pixel(value), kLeft, y_.pixel(value), kFrame);
      picture_.text(kLeft - 9, y_.pixel(value) + 4, tick_text(value), SvgAnchor::end, 12);
    }
    picture_.text(24, kTop + 0.5 * height_, axis_label(map_.axes[1]), SvgAnchor::middle, 13, true);
  }

  void draw_scale() {
    constexpr int kSteps = 60;
    const double left = kLeft + kSide + kBarGap;
    const PlotAxis scale{least_, most_, kTop + height_, kTop};
    for (int k = 0; k < kSteps; ++k)
      picture_.rectangle(left, kTop + height_ * (1 - (k + 1.0) / kSteps), kBarWidth,
                         height_ / kSteps + 0.5, {colour((k + 0.5) / kSteps), "none", 0});
    picture_.rectangle(left, kTop, kBarWidth, height_, kFrame);
    for (const double value : ticks(scale, map_.axes.size() > 1 ? 6 : 2))
      picture_.text(left + kBarWidth + 6, scale.pixel(value) + 4, tick_text(value),
                    SvgAnchor::start, 12);
    picture_.text(left + kBarWidth, kTop - 10, "measure", SvgAnchor::middle, 12);
    picture_.rectangle(left, kTop + height_ + 14, kBarWidth, 12,
                       {SvgPicture::kHatched, "#333333", 0.5});
    picture_.text(left + kBarWidth + 6, kTop + height_ + 24, "can't weld", SvgAnchor::start, 12);
  }

  void mark(const Offset& offset, const std::string& name) {
    const double left = x(offset), top = y(offset);
    const bool is_inside =
        left >= kLeft && left <= kLeft + kSide && top >= kTop && top <= kTop + height_;
    if (!is_inside) return;
    picture_.circle(left, top, 6, {"white", "black", 1.5});
    picture_.circle(left, top, 2, {name == "given" ? "white" : "black", "none", 0});
    const bool near_right = left > kLeft + 0.85 * kSide;
    const double beside = near_right ? left - 10 : left + 10;
    const double width = 8.0 * static_cast<double>(name.size());
    picture_.rectangle(near_right ? beside - width : beside - 2, top - 8, width, 16,
                       {"white", "none", 0});
    picture_.text(beside, top + 4, name, near_right ? SvgAnchor::end : SvgAnchor::start, 12);
  }

  const PlacementResult& result_;
  const PlacementMap& map_;
  double height_;
  SvgPicture picture_;
  PlotAxis x_, y_;
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::string placement_map_svg(const PlacementResult& result, const std::string& title) {
  if (result.map.axes.empty()) return {};
  return MapPicture(result).draw(title);
}

}  // namespace wristwise
