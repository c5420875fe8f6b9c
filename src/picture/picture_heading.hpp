#pragma once

#include <vector>

#include "picture/motion_picture.hpp"
#include "picture/plot_legend.hpp"

namespace wristwise {

/// Title and legend at the top of a picture `width` px wide.
/// @return px, what they take
double draw_heading(const std::string& title, const std::vector<LegendEntry>& legend, double width,
                    SvgPicture& picture);

/// px, what draw_heading() will take.
double heading_height(const std::vector<LegendEntry>& legend, double width);

/// The motions, and the run-in and run-out where there are some.
std::vector<LegendEntry> motion_legend(const MotionPicture& motions);

/// The pixels of the time axis in a panel; a single moment is in its middle.
PlotAxis time_axis(const PlotRange& time, double left, double width);

}  // namespace wristwise
