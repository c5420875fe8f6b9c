#include "picture/svg.hpp"

#include <fmt/format.h>

namespace wristwise {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string attributes(const SvgStyle& style) {
  std::string text = fmt::format("fill=\"{}\"", style.fill);
  if (style.stroke == "none") return text;
  text +=
      fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", style.stroke, number(style.stroke_width));
  if (!style.dash.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", style.dash);
  return text;
}

/// A hundredth of a pixel is enough, and short.
std::string pixels(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

const char* name(SvgAnchor anchor) {
  switch (anchor) {
    case SvgAnchor::middle:
      return "middle";
    case SvgAnchor::end:
      return "end";
    case SvgAnchor::start:
      break;
  }
  return "start";
}

}  // namespace

SvgPicture::SvgPicture(double width, double height) : width_(width), height_(height) {
  rectangle(0, 0, width, height, {"white", "none", 0});
}

void SvgPicture::rectangle(double x, double y, double width, double height, const SvgStyle& style) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", number(x),
                       number(y), number(width), number(height), attributes(style));
}

void SvgPicture::line(double x1, double y1, double x2, double y2, const SvgStyle& style) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(x1),
                       number(y1), number(x2), number(y2), attributes(style));
}

void SvgPicture::polyline(const std::vector<SvgPoint>& points, const SvgStyle& style) {
  body_ += "<polyline points=\"";
  for (std::size_t i = 0; i < points.size(); ++i)
    body_ += fmt::format("{}{},{}", i > 0 ? " " : "", pixels(points[i].x), pixels(points[i].y));
  body_ += fmt::format("\" {} stroke-linejoin=\"round\"/>\n", attributes(style));
}

void SvgPicture::begin_group(const std::string& title) {
  body_ += fmt::format("<g><title>{}</title>\n", escaped(title));
}

void SvgPicture::begin_group(const std::string& title, double x, double y, double width,
                             double height) {
  const int clip = ++clips_;
  body_ += fmt::format(
      "<clipPath id=\"clip{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
      "<g clip-path=\"url(#clip{})\"><title>{}</title>\n",
      clip, number(x), number(y), number(width), number(height), clip, escaped(title));
}

void SvgPicture::end_group() { body_ += "</g>\n"; }

void SvgPicture::circle(double x, double y, double radius, const SvgStyle& style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", number(x), number(y),
                       number(radius), attributes(style));
}

void SvgPicture::text(double x, double y, const std::string& text, SvgAnchor anchor, double size,
                      bool turned) {
  const std::string turn =
      turned ? fmt::format(" transform=\"rotate(-90 {} {})\"", number(x), number(y)) : "";
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                       number(x), number(y), number(size), name(anchor), turn, escaped(text));
}

std::string SvgPicture::str() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n"
      "<defs><pattern id=\"hatched\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\">"
      "<rect width=\"6\" height=\"6\" fill=\"#eeeeee\"/>"
      "<path d=\"M0 6 6 0M-1 1 1 -1M5 7 7 5\" stroke=\"#aaaaaa\"/></pattern></defs>\n{2}</svg>\n",
      number(width_), number(height_), body_);
}

}  // namespace wristwise
