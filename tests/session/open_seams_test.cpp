#include "session/open_seams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace drape::session {
namespace {

/// Two vertices 5 mm and two 20 mm apart.
sim::ClothState twoPairs(double time) {
  sim::ClothState state =
      sim::stateAtRest({Vec3(0.0, 0.0, 0.0), Vec3(0.005, 0.0, 0.0), Vec3(1.0, 0.5, 0.0), Vec3(1.0, 0.52, 0.0)});
  state.time = time;
  return state;
}

TEST(LateSeams, areNamedAfterTwiceTheirDuration) {
  const std::vector<sim::Seam> open{{.pairs = {{0, 1}, {2, 3}}, .duration = 0.5, .start = 1.0}};
  EXPECT_TRUE(lateSeamsInWords(open, twoPairs(1.9)).empty());
  EXPECT_EQ(lateSeamsInWords(open, twoPairs(2.1)).english(),
            "1 seam is still open: its sides are up to 20 mm apart, near (1.00, 0.51, 0.00) m. Something between them, "
            "or cloth that is too tight, keeps them apart.");
}

TEST(LateSeams, countOnlyThoseThatAreLate) {
  const std::vector<sim::Seam> open{{.pairs = {{0, 1}}, .duration = 0.5, .start = 0.0},
                                    {.pairs = {{2, 3}}, .duration = 5.0, .start = 0.0},
                                    {.pairs = {}, .duration = 0.1, .start = 0.0},
                                    {.pairs = {{0, 1}}, .duration = 0.4, .start = 0.0}};
  const std::string words = lateSeamsInWords(open, twoPairs(2.0)).english();
  EXPECT_TRUE(words.starts_with("2 seams are still open: their sides are up to 5 mm apart")) << words;
}

/// A strip of 20 squares with 4 cm sides along x, which is longer by a strain. @param strained how many of them are
sim::ClothState stretchedStrip(const sim::ClothModel& model, double strain, int strained) {
  sim::ClothState state = sim::stateAtRest(model.restPositions);
  for (Vec3& position : state.positions) {
    position.x() += strain * std::min(position.x(), 0.04 * strained);
  }
  return state;
}

TEST(TightSewing, isNamedIfATwentiethOfTheEdgesIsStretchedFar) {
  sim::ClothMesh strip;
  for (int i = 0; i <= 20; ++i) {
    strip.positions.emplace_back(0.04 * i, 0.0, 0.0);
    strip.positions.emplace_back(0.04 * i, 0.04, 0.0);
  }
  for (int i = 0; i < 20; ++i) {
    strip.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    strip.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  const auto model = sim::buildClothModel(strip, 0.1, sim::MassLumping::Area, {});
  EXPECT_TRUE(tightSewingInWords(*model, stretchedStrip(*model, 0.2, 20)).empty());
  EXPECT_TRUE(tightSewingInWords(*model, stretchedStrip(*model, 0.6, 1)).empty()) << "a few edges";
  EXPECT_EQ(tightSewingInWords(*model, stretchedStrip(*model, 0.6, 20)).english(),
            "Where it is tightest the sewn cloth is stretched by 60 %: its pieces are too small for the body, or their "
            "unit is another one.");
}

}  // namespace
}  // namespace drape::session
