#include "report/curve_inks.hpp"

#include "many_curves.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>
#include <vector>

namespace drape::report {
namespace {

using testing::manyCurves;

int coloured(const std::vector<CurveInk>& inks) {
  return static_cast<int>(
      std::count_if(inks.begin(), inks.end(), [](const CurveInk& ink) { return ink.ink != Ink::Grey; }));
}

TEST(CurveInks, letSixLinesStandOutAndAlwaysThoseOfAuto) {
  Plot plot = manyCurves(20);
  plot.curves[17].importance = 2.0;
  const std::vector<CurveInk> inks = curveInks(plot);
  EXPECT_EQ(coloured(inks), 6);
  EXPECT_EQ(inks[20].ink, Ink::Auto);
  EXPECT_EQ(inks[21].ink, Ink::Auto);
  EXPECT_NE(inks[20].variant, inks[21].variant);
  EXPECT_NE(inks[17].ink, Ink::Grey);  // the most important one
  EXPECT_NE(inks[2].ink, Ink::Grey);   // the first of those that are equally important
  EXPECT_EQ(inks[3].ink, Ink::Grey);
}

TEST(CurveInks, giveEachLineItsColourWhereThereAreFew) {
  std::set<Ink> used;
  for (const CurveInk& ink : curveInks(manyCurves(4))) {
    used.insert(ink.ink);
  }
  EXPECT_EQ(used.size(), 5U);
  EXPECT_FALSE(used.contains(Ink::Grey));
}

}  // namespace
}  // namespace drape::report
