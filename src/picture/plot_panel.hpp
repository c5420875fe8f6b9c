#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/plot_axis.hpp"
#include "picture/svg.hpp"
#include "picture/time_series.hpp"

namespace wristwise {

/// How a plotted line is drawn and called.
struct PlotLine {
  std::string name;
  std::string colour;
  TimeSeries series;
  double width = 1.3;     ///< px
  std::string dash = {};  ///< as SvgStyle::dash
};

struct PlotRange {
  double from = 0, to = 1;
};

/// Values over time in a frame, with limits and what is shaded.
struct PlotPanel {
  std::string name;               ///< of the group in the picture
  std::string title;              ///< above the frame, at the left, shortened where it is too long
  std::string unit;               ///< behind it
  std::string note;               ///< above the frame, at the right
  std::vector<PlotLine> lines;    ///< from back to front
  std::vector<double> limits;     ///< drawn dashed where they are in view
  std::vector<PlotRange> shaded;  ///< s, spans of time
  std::optional<PlotRange> allowed;  ///< a band of values
  std::string empty_text;            ///< in the frame where there is nothing to draw
};

/// Colours and sizes that the pictures share.
namespace plot {
inline constexpr const char* kResult = "#1f6fd0";
inline constexpr const char* kBehind = "#9b9b9b";
inline constexpr const char* kLimit = "#c62828";
inline constexpr const char* kLimitDash = "5 3";
inline constexpr const char* kShade = "#e9e9ee";
inline constexpr const char* kAllowed = "#e6f3e6";
inline constexpr const char* kRule = "#dcdcdc";
inline constexpr const char* kFrame = "#555555";
inline constexpr double kTextSize = 12;     // px
inline constexpr double kTickSize = 11;     // px
inline constexpr double kLeftMargin = 58;   // px, for the ticks' values
inline constexpr double kTitleHeight = 18;  // px
}  // namespace plot

/// The finite values of all lines; nullopt where there are none.
std::optional<PlotRange> range_of(const std::vector<PlotLine>& lines);

/// Draws the panel in the frame given by its axes: time to the right, values upwards.
/// @param column px, see thinned()
/// @param with_times the ticks of the time axis have their values
void draw_panel(const PlotPanel& panel, const PlotAxis& time, const PlotAxis& value, double column,
                bool with_times, SvgPicture& picture);

}  // namespace wristwise
