#pragma once

#include <string>

namespace wristwise {

/// How a shape is drawn. Colours as in CSS; "none": not at all.
struct SvgStyle {
  std::string fill = "none";
  std::string stroke = "none";
  double stroke_width = 1;
};

enum class SvgAnchor { start, middle, end };

/// A picture, drawn from back to front. Pixels, x to the right, y down.
class SvgPicture {
 public:
  SvgPicture(double width, double height);

  void rectangle(double x, double y, double width, double height, const SvgStyle& style);
  void line(double x1, double y1, double x2, double y2, const SvgStyle& style);
  void circle(double x, double y, double radius, const SvgStyle& style);
  /// @param y of the base line; @param turned read from below to above
  void text(double x, double y, const std::string& text, SvgAnchor anchor = SvgAnchor::start,
            double size = 13, bool turned = false);

  /// A fill of slanted lines, for SvgStyle::fill.
  static constexpr const char* kHatched = "url(#hatched)";

  std::string str() const;

 private:
  double width_, height_;
  std::string body_;
};

}  // namespace wristwise
