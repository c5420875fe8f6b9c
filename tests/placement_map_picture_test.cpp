#include "picture/placement_map_picture.hpp"

#include <gtest/gtest.h>
#include <tinyxml.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "picture/svg.hpp"

namespace wristwise {
namespace {

struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  double number(const std::string& key) const { return std::atof(attributes.at(key).c_str()); }
};

/// The elements at the top of a picture, read by an XML parser.
std::vector<Element> elements(const std::string& svg) {
  TiXmlDocument document;
  document.Parse(svg.c_str(), nullptr, TIXML_ENCODING_UTF8);
  EXPECT_FALSE(document.Error()) << document.ErrorDesc();
  std::vector<Element> found;
  const TiXmlElement* root = document.RootElement();
  if (root == nullptr) return found;
  for (const TiXmlElement* e = root->FirstChildElement(); e != nullptr;
       e = e->NextSiblingElement()) {
    Element element{e->Value(), e->GetText() != nullptr ? e->GetText() : "", {}};
    for (const TiXmlAttribute* a = e->FirstAttribute(); a != nullptr; a = a->Next())
      element.attributes[a->Name()] = a->Value();
    found.push_back(std::move(element));
  }
  return found;
}

std::size_t count(const std::vector<Element>& all, const std::string& name,
                  const std::string& fill = "") {
  std::size_t sum = 0;
  for (const Element& e : all)
    sum += e.name == name && (fill.empty() || e.attributes.at("fill") == fill) ? 1U : 0U;
  return sum;
}

const Element* text(const std::vector<Element>& all, const std::string& words) {
  for (const Element& e : all)
    if (e.name == "text" && e.text == words) return &e;
  return nullptr;
}

/// x from -0.1 to 0.1 m, rz from -90 to 90 deg; the last sample can't be welded.
PlacementResult example() {
  PlacementResult result;
  result.map.axes = {0, 5};
  result.map.points = {3, 3};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      Placement sample;
      sample.offset[0] = -0.1 + 0.1 * i;
      sample.offset[2] = 0.25;
      sample.offset[5] = (j - 1) * 1.5707963267948966;
      sample.measure.feasible = true;
      sample.measure.value = i + 3 * j;
      result.map.samples.push_back(sample);
    }
  }
  result.map.samples.back().measure.feasible = false;
  result.found = result.map.samples.front();
  return result;
}

TEST(PlacementMapPicture, ShowsEverySampleBothPlacementsAndUnits) {
  const std::vector<Element> all = elements(placement_map_svg(example(), "a < b & \"c\""));
  EXPECT_NE(text(all, "a < b & \"c\""), nullptr);
  EXPECT_NE(text(all, "moved by x, m"), nullptr);
  EXPECT_NE(text(all, "moved by rz, deg"), nullptr);
  EXPECT_NE(text(all, "at z = 0.25 m"), nullptr);
  EXPECT_NE(text(all, "given"), nullptr);
  EXPECT_NE(text(all, "found"), nullptr);
  EXPECT_NE(text(all, "100"), nullptr) << "a tick in degrees";
  EXPECT_EQ(count(all, "rect", SvgPicture::kHatched), 2U) << "one sample, and the legend";
}

/// Found is at the lower left, given in the middle.
TEST(PlacementMapPicture, PutsThingsWhereTheyAre) {
  const std::vector<Element> all = elements(placement_map_svg(example(), "map"));
  std::vector<Element> marks;
  for (const Element& e : all)
    if (e.name == "circle" && e.number("r") > 3) marks.push_back(e);
  ASSERT_EQ(marks.size(), 2U);
  const Element &given = marks[0], &found = marks[1];
  EXPECT_LT(found.number("cx"), given.number("cx"));
  EXPECT_GT(found.number("cy"), given.number("cy"));  // y is down in a picture
  // samples in the middle of their cells: the first is the best, and has the darkest colour
  bool is_cell = false;
  for (const Element& e : all) {
    if (e.name != "rect" || e.attributes.at("fill") != "#440154" || e.number("width") < 50)
      continue;
    is_cell = true;
    EXPECT_NEAR(e.number("x") + 0.5 * e.number("width"), found.number("cx"), 0.5);
    EXPECT_NEAR(e.number("y") + 0.5 * e.number("height"), found.number("cy"), 0.5);
  }
  EXPECT_TRUE(is_cell);
}

TEST(PlacementMapPicture, NothingIsDrawnOutsideOfThePicture) {
  const std::string svg = placement_map_svg(example(), "map");
  TiXmlDocument document;
  document.Parse(svg.c_str());
  double width = 0, height = 0;
  document.RootElement()->QueryDoubleAttribute("width", &width);
  document.RootElement()->QueryDoubleAttribute("height", &height);
  for (const Element& e : elements(svg)) {
    if (e.name != "rect" && e.name != "text") continue;
    EXPECT_GE(e.number("x"), 0);
    EXPECT_LE(e.number("x"), width);
    EXPECT_GE(e.number("y"), 0);
    EXPECT_LE(e.number("y"), height);
  }
}

TEST(PlacementMapPicture, OneAxisIsAStripNoneIsNoPicture) {
  PlacementResult result = example();
  result.map.axes = {0};
  result.map.points = {3};
  result.map.samples.resize(3);
  const std::vector<Element> all = elements(placement_map_svg(result, "map"));
  EXPECT_NE(text(all, "moved by x, m"), nullptr);
  EXPECT_EQ(text(all, "moved by rz, deg"), nullptr);
  EXPECT_EQ(placement_map_svg(PlacementResult(), "map"), "");
}

TEST(PlacementMapPicture, WhereNothingCanBeWeldedThereIsStillAMap) {
  PlacementResult result = example();
  for (Placement& sample : result.map.samples) sample.measure.feasible = false;
  result.found = result.map.samples.front();
  const std::vector<Element> all = elements(placement_map_svg(result, "map"));
  EXPECT_EQ(count(all, "rect", SvgPicture::kHatched), 10U);
  EXPECT_NE(text(all, "nearest"), nullptr);
}

}  // namespace
}  // namespace wristwise
