#include "panel_fixture.hpp"

#include "fields/shown_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace drape::ui {
namespace {

/// The panels with what the viewer gives them for fields.
class FieldPanels : public PanelFixture {
 protected:
  FieldPanels() {
    stats_.fields = &fields_;
    simulation_.apply(session::ObserveCommand{});
    fieldFrame();
  }

  UiOutput fieldFrame() {
    simulation_.capture(snapshot_);
    stats_.field = &display_.update(snapshot_, fields_);
    return frame();
  }

  void set(const std::string& key, const settings::SettingValue& value) {
    simulation_.apply(session::SetSettingCommand{key, value});
    for (int i = 0; i < 3; ++i) {
      fieldFrame();
    }
  }

  [[nodiscard]] bool shows(const std::string& name) const { return panels_.buttons().contains(name); }

  fields::SnapshotFields fields_;
  fields::FieldDisplay display_;
};

TEST_F(FieldPanels, TheLegendIsThereWhileAColourMapIs) {
  fieldFrame();
  EXPECT_FALSE(shows("hint.colour_map"));
  set("view.colour_map", std::string("strain_warp"));
  ASSERT_TRUE(shows("hint.colour_map"));
  const UiRect legend = button("hint.colour_map");
  EXPECT_TRUE(panels_.view().contains({legend.x, legend.y}));
  EXPECT_TRUE(panels_.view().contains({legend.x + legend.width, legend.y + legend.height}));
  EXPECT_FALSE(panels_.covers({legend.x + 5.0, legend.y + 5.0})) << "clicks reach the picture behind it";
  set("view.colour_map", std::string("off"));
  EXPECT_FALSE(shows("hint.colour_map"));
}

TEST_F(FieldPanels, TheRangeHasRowsOnlyWhileAColourMapIsShown) {
  EXPECT_FALSE(panels_.widgets().contains("view.colour_range"));
  set("view.colour_map", std::string("speed"));
  EXPECT_TRUE(panels_.widgets().contains("view.colour_range"));
  EXPECT_FALSE(panels_.widgets().contains("view.colour_low")) << "the range is automatic";
  set("view.colour_range", std::string("fixed"));
  EXPECT_TRUE(panels_.widgets().contains("view.colour_low"));
  EXPECT_TRUE(panels_.widgets().contains("view.colour_high"));
}

TEST_F(FieldPanels, AValueCanBeTypedForTheEndOfAFixedRange) {
  set("view.colour_map", std::string("speed"));
  set("view.colour_range", std::string("fixed"));
  const UiOutput output = typeInto(widget("view.colour_high"), "7");
  EXPECT_EQ(lastValue(output, "view.colour_high"), settings::SettingValue(7.0));
  apply(output);
  EXPECT_EQ(simulation_.settings().view.colourHigh, 7.0);
}

TEST_F(FieldPanels, WithoutPanelsAndNoticesOnlyTheLegendIsDrawn) {
  panels_.showPanels(false);
  panels_.showNotices(false);
  set("view.colour_map", std::string("speed"));
  EXPECT_EQ(panels_.buttons().size(), 1U);
  EXPECT_TRUE(shows("hint.colour_map"));
}

TEST_F(FieldPanels, APickedVertexShowsItsValuesUntilItIsPickedAgain) {
  EXPECT_TRUE(panels_.pick(40));
  fieldFrame();
  fieldFrame();
  ASSERT_TRUE(shows("overlay.picked"));
  for (const sim::fields::FieldInfo& field : sim::fields::fieldTable()) {
    EXPECT_TRUE(shows("picked." + std::string(field.name))) << field.name;
  }
  EXPECT_TRUE(panels_.pick(40));
  fieldFrame();
  EXPECT_FALSE(shows("overlay.picked"));
}

TEST_F(FieldPanels, FourVerticesCanBePickedAndNoFifth) {
  for (const int vertex : {1, 2, 3, 4}) {
    EXPECT_TRUE(panels_.pick(vertex));
  }
  EXPECT_FALSE(panels_.pick(5));
  EXPECT_EQ(panels_.picked().vertices().size(), 4U);
  fieldFrame();
  fieldFrame();
  const UiRect box = button("overlay.picked");
  EXPECT_LE(box.x + box.width, panels_.view().x + panels_.view().width);
  EXPECT_GE(box.x, panels_.view().x);
}

TEST_F(FieldPanels, EscapeAndTheButtonClearThem) {
  panels_.pick(1);
  fieldFrame();
  EXPECT_TRUE(panels_.closeOverlay());
  EXPECT_TRUE(panels_.picked().vertices().empty());
  EXPECT_FALSE(panels_.closeOverlay());
  panels_.pick(2);
  fieldFrame();
  fieldFrame();
  click(button("button.clear_picked"));
  EXPECT_TRUE(panels_.picked().vertices().empty());
}

TEST_F(FieldPanels, AClickOnAFieldPlotsItAndAButtonAsksForAFile) {
  panels_.pick(1);
  fieldFrame();
  fieldFrame();
  click(button("picked.speed"));
  const UiOutput output = click(button("button.write_csv"));
  const bool asked = std::any_of(output.requests.begin(), output.requests.end(), [](const UiRequest& request) {
    const auto* action = std::get_if<UiAction>(&request);
    return action != nullptr && *action == UiAction::SaveProbes;
  });
  EXPECT_TRUE(asked);
}

TEST_F(FieldPanels, TheHistoryHasOneSampleForEachTimeAndStartsAgainAfterAReset) {
  panels_.pick(7);
  fieldFrame();
  for (int i = 0; i < 30; ++i) {
    simulation_.step();
    fieldFrame();
    fieldFrame();
  }
  const auto samples = panels_.picked().samples();
  ASSERT_GT(samples.size(), 3U);
  EXPECT_TRUE(
      std::is_sorted(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.time < b.time; }));
  EXPECT_DOUBLE_EQ(samples.back().time, simulation_.state().time);
  const std::string csv = panels_.picked().csv();
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<long>(samples.size()) + 1);
  simulation_.apply(session::ResetCommand{});
  fieldFrame();
  EXPECT_EQ(panels_.picked().samples().size(), 1U);
}

