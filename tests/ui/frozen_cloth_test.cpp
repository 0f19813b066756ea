// Cloths that are frozen in the section Scene.
#include "panel_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace drape::ui {
namespace {

class TwoCloths : public PanelFixture {
 protected:
  TwoCloths() : PanelFixture("walk") {}

  /// Clicks the check box of a cloth and lets the simulation act.
  void toggle(const std::string& name) {
    apply(click(button(name)));
    settle();
  }

  [[nodiscard]] long pinsOf(std::size_t cloth) const {
    const scene::ClothPart& part = simulation_.scene().cloths[cloth];
    const auto first = simulation_.model().pinned.begin() + part.firstVertex;
    return std::count(first, first + part.vertexCount, true);
  }
};

class OneCloth : public PanelFixture {};

TEST_F(TwoCloths, AreFrozenOneByOneAndReleased) {
  settle();
  ASSERT_EQ(pinsOf(0) + pinsOf(1), 0);
  toggle("frozen.skirt");
  EXPECT_EQ(pinsOf(0), simulation_.scene().cloths[0].vertexCount);
  EXPECT_EQ(pinsOf(1), 0);
  toggle("frozen.T-shirt");
  EXPECT_EQ(pinsOf(1), simulation_.scene().cloths[1].vertexCount);
  toggle("frozen.skirt");
  EXPECT_EQ(pinsOf(0), 0);
  EXPECT_EQ(pinsOf(1), simulation_.scene().cloths[1].vertexCount);
}

TEST_F(OneCloth, HasNoCheckBox) {
  settle();
  for (const auto& [name, place] : panels_.buttons()) {
    EXPECT_EQ(name.find("frozen."), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace drape::ui
