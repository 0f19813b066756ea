#include "session/open_seams.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace drape::session
