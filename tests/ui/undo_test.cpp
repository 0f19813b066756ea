#include "ui/undo.hpp"
#include "ui/change_words.hpp"

#include "panel_fixture.hpp"

#include <algorithm>
#include <variant>

namespace drape::ui {
namespace {

/// The panels of a small grid, with undo as in the window.
class UndoPanel : public PanelFixture {
 protected:
  UndoPanel() { pass({}); }

  /// Applies the user's requests, and lets the history see the result.
  void pass(UiOutput output) {
    undo_.noteCommands(output.commands);
    apply(output);
    for (int i = 0; i < 3; ++i) {
      now_ += 0.5;
      frame();
      UiOutput more;
      undo_.watch(snapshot_, panels_.settingsInForce(snapshot_), !panels_.isBusy(), now_, more);
      apply(more);
    }
  }
  std::string undo() {
    UiOutput output;
    const std::string words = undo_.undo(output).english();
    requests_ = output.requests;
    apply(output);
    output.commands.clear();
    pass(output);
    return words;
  }
  std::string redo() {
    UiOutput output;
    const std::string words = undo_.redo(output).english();
    apply(output);
    output.commands.clear();
    pass(output);
    return words;
  }

  Undo undo_;
  double now_ = 0.0;
  std::vector<UiRequest> requests_;
};

TEST_F(UndoPanel, TakesBackADragOfASliderAndNamesIt) {
  pass(drag(widget("drag"), 0.1, 0.5));
  const double dragged = simulation_.settings().step.air.drag;
  ASSERT_GT(dragged, 1.0);
  const std::string words = undo();
  EXPECT_EQ(words.find("Undone: Drag 0 to "), 0U) << words;
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.0) << "the drag is one step";
  redo();
  EXPECT_EQ(simulation_.settings().step.air.drag, dragged);
}

TEST_F(UndoPanel, NamesSettingsWithTheirUnits) {
  simulation_.apply(session::SetSettingCommand{"density", 0.3});
  pass({});
  EXPECT_EQ(undo().find("Undone: Density "), 0U) << "not that the density counts now";
  simulation_.apply(session::SetSettingCommand{"stiffness", 150.0});
  pass({});
  simulation_.apply(session::SetSettingCommand{"stiffness", 300.0});
  pass({});
  EXPECT_EQ(undo(), "Undone: Stiffness 150 to 300 N/m");
  EXPECT_EQ(simulation_.settings().step.material.stiffness, 150.0);
  EXPECT_EQ(redo(), "Redone: Stiffness 150 to 300 N/m");
  EXPECT_EQ(simulation_.settings().step.material.stiffness, 300.0);
}

TEST_F(UndoPanel, SaysWhenThereIsNothingToUndo) {
  EXPECT_EQ(undo(), "There is nothing to undo");
  EXPECT_EQ(redo(), "There is nothing to redo");
}

TEST_F(UndoPanel, NamesPinsAndBodies) {
  simulation_.apply(session::SetPinsCommand{{3}});
  pass({});
  simulation_.apply(session::SetPinsCommand{{3, 4}});
  pass({});
  EXPECT_EQ(undo(), "Undone: 1 pin set");
  auto surface = simulation_.bodies().surface(0);
  surface.staticFriction = 0.9;
  simulation_.apply(session::SetSurfaceCommand{0, surface});
  pass({});
  EXPECT_EQ(undo(), "Undone: Static friction of ground 0.5 to 0.9");
  simulation_.apply(session::SwitchBodyCommand{0, false});
  pass({});
  EXPECT_EQ(undo(), "Undone: ground switched off");
  EXPECT_TRUE(simulation_.bodies().isOn(0));
}

TEST_F(UndoPanel, TakesBackAPlacementAndNamesIt) {
  const scene::Placements before = scene::placementsOf(simulation_.scene().description);
  scene::Placements after = before;
  after.cloths[0].position = Vec3(0.2, 0, 0);
  simulation_.apply(session::LoadSceneCommand{
      scene::buildScene(scene::withPlacements(simulation_.scene().description, after), simulation_.settings())});
  pass({});
  EXPECT_EQ(undo(), "Undone: placement of the cloth");
  const auto rebuild = std::ranges::find_if(
      requests_, [](const UiRequest& request) { return std::holds_alternative<RebuildSceneRequest>(request); });
  ASSERT_NE(rebuild, requests_.end());
  EXPECT_EQ(std::get<RebuildSceneRequest>(*rebuild).placements, before);
}

TEST(UndoInWords, NamesTheMotionAndTheMeasuresOfAFigure) {
  const scene::SceneDescription description = scene::openScene("dance");
  session::Simulation simulation(scene::buildScene(description, description.settings));
  session::Snapshot before;
  simulation.capture(before);
  session::SetFigureCommand command{0, {figure::findMotion("walk"), 1.0, {}}};
  command.figure.proportions.waist = 0.7;
  simulation.apply(command);
  session::Snapshot after;
  simulation.capture(after);
  EXPECT_EQ(changeInWords(session::userStateOf(before), session::userStateOf(after), simulation.scene()),
            "motion of figure Dance to Walk, waist of figure");
}

TEST_F(UndoPanel, NamesAFabricAndNotItsValues) {
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
  simulation_.apply(session::SetSettingCommand{"material.model", std::string("fabric")});
  simulation_.apply(session::SetSettingCommand{"material.preset", std::string("denim")});
  pass({});
  simulation_.apply(session::SetSettingCommand{"material.preset", std::string("silk")});
  pass({});
  EXPECT_EQ(undo(), "Undone: Fabric Denim to Silk");
}

TEST_F(UndoPanel, CountsManyChanges) {
  for (const char* key : {"drag", "lift", "damping", "wind.x"}) {
    simulation_.apply(session::SetSettingCommand{key, 0.25});
  }
  pass({});
  const std::string words = undo();
  EXPECT_NE(words.find(" and 2 more"), std::string::npos) << words;
}

TEST_F(UndoPanel, RebuildsTheSceneForASettingOfTheMesh) {
  // As in the window, the scene is built with the other resolution and loaded.
  scene::SceneDescription description = simulation_.scene().description;
  const int before = simulation_.settings().grid.resolution;
  settings::Settings finer = simulation_.settings();
  finer.grid.resolution = 9;
  simulation_.apply(session::LoadSceneCommand{scene::buildScene(description, finer)});
  pass({});
  EXPECT_EQ(undo(), "Undone: Grid resolution " + std::to_string(before) + " to 9");
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(std::get<RebuildSceneRequest>(requests_.front()).settings.grid.resolution, before);
}

}  // namespace
}  // namespace drape::ui
