#include "panel_fixture.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

/// A scene like one from a file in centimetres with z up, small enough for fast layout.
std::shared_ptr<const scene::Scene> withReading(const scene::Scene& from) {
  auto scene = std::make_shared<scene::Scene>(from);
  scene::MeshReading reading;
  reading.unit = "cm";
  reading.metresPerUnit = 0.01;
  reading.unitReason = scene::ReadingReason::Shape;
  reading.up = "z";
  reading.upReason = scene::ReadingReason::Shape;
  reading.size = {0.6, 0.77, 0.2};
  reading.alternatives = {{"unit", "m"}, {"unit", "inch"}, {"up", "y"}};
  scene->reading = reading;
  return scene;
}

class ReadingNotice : public PanelFixture {
 protected:
  ReadingNotice() {
    simulation_.apply(session::LoadSceneCommand{withReading(simulation_.scene())});
    simulation_.apply(session::PauseCommand{true});
    settle();
  }

  /// The settings of the rebuild that a click requests.
  settings::Settings rebuiltBy(const std::string& name) {
    const UiOutput output = click(button(name));
    if (output.requests.size() != 1 || !std::holds_alternative<RebuildSceneRequest>(output.requests.front())) {
      ADD_FAILURE() << name << " does not build the scene again";
      return {};
    }
    return std::get<RebuildSceneRequest>(output.requests.front()).settings;
  }
};

TEST_F(ReadingNotice, OneClickChangesTheUnit) {
  EXPECT_EQ(rebuiltBy("reading.unit=m").mesh.unit, "m");
}

TEST_F(ReadingNotice, OneClickChangesTheAxis) {
  const settings::Settings settings = rebuiltBy("reading.up=y");
  EXPECT_EQ(settings.mesh.up, "y");
  EXPECT_EQ(settings.mesh.unit, simulation_.settings().mesh.unit) << "the unit stays as it is";
}

TEST_F(ReadingNotice, StaysUntilItIsAccepted) {
  for (int i = 0; i < 700; ++i) {  // more than ten seconds of frames
    frame();
  }
  ASSERT_TRUE(panels_.buttons().contains("reading.accept"));
  EXPECT_TRUE(click(button("reading.accept")).requests.empty());
  settle();
  EXPECT_FALSE(panels_.buttons().contains("reading.accept"));
  simulation_.apply(session::ResetCommand{});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("reading.accept")) << "a reset is no reason to ask again";
}

TEST_F(ReadingNotice, CoversThePictureBelowIt) {
  const UiRect& rect = button("overlay.reading");
  EXPECT_TRUE(panels_.covers({rect.x + rect.width / 2.0, rect.y + rect.height / 2.0}));
  EXPECT_GE(rect.x, panels_.view().x) << "beside the panels";
  EXPECT_LE(rect.x + rect.width, panels_.view().x + panels_.view().width);
}

TEST_F(ReadingNotice, FitsIntoANarrowWindow) {
  panels_.setDisplay({.width = 700, .height = 600, .density = 1.0F, .scale = 1.0F});
  settle();
  const UiRect& rect = button("overlay.reading");
  EXPECT_GE(rect.x, panels_.view().x - 1.0);
  EXPECT_LE(rect.x + rect.width, 701.0);
}

TEST_F(ReadingNotice, HasOneClickForPinsThatHoldEverything) {
  auto scene = std::make_shared<scene::Scene>(simulation_.scene());
  scene->reading.reset();
  scene->pinAdvice = scene::Advice{text::Sentence("All {} vertices are pinned, so nothing can move.", 81), "pins",
                                   "shape", text::Sentence("Pin by shape")};
  simulation_.apply(session::LoadSceneCommand{scene});
  settle();
  EXPECT_EQ(rebuiltBy("pins.pins").mesh.pins, "shape");
}

TEST_F(ReadingNotice, DoesNotAppearForABuiltInScene) {
  const scene::SceneDescription grid = scene::openScene("grid");
  simulation_.apply(session::LoadSceneCommand{scene::buildScene(grid, grid.settings)});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("overlay.reading"));
}

}  // namespace
}  // namespace drape::ui