TEST_F(FieldPanels, TheHistoryStaysWhenTheTimelineGoesBackAndThePlotMarksThePresentTime) {
  simulation_.apply(session::SetSettingCommand{"timeline.memory", 100.0});
  panels_.pick(7);
  for (int i = 0; i < 60; ++i) {
    simulation_.step();
    fieldFrame();
  }
  fieldFrame();
  click(button("picked.speed"));
  const double newest = simulation_.state().time;
  EXPECT_FALSE(shows("plot.present")) << "the newest time needs no mark";
  const std::size_t count = panels_.picked().samples().size();
  simulation_.apply(session::GoToCommand{0.5 * newest});
  const double present = simulation_.state().time;
  ASSERT_LT(present, 0.6 * newest);
  fieldFrame();
  const auto samples = panels_.picked().samples();
  EXPECT_GE(samples.size(), count);
  EXPECT_DOUBLE_EQ(samples.back().time, newest);
  EXPECT_DOUBLE_EQ(panels_.picked().now().time, present);
  EXPECT_TRUE(std::ranges::is_sorted(samples, {}, &PickedVertices::Sample::time));
  ASSERT_TRUE(shows("plot.present"));
  const double middle = button("plot.present").x;
  simulation_.apply(session::GoToCommand{0.25 * newest});
  fieldFrame();
  EXPECT_LT(button("plot.present").x, middle);
  for (int i = 0; i < 10; ++i) {
    simulation_.step();
    fieldFrame();
  }
  EXPECT_LT(panels_.picked().samples().back().time, 0.6 * newest) << "another motion replaces what came later";
}

TEST_F(FieldPanels, AnotherSceneHasNoPickedVertices) {
  panels_.pick(7);
  fieldFrame();
  const scene::SceneDescription grid = scene::openScene("grid");
  simulation_.apply(session::LoadSceneCommand{scene::buildScene(grid, grid.settings)});
  fieldFrame();
  EXPECT_TRUE(panels_.picked().vertices().empty());
}

TEST_F(FieldPanels, TheTimelineGoesToTheTimeUnderTheMouse) {
  simulation_.apply(session::SetSettingCommand{"timeline.memory", 100.0});
  for (int i = 0; i < 60; ++i) {
    simulation_.step();
  }
  fieldFrame();
  fieldFrame();
  ASSERT_TRUE(shows("timeline"));
  const UiOutput output = drag(button("timeline"), 0.9, 0.5);
  std::vector<double> times;
  for (const session::Command& command : output.commands) {
    if (const auto* go = std::get_if<session::GoToCommand>(&command)) {
      times.push_back(go->time);
    }
  }
  ASSERT_EQ(times.size(), 2U) << "one command for each place of the mouse";
  const double begin = snapshot_.timeline->begin;
  const double end = snapshot_.timeline->end;
  EXPECT_NEAR(times.back(), begin + 0.5 * (end - begin), 0.01 * (end - begin));
}

TEST_F(FieldPanels, TheTimelineStaysAboveALongMessage) {
  simulation_.apply(session::SetSettingCommand{"timeline.memory", 100.0});
  for (int i = 0; i < 10; ++i) {
    simulation_.step();
  }
  std::string lines;
  for (int line = 0; line < 4; ++line) {
    lines += "A message of several lines, which the status line shows above its usual place in the window.\n";
  }
  stats_.notice = lines;
  fieldFrame();
  fieldFrame();
  ASSERT_TRUE(shows("timeline"));
  ASSERT_TRUE(shows("overlay.status"));
  const UiRect line = button("timeline");
  EXPECT_LT(line.y + line.height, button("overlay.status").y);
}

}  // namespace
}  // namespace drape::ui
