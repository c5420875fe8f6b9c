#pragma once

// Reads a plotted picture as a person does: where a value lies is told by the ticks and their texts
// alone.

#include <gtest/gtest.h>
#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace wristwise::test {

struct PlottedPoint {
  double time = 0, value = 0;
};

/// A value for each pixel, by two ticks.
struct ReadAxis {
  double offset = 0, per_pixel = 0;
  double value(double pixel) const { return offset + per_pixel * pixel; }
};

class PlotReader {
 public:
  explicit PlotReader(const std::string& svg) {
    document_.Parse(svg.c_str(), nullptr, TIXML_ENCODING_UTF8);
    EXPECT_FALSE(document_.Error()) << document_.ErrorDesc();
  }

  const TiXmlElement* root() const { return document_.RootElement(); }

  /// The panel of that name; null where there is none.
  const TiXmlElement* panel(const std::string& name) const { return group(root(), name); }

  std::vector<std::string> texts(const TiXmlElement* of) const {
    std::vector<std::string> all;
    for (const TiXmlElement* e : children(of, "text")) all.push_back(text(e));
    return all;
  }

  /// The names of the lines in a panel, from back to front.
  std::vector<std::string> lines(const std::string& name) const {
    std::vector<std::string> names;
    for (const TiXmlElement* e : children(panel(name), "g"))
      names.push_back(text(e->FirstChildElement("title")));
    return names;
  }

  /// All points of a line, broken or not.
  /// @param times_of the panel whose time axis has values
  std::vector<PlottedPoint> line(const std::string& panel_name, const std::string& line_name,
                                 const std::string& times_of) const {
    const ReadAxis value = value_axis(panel_name), time = time_axis(times_of);
    std::vector<PlottedPoint> points;
    for (const auto& run : runs(panel_name, line_name))
      for (const PlottedPoint& p : run)
        points.push_back({time.value(p.time), value.value(p.value)});
    return points;
  }

  /// The unbroken pieces of a line, in pixels.
  std::vector<std::vector<PlottedPoint>> runs(const std::string& panel_name,
                                              const std::string& line_name) const {
    std::vector<std::vector<PlottedPoint>> all;
    const TiXmlElement* of = group(panel(panel_name), line_name);
    for (const TiXmlElement* e : children(of, "circle"))
      all.push_back({{number(e, "cx"), number(e, "cy")}});
    for (const TiXmlElement* e : children(of, "polyline")) {
      std::istringstream stream(e->Attribute("points"));
      std::vector<PlottedPoint> run;
      char comma = 0;
      PlottedPoint p;
      while (stream >> p.time >> comma >> p.value) run.push_back(p);
      all.push_back(run);
    }
    return all;
  }

  ReadAxis value_axis(const std::string& name) const {
    const double left = frame(name, "x");
    std::vector<double> pixels, values;
    for (const TiXmlElement* e : children(panel(name), "line"))
      if (number(e, "x2") == left && number(e, "x1") < left) pixels.push_back(number(e, "y1"));
    for (const TiXmlElement* e : children(panel(name), "text"))
      if (number(e, "x") < left) values.push_back(std::atof(text(e).c_str()));
    return axis(pixels, values);
  }

  ReadAxis time_axis(const std::string& name) const {
    const double bottom = frame(name, "y") + frame(name, "height");
    std::vector<double> pixels, values;
    for (const TiXmlElement* e : children(panel(name), "line"))
      if (number(e, "y1") == bottom && number(e, "y2") > bottom) pixels.push_back(number(e, "x1"));
    for (const TiXmlElement* e : children(panel(name), "text"))
      if (number(e, "y") > bottom) values.push_back(std::atof(text(e).c_str()));
    return axis(pixels, values);
  }

  /// Of the frame: x, y, width or height.
  double frame(const std::string& name, const char* attribute) const {
    const auto all = children(panel(name), "rect");
    return all.empty() ? 0 : number(all.back(), attribute);
  }

  /// Rectangles with this fill in a panel.
  std::vector<const TiXmlElement*> filled(const std::string& name, const std::string& fill) const {
    std::vector<const TiXmlElement*> found;
    for (const TiXmlElement* e : children(panel(name), "rect"))
      if (fill == e->Attribute("fill")) found.push_back(e);
    return found;
  }

  /// The values at which a dashed line goes across the panel.
  std::vector<double> limits(const std::string& name) const {
    std::vector<double> values;
    for (const TiXmlElement* e : children(panel(name), "line"))
      if (e->Attribute("stroke-dasharray") != nullptr)
        values.push_back(value_axis(name).value(number(e, "y1")));
    return values;
  }

  static double number(const TiXmlElement* e, const char* attribute) {
    double value = 0;
    EXPECT_EQ(e->QueryDoubleAttribute(attribute, &value), TIXML_SUCCESS) << attribute;
    return value;
  }

  static std::string text(const TiXmlElement* e) {
    return e != nullptr && e->GetText() != nullptr ? e->GetText() : "";
  }

  static std::vector<const TiXmlElement*> children(const TiXmlElement* of, const char* name) {
    std::vector<const TiXmlElement*> found;
    if (of == nullptr) return found;
    for (const TiXmlElement* e = of->FirstChildElement(name); e != nullptr;
         e = e->NextSiblingElement(name))
      found.push_back(e);
    return found;
  }

 private:
  static const TiXmlElement* group(const TiXmlElement* in, const std::string& name) {
    for (const TiXmlElement* e : children(in, "g"))
      if (text(e->FirstChildElement("title")) == name) return e;
    return nullptr;
  }

  static ReadAxis axis(const std::vector<double>& pixels, const std::vector<double>& values) {
    EXPECT_EQ(pixels.size(), values.size());
    EXPECT_GE(pixels.size(), 2U);
    if (pixels.size() < 2 || pixels.size() != values.size()) return {};
    ReadAxis read;
    read.per_pixel = (values.back() - values.front()) / (pixels.back() - pixels.front());
    read.offset = values.front() - read.per_pixel * pixels.front();
    for (std::size_t i = 0; i < pixels.size(); ++i)  // the ticks between agree
      EXPECT_NEAR(read.value(pixels[i]), values[i], 0.05 * std::abs(read.per_pixel));
    return read;
  }

  TiXmlDocument document_;
};

/// A line's value at a time, straight between its points; NaN outside.
inline double at(const std::vector<PlottedPoint>& line, double t, double tolerance = 1e-9) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PlottedPoint &a = line[i], &b = line[i + 1];
    if (t < a.time - tolerance || t > b.time + tolerance) continue;
    if (b.time - a.time < 1e-12) return a.value;
    return a.value + (t - a.time) / (b.time - a.time) * (b.value - a.value);
  }
  return std::nan("");
}

}  // namespace wristwise::test
