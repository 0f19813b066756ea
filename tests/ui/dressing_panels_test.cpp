// What the panels offer for dressing: buttons, the line about a body that passes through the cloth, the progress.
#include "panel_fixture.hpp"
#include "ui/search.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace drape::ui {
namespace {

bool requests(const UiOutput& output, UiAction wanted) {
  return std::ranges::any_of(output.requests, [&](const UiRequest& request) {
    const auto* action = std::get_if<UiAction>(&request);
    return action != nullptr && *action == wanted;
  });
}

class WithoutBody : public PanelFixture {};

class WithBody : public PanelFixture {
 protected:
  WithBody() : PanelFixture("sphere") {}

  /// Shows the line of a body that passes through the cloth.
  void pierce(const std::string& text) {
    stats_.piercing = PiercingNotice{text, 35};
    settle();
  }
};

TEST_F(WithoutBody, ThereIsNothingToDress) {
  EXPECT_FALSE(panels_.buttons().contains("dress"));
}

TEST_F(WithBody, TheSectionContactOffersToDressIt) {
  EXPECT_TRUE(requests(click(button("dress")), UiAction::Dress));
}

TEST_F(WithBody, ABodyThatIsSwitchedOffIsNotDressed) {
  for (std::size_t i = 0; i < simulation_.scene().bodies->size(); ++i) {
    simulation_.apply(session::SwitchBodyCommand{static_cast<int>(i), false});
  }
  settle();
  EXPECT_FALSE(panels_.buttons().contains("dress"));
}

TEST_F(WithBody, ALineSaysThatItPassesThroughTheClothAndOffersToDressIt) {
  EXPECT_FALSE(panels_.buttons().contains("pierced.dress"));
  pierce("The right arm passes through the sleeve's wall: 35 pairs of triangles");
  EXPECT_TRUE(requests(click(button("pierced.dress")), UiAction::Dress));
}

TEST_F(WithBody, OkClosesTheLineHoweverManyPairsThereAreLater) {
  pierce("The right arm passes through the sleeve's wall: 35 pairs of triangles");
  click(button("pierced.accept"));
  settle();
  EXPECT_FALSE(panels_.buttons().contains("pierced.dress"));
  pierce("The right arm passes through the sleeve's wall: 34 pairs of triangles");
  EXPECT_FALSE(panels_.buttons().contains("pierced.dress"));
}

TEST_F(WithBody, ItsProgressReplacesTheLineAndCanBeCancelled) {
  pierce("The body 'sphere' passes through the cloth near (0.00, 0.50, 0.00) m: 12 pairs of triangles");
  stats_.dressing = DressingProgress{"Dressing sphere: growing the body, 45 %", 0.45};
  settle();
  EXPECT_FALSE(panels_.buttons().contains("pierced.dress"));
  EXPECT_TRUE(panels_.buttons().contains("overlay.dressing"));
  EXPECT_TRUE(requests(click(button("button.cancel_dressing")), UiAction::CancelDressing));
}

TEST(DressingInTheSearch, IsTheFirstEntryForItsName) {
  const std::vector<SearchEntry> entries = searchEntries({}, {});
  const std::vector<std::size_t> found = findEntries(entries, "dress");
  ASSERT_FALSE(found.empty());
  const auto* shortcut = std::get_if<const Shortcut*>(&entries[found.front()].target);
  ASSERT_TRUE(shortcut != nullptr);
  EXPECT_EQ(std::get<UiAction>((*shortcut)->action), UiAction::Dress);
}

class DropQuestion : public PanelFixture {
 protected:
  void ask(const DroppedFiles& files) {
    panels_.askWhichIsTheCloth(files);
    settle();
  }
  scene::SceneParts answer(const std::string& name) {
    const UiOutput output = click(button(name));
    EXPECT_EQ(output.requests.size(), 1U);
    return output.requests.empty() ? scene::SceneParts() : std::get<OpenPartsRequest>(output.requests.front()).parts;
  }
};

TEST_F(DropQuestion, DressOpensTheSameFilesToBeDressed) {
  ask(sortDropped({"/a/body.obj", "/a/coat.obj"}));
  EXPECT_FALSE(panels_.buttons().contains("button.drop.alone")) << "no file was dropped alone";
  const scene::SceneParts parts = answer("button.drop.dress");
  EXPECT_TRUE(parts.dressed);
  EXPECT_EQ(parts.cloth, "/a/coat.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/body.obj"}));
  settle();
  EXPECT_FALSE(panels_.buttons().contains("overlay.drop"));
}

TEST_F(DropQuestion, OpenLeavesTheClothWhereItsFilePutsIt) {
  ask(sortDropped({"/a/body.obj", "/a/coat.obj"}));
  EXPECT_FALSE(answer("button.drop.open").dressed);
}

TEST_F(DropQuestion, AFileThatWasDroppedAloneCanBeOpenedAlone) {
  DroppedFiles files = sortDropped({"/a/coat.obj", "/a/body.obj"});
  files.alone = "/a/body.obj";
  ask(files);
  const scene::SceneParts parts = answer("button.drop.alone");
  EXPECT_EQ(parts.scene, "/a/body.obj");
  EXPECT_TRUE(parts.bodies.empty());
}

}  // namespace
}  // namespace drape::ui
