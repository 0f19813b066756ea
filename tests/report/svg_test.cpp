#include "report/svg.hpp"

#include "many_curves.hpp"
#include "xml_check.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape::report {
namespace {

constexpr double noValue = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Plot twoCurves() {
  Plot plot{"name", "Error & cost <of> \"both\"", {"us", Scale::Logarithmic}, {"mm", Scale::Logarithmic}, {}};
  plot.curves.push_back({"first & <best>", {{1.0, 0.1}, {10.0, 0.01, Mark::Hollow, "5 < 6"}, {100.0, 0.001}}});
  plot.curves.push_back(
      {"second", {{2.0, 1.0}, {3.0, infinite, Mark::Cross}, {4.0, noValue}, {5.0, 0.0}, {noValue, 1.0}}});
  return plot;
}

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
    ++count;
  }
  return count;
}

TEST(XmlCheck, findsTextThatIsNotWellFormed) {
  EXPECT_EQ(testing::XmlCheck::faultOf("<a b=\"c\"><d/>e &amp; f</a>"), "");
  EXPECT_NE(testing::XmlCheck::faultOf("<a><b></a>"), "");
  EXPECT_NE(testing::XmlCheck::faultOf("<a>"), "");
  EXPECT_NE(testing::XmlCheck::faultOf("<a b=c></a>"), "");
  EXPECT_NE(testing::XmlCheck::faultOf("<a>b & c</a>"), "");
}

TEST(SvgPlot, isWellFormedWithoutValuesThatAreNoNumbers) {
  const std::string svg = svgOf(twoCurves());
  EXPECT_EQ(testing::XmlCheck::faultOf(svg), "");
  EXPECT_EQ(testing::XmlCheck::faultOf(svgFile(svg)), "");
  for (const char* wrong : {"nan", "inf", "NaN", "e+", "e-0"}) {
    EXPECT_EQ(svg.find(wrong), std::string::npos) << wrong;
  }
}

TEST(SvgPlot, drawsAMarkForEachPointThatHasAPlaceAndNamesEachCurve) {
  const std::string svg = svgOf(twoCurves());
  // Three points, one point, and two in the legend; the hollow mark is a circle too.
  EXPECT_EQ(countOf(svg, "<circle"), 6);
  EXPECT_EQ(countOf(svg, "<circle class=\"fill-paper line-curve1\" fill=\"#ffffff\" stroke=\"#0072b2\""), 1);
  EXPECT_EQ(countOf(svg, "stroke-width=\"1.8\""), 1);  // the cross
  EXPECT_NE(svg.find("first &amp; &lt;best&gt;"), std::string::npos);
  EXPECT_NE(svg.find(">second<"), std::string::npos);
}

TEST(SvgPlot, drawsALineThroughThePointsOfACurve) {
  Plot plot{"name", "title", {"x", Scale::Linear}, {"y", Scale::Linear}, {}};
  plot.curves.push_back({"line", {{0.0, 0.0}, {1.0, 1.0}}});
  // The frame is 560 x 380 from (72, 36).
  EXPECT_NE(svgOf(plot).find("d=\"M72.0 416.0L632.0 36.0\""), std::string::npos) << svgOf(plot);
}

TEST(SvgPlot, interruptsALineWhereAValueIsMissing) {
  Plot plot{"name", "title", {"x", Scale::Linear}, {"y", Scale::Linear}, {}};
  plot.curves.push_back({"line", {{0.0, 0.0}, {1.0, 1.0}, {2.0, noValue}, {3.0, 1.0}, {4.0, 0.0}}});
  EXPECT_EQ(countOf(svgOf(plot), "class=\"line-curve1\""), 3);  // two pieces and the one of the legend
}

TEST(SvgPlot, drawsABandWhereThereIsOne) {
  Plot plot{"name", "title", {"x", Scale::Linear}, {"y", Scale::Linear}, {}};
  plot.curves.push_back({"line", {{0.0, 0.5, Mark::Filled, "", 0.0, 1.0}, {1.0, 0.5, Mark::Filled, "", 0.2, 0.8}}});
  EXPECT_EQ(countOf(svgOf(plot), "class=\"fill-curve1\" fill=\"#0072b2\" fill-opacity=\"0.2\""), 1);
  plot.curves[0].points[0].low = noValue;
  EXPECT_EQ(countOf(svgOf(plot), "class=\"fill-curve1\" fill=\"#0072b2\" fill-opacity=\"0.2\""), 0);
}

TEST(SvgPlot, listsGreyLinesTogetherAndNamesThemInTooltips) {
  const std::string svg = svgOf(testing::manyCurves(20));
  EXPECT_EQ(testing::XmlCheck::faultOf(svg), "");
  EXPECT_NE(svg.find(">16 others (see their tooltips)<"), std::string::npos);
  EXPECT_NE(svg.find("<title>19</title>"), std::string::npos);
  EXPECT_EQ(svg.find("y=\"4.0\">19<"), std::string::npos);
}

/// Viewers differ in what they know of style sheets, and all know attributes.
TEST(SvgFile, hasItsColoursWithoutAStyleSheet) {
  const std::string svg = svgFile(svgOf(testing::manyCurves(3)));
  EXPECT_EQ(testing::XmlCheck::faultOf(svg), "");
  EXPECT_EQ(svg.find("<style"), std::string::npos);
  EXPECT_EQ(svg.find("var("), std::string::npos);
  EXPECT_NE(svg.find("stroke=\"#d55e00\""), std::string::npos);
}

TEST(SvgPlot, canBeEmpty) {
  EXPECT_EQ(testing::XmlCheck::faultOf(svgOf(Plot{"name", "title", {"x"}, {"y"}, {}})), "");
}

TEST(SvgMap, hasACellWithItsLetterForEachStateAndALegend) {
  StateMap map{"name",
               "title",
               "step",
               {"1", "2"},
               {{"a", {0, 1}}, {"b", {1, 1}}},
               {{"calm", "C", Tone::Good}, {"explodes", "X", Tone::Bad}}};
  const std::string svg = svgOf(map);
  EXPECT_EQ(testing::XmlCheck::faultOf(svg), "");
  EXPECT_EQ(countOf(svg, ">C<"), 2);
  EXPECT_EQ(countOf(svg, ">X<"), 4);
  EXPECT_EQ(countOf(svg, "class=\"fill-bad\" fill=\"#f6b5a8\""), 4);
}

}  // namespace
}  // namespace drape::report
