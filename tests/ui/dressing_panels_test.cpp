// What the panels offer for dressing: buttons, the line about a body that passes through the cloth, the progress.
#include "locale/language.hpp"
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

TEST_F(DropQuestion, PlaceLeavesTheDressingToTheUser) {
  ask(sortDropped({"/a/body.obj", "/a/coat.obj"}));
  const scene::SceneParts parts = answer("button.drop.place");
  EXPECT_TRUE(parts.dressed) << "no pins, and each in its own unit";
  EXPECT_TRUE(parts.placed);
  ask(sortDropped({"/a/body.obj", "/a/coat.obj"}));
  EXPECT_FALSE(answer("button.drop.dress").placed);
}

/// The question about a person in inches and a coat in centimetres that were read.
class FoundFiles : public DropQuestion {
 protected:
  FoundFiles() {
    found_ = {{"/a/body.obj", scene::FoundMesh{.extent = {40.0, 67.0, 12.0}, .upOfShape = "y", .pieces = 1}, {}},
              {"/a/coat.obj", scene::FoundMesh{.extent = {60.0, 20.0, 75.0}, .upOfShape = "z", .pieces = 3}, {}}};
    stats_.found = found_;
    ask(sortDropped({"/a/body.obj", "/a/coat.obj"}));
  }

  std::vector<FoundFile> found_;
};

TEST_F(FoundFiles, AreOpenedAsTheyAreShown) {
  const scene::SceneParts parts = answer("button.drop.open");
  EXPECT_EQ(parts.clothReading, (scene::ReadingChoice{"cm", "z"}));
  EXPECT_EQ(parts.bodyReadings, (std::vector<scene::ReadingChoice>{{"inch", "y"}}));
}

TEST_F(FoundFiles, GetTheUnitAndTheUpAxisThatTheUserChooses) {
  click(button("drop.0.unit=foot"));
  click(button("drop.0.up=x"));
  click(button("drop.1.unit=mm"));
  const scene::SceneParts parts = answer("button.drop.dress");
  EXPECT_EQ(parts.clothReading, (scene::ReadingChoice{"mm", "z"}));
  EXPECT_EQ(parts.bodyReadings, (std::vector<scene::ReadingChoice>{{"foot", "x"}}));
}

TEST_F(FoundFiles, HaveNoChoicesUntilTheyAreRead) {
  found_[0].mesh.reset();
  settle();
  EXPECT_FALSE(panels_.buttons().contains("drop.0.unit=m"));
  EXPECT_TRUE(panels_.buttons().contains("drop.1.unit=m"));
  found_[1] = {"/a/coat.obj", std::nullopt, text::Sentence::verbatim("/a/coat.obj has no faces")};
  settle();
  EXPECT_FALSE(panels_.buttons().contains("drop.1.unit=m"));
  EXPECT_EQ(answer("button.drop.dress").clothReading, scene::ReadingChoice()) << "opening it says what is wrong";
}

TEST_F(FoundFiles, HaveNoChoicesIfTheyAreBuiltIn) {
  found_[0].file = "mannequin";
  DroppedFiles files = sortDropped({"/a/coat.obj"});
  files.meshes.emplace_back("mannequin");
  ask(files);
  EXPECT_TRUE(panels_.buttons().contains("drop.0.unit=m"));
  EXPECT_FALSE(panels_.buttons().contains("drop.1.unit=m"));
}

TEST_F(FoundFiles, FitIntoTheWindowInBothLanguages) {
  for (const char* language : {"en", "de"}) {
    panels_.useLanguage(*locale::findLanguage(language));
    for (const int width : {1280, 800}) {
      panels_.setDisplay({width, 720, 1.0F, 1.0F});
      settle();
      const UiRect box = button("overlay.drop");
      EXPECT_GE(box.x, width == 800 ? 0.0 : panels_.view().x) << language;
      EXPECT_LE(box.x + box.width, width) << language;
      EXPECT_LE(box.y + box.height, 720.0) << language;
      const double left = button("button.drop.open").x;  // of all that is in the dialog
      for (const auto& [name, rect] : panels_.buttons()) {
        if (name.starts_with("drop.") || name.starts_with("button.drop.") || name == "cloth.0" || name == "cloth.1") {
          EXPECT_GE(rect.x, left) << name;
          EXPECT_LE(rect.x + rect.width, box.x + box.width - (left - box.x)) << language << ' ' << name << ' ' << width;
          EXPECT_LE(rect.y + rect.height, box.y + box.height) << language << ' ' << name << ' ' << width;
        }
      }
    }
  }
}

}  // namespace
}  // namespace drape::ui
