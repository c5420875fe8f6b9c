#include "picture/plot_legend.hpp"

#include "picture/plot_panel.hpp"
#include "picture/text_width.hpp"

namespace wristwise {

namespace {
constexpr double kSign = 22, kGap = 18, kLine = 18;  // px
}  // namespace

double draw_legend(const std::vector<LegendEntry>& entries, double x, double y, double width,
                   SvgPicture& picture) {
  double left = x, below = 0;
  for (const LegendEntry& entry : entries) {
    const std::string name = fitted(entry.name, plot::kTextSize, width - kSign - 6);
    const double own = kSign + 6 + text_width(name, plot::kTextSize);
    if (left > x && left + own > x + width) left = x, below += kLine;
    const double base = y + below;
    if (entry.sign == LegendEntry::Sign::line)
      picture.line(left, base - 4, left + kSign, base - 4, {"none", entry.colour, 2, entry.dash});
    else
      picture.rectangle(left, base - 10, kSign, 12, {entry.colour, plot::kRule, 1, ""});
    picture.text(left + kSign + 6, base, name, SvgAnchor::start, plot::kTextSize);
    left += own + kGap;
  }
  return below + kLine;
}

}  // namespace wristwise
