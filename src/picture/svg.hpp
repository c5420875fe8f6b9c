#pragma once

#include <string>
#include <vector>

namespace wristwise {

/// How a shape is drawn. Colours as in CSS; "none": not at all.
struct SvgStyle {
  std::string fill = "none";
  std::string stroke = "none";
  double stroke_width = 1;
  std::string dash = {};  ///< lengths of strokes and gaps, px: "5 3"; empty: a whole line
};

struct SvgPoint {
  double x = 0, y = 0;
};

enum class SvgAnchor { start, middle, end };

/// A picture, drawn from back to front. Pixels, x to the right, y down.
class SvgPicture {
 public:
  SvgPicture(double width, double height);

  void rectangle(double x, double y, double width, double height, const SvgStyle& style);
  void line(double x1, double y1, double x2, double y2, const SvgStyle& style);
  /// Through the points, in order; two or more.
  void polyline(const std::vector<SvgPoint>& points, const SvgStyle& style);
  void circle(double x, double y, double radius, const SvgStyle& style);
  /// @param y of the base line; @param turned read from below to above
  void text(double x, double y, const std::string& text, SvgAnchor anchor = SvgAnchor::start,
            double size = 13, bool turned = false);

  /// What is drawn until end_group() belongs together and is called `title`, which a browser shows
  /// where the pointer rests.
  void begin_group(const std::string& title);
  /// Likewise, and nothing of it is drawn outside of the rectangle.
  void begin_group(const std::string& title, double x, double y, double width, double height);
  void end_group();

  /// A fill of slanted lines, for SvgStyle::fill.
  static constexpr const char* kHatched = "url(#hatched)";

  std::string str() const;

 private:
  double width_, height_;
  std::string body_;
  int clips_ = 0;
};

}  // namespace wristwise
