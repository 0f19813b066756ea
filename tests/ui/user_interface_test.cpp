#include "ui/user_interface.hpp"

#include "panel_fixture.hpp"
#include "sim/solvers/solver.hpp"
#include "ui/panels.hpp"

#include <imgui.h>

namespace drape::ui {
namespace {

class UserInterfaceTest : public PanelFixture {};

TEST_F(UserInterfaceTest, PlayUnpauses) {
  const UiOutput output = click(button("button.play"));
  ASSERT_EQ(output.commands.size(), 1U);
  EXPECT_FALSE(std::get<session::PauseCommand>(output.commands.front()).paused);
}

TEST_F(UserInterfaceTest, StepAndResetAreCommands) {
  const UiOutput step = click(button("button.step"));
  ASSERT_EQ(step.commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<session::SingleStepCommand>(step.commands.front()));
  const UiOutput reset = click(button("button.reset"));
  ASSERT_EQ(reset.commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<session::ResetCommand>(reset.commands.front()));
}

TEST_F(UserInterfaceTest, ASolverOutOfItsDepthHasOneClickToAuto) {
  simulation_.apply(session::SetSettingCommand{"stiffness", 10.0});
  simulation_.apply(session::SetSettingCommand{"time_step", 1e-3});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.auto")) << "nothing is wrong";
  simulation_.apply(session::SetSettingCommand{"stiffness", 1e5});
  settle();
  ASSERT_EQ(panels_.buttons().contains("button.auto"), sim::findSolver("auto") != nullptr);
  if (sim::findSolver("auto") != nullptr) {
    const UiOutput output = click(button("button.auto"));
    EXPECT_EQ(std::get<std::string>(lastValue(output, "solver")), "auto");
    apply(output);
    settle();
    EXPECT_FALSE(panels_.buttons().contains("button.auto"));
  }
}

TEST_F(UserInterfaceTest, AClockThatFallsBehindForStiffnessHasOneClickToKeepPace) {
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.soften"));
  simulation_.apply(session::SetSettingCommand{"auto.cost", 0.1});
  simulation_.apply(session::SetSettingCommand{"stiffness", 1e5});
  simulation_.step();
  settle();
  const UiOutput output = click(button("button.soften"));
  EXPECT_TRUE(std::get<bool>(lastValue(output, "auto.soften")));
  apply(output);
  simulation_.step();
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.soften"));
}

/// The panels of a scene with a fabric.
class FabricPaceTest : public PanelFixture {
 protected:
  FabricPaceTest() : PanelFixture("curtain") {}
};

TEST_F(FabricPaceTest, AFabricThatIsTooStiffHasOneClickToALowerStretchStiffness) {
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});
  simulation_.apply(session::SetSettingCommand{"auto.strain", 0.0});
  simulation_.apply(session::SetSettingCommand{"auto.cost", 0.1});
  simulation_.step();
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.soften")) << "it has no springs";
  const UiOutput output = click(button("button.strain"));
  EXPECT_GT(std::get<double>(lastValue(output, "auto.strain")), 0.0);
  apply(output);
  simulation_.step();
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.strain"));
}

/// The panels of a scene with a figure.
class FigurePanelTest : public PanelFixture {
 protected:
  FigurePanelTest() : PanelFixture("dance") {}

  [[nodiscard]] figure::FigureOptions present() {
    simulation_.capture(snapshot_);
    return *snapshot_.bodies.at(0).figure;
  }
};

TEST_F(FigurePanelTest, ChoosesTheMotion) {
  settle();
  click(widget("body.figure.motion"));
  settle();
  const UiOutput output = click(button("body.figure.motion=squat"));
  ASSERT_EQ(output.commands.size(), 1U);
  const auto& command = std::get<session::SetFigureCommand>(output.commands.front());
  EXPECT_EQ(command.body, 0);
  EXPECT_EQ(command.figure.motion->name, "squat");
  EXPECT_EQ(command.figure.proportions, figure::Proportions()) << "which stay as they are built";
  apply(output);
  EXPECT_EQ(present().motion->name, "squat");
  settle();
  apply(click(widget("body.figure.motion"), 0.5, 1));
  EXPECT_EQ(present().motion->name, "dance") << "a right click restores that of the scene";
}

TEST_F(FigurePanelTest, ChangesOneMeasureWithinItsRange) {
  settle();
  apply(typeInto(widget("body.figure.waist"), "0.71"));
  settle();
  EXPECT_EQ(present().proportions.waist, 0.71);
  EXPECT_EQ(present().proportions.hip, std::nullopt);
  apply(typeInto(widget("body.figure.height"), "9"));
  settle();
  EXPECT_EQ(present().proportions.height, 2.2) << "the maximum";
  EXPECT_EQ(present().proportions.waist, 0.71);
  apply(drag(widget("body.figure.speed"), 0.9, 0.5));
  settle();
  EXPECT_NEAR(present().speed, 1.05, 0.05);
  EXPECT_TRUE(typeInto(widget("body.figure.chest"), "wide").commands.empty());
  apply(click(widget("body.figure.waist"), 0.5, 1));
  EXPECT_EQ(present().proportions.waist, std::nullopt) << "as it is built";
  EXPECT_EQ(present().proportions.height, 2.2);
}

TEST_F(FigurePanelTest, KeepsAChoiceThatHasNotArrivedYet) {
  settle();
  UiOutput all = typeInto(widget("body.figure.waist"), "0.71");
  append(all, typeInto(widget("body.figure.hip"), "1.02"));  // the simulation is busy with a step
  apply(all);
  EXPECT_EQ(present().proportions.waist, 0.71);
  EXPECT_EQ(present().proportions.hip, 1.02);
}

/// The panels of a scene with a sphere and a solid ground.
class ContactPanelTest : public PanelFixture {
 protected:
  ContactPanelTest() : PanelFixture("sphere") {}
};

TEST_F(ContactPanelTest, HasABoxForEachBodyThatSwitchesIt) {
  settle();
  for (const auto& [name, index] : {std::pair("body.sphere", 0), std::pair("body.ground", 1)}) {
    const UiOutput output = click(button(name), 0.1);
    ASSERT_EQ(output.commands.size(), 1U) << name;
    const auto& command = std::get<session::SwitchBodyCommand>(output.commands.front());
    EXPECT_EQ(command.body, index);
    EXPECT_FALSE(command.on);
    apply(output);
    settle();
    EXPECT_FALSE(simulation_.bodies().isOn(static_cast<std::size_t>(index)));
    EXPECT_TRUE(std::get<session::SwitchBodyCommand>(click(button(name), 0.1).commands.at(0)).on) << "and on again";
  }
}

TEST_F(ContactPanelTest, ChangesTheSurfaceOfOneBody) {
  settle();
  EXPECT_FALSE(panels_.widgets().contains("body.ground.thickness")) << "until it is asked for";
  click(button("surface.ground"));
  settle();
  const sim::contact::SurfaceProperties before = simulation_.bodies().surface(1);
  UiOutput output = typeInto(widget("body.ground.thickness"), "1/100");
  ASSERT_EQ(output.commands.size(), 1U);
  EXPECT_EQ(std::get<session::SetSurfaceCommand>(output.commands.front()).body, 1);
  apply(output);
  settle();
  EXPECT_EQ(simulation_.bodies().surface(1).thickness, 0.01);
  EXPECT_EQ(simulation_.bodies().surface(1).staticFriction, before.staticFriction);
  apply(typeInto(widget("body.ground.kinetic_friction"), "99"));
  settle();
  EXPECT_EQ(simulation_.bodies().surface(1).kineticFriction, 10.0) << "the maximum";
  EXPECT_EQ(simulation_.bodies().surface(1).staticFriction, 10.0) << "which is never less";
  apply(drag(widget("body.ground.static_friction"), 0.9, 0.1));
  settle();
  EXPECT_NEAR(simulation_.bodies().surface(1).staticFriction, 0.2, 0.02);
  EXPECT_EQ(simulation_.bodies().surface(1).kineticFriction, simulation_.bodies().surface(1).staticFriction);
  EXPECT_TRUE(typeInto(widget("body.ground.thickness"), "thin").commands.empty());
  // A right click restores the value of the scene.
  apply(click(widget("body.ground.thickness"), 0.5, 1));
  EXPECT_EQ(simulation_.bodies().surface(1).thickness, before.thickness);
  EXPECT_EQ(simulation_.bodies().surface(0), simulation_.scene().bodies->at(0).surface) << "the other one's is its own";
}

TEST_F(ContactPanelTest, OffersToUntangleWhileTheClothIntersectsItself) {
  settle();
  EXPECT_FALSE(panels_.buttons().contains("untangle"));
  EXPECT_FALSE(panels_.buttons().contains("button.untangle"));
  // The right half of the sheet is folded over the left one, and passes through it.
  auto tangled = std::make_shared<scene::Scene>(simulation_.scene());
  for (Vec3& position : tangled->start.positions) {
    const double x = position.x();
    position = x > 0.0 ? Vec3(0.013 - x, position.y() + 0.02 - 0.1 * x, position.z() + 0.017) : position;
  }
  simulation_.apply(session::LoadSceneCommand{tangled});
  simulation_.apply(session::SetSettingCommand{"view.intersections", true});
  settle();
  EXPECT_NE(panels_.status().find("The cloth intersects itself in"), std::string::npos) << panels_.status();
  for (const char* name : {"untangle", "button.untangle"}) {
    const UiOutput output = click(button(name));
    ASSERT_EQ(output.commands.size(), 1U) << name;
    EXPECT_TRUE(std::holds_alternative<session::UntangleCommand>(output.commands.front()));
  }
}

TEST_F(ContactPanelTest, DrawsContactsOnDemand) {
  settle();
  EXPECT_TRUE(std::get<bool>(lastValue(click(widget("view.contacts"), 0.02), "view.contacts")));
}

TEST_F(UserInterfaceTest, ViewButtonsAreRequests) {
  const UiOutput output = click(button("button.top"));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<UiAction>(output.requests.front()), UiAction::ViewTop);
}

TEST_F(UserInterfaceTest, ThePathFieldOpensAFile) {
  click(button("scene.path"));
  settle();
  EXPECT_TRUE(panels_.takesText());
  ImGui::GetIO().AddInputCharactersUTF8("shirt.obj");
  frame();
  const UiOutput output = click(button("scene.path.button"));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<OpenSceneRequest>(output.requests.front()).nameOrPath, "shirt.obj");
}

TEST_F(UserInterfaceTest, ABuiltInSceneIsChosenFromTheList) {
  click(button("scene.choice"));
  settle();
  const std::string first = scene::sceneList().front().name;
  const UiOutput output = click(button("scene.choice=" + first));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<OpenSceneRequest>(output.requests.front()).nameOrPath, first);
}

TEST_F(UserInterfaceTest, TheDialTurnsTheWind) {
  const UiOutput output = click(button("wind.dial"), 0.8);
  EXPECT_GT(std::get<double>(lastValue(output, "wind.x")), 1.0);
  EXPECT_NEAR(std::get<double>(lastValue(output, "wind.z")), 0.0, 0.5);
}

TEST_F(UserInterfaceTest, PanelsCoverTheirOwnPlaceOnly) {
  EXPECT_TRUE(panels_.covers({10.0, 10.0}));
  const UiRect view = panels_.view();
  EXPECT_FALSE(panels_.covers({view.x + view.width / 2.0, view.y + view.height / 2.0}));
  panels_.showPanels(false);
  settle();
  EXPECT_FALSE(panels_.covers({10.0, 10.0}));
  EXPECT_TRUE(panels_.widgets().empty());
  EXPECT_EQ(panels_.view().width, 1280.0);
}

TEST_F(UserInterfaceTest, HelpCoversTheMiddleAndClosesBeside) {
  panels_.showHelp(true);
  settle();
  const UiRect view = panels_.view();
  EXPECT_TRUE(panels_.covers({view.x + view.width / 2.0, view.y + view.height / 2.0}));
  EXPECT_TRUE(panels_.closeOverlay());
  EXPECT_FALSE(panels_.helpVisible());
  EXPECT_FALSE(panels_.closeOverlay());
}

TEST_F(UserInterfaceTest, AnErrorStaysUntilItIsClosed) {
  stats_.error = "shirt.obj is not a mesh";
  settle();
  ASSERT_TRUE(panels_.buttons().contains("button.close"));
  click(button("button.close"));
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.close"));
  stats_.error = {};
  frame();
  stats_.error = "shirt.obj is not a mesh";
  settle();
  EXPECT_TRUE(panels_.buttons().contains("button.close")) << "the same thing went wrong again";
}

TEST_F(UserInterfaceTest, TheSameErrorAppearsAgain) {
  stats_.error = "there is no file 'shirt.obj'";
  stats_.failures = 1;
  settle();
  click(button("button.close"));
  settle();
  ASSERT_FALSE(panels_.buttons().contains("overlay.error"));
  stats_.failures = 2;
  settle();
  EXPECT_TRUE(panels_.buttons().contains("overlay.error"));
}

TEST_F(UserInterfaceTest, ALongErrorScrollsInsideThePicture) {
  std::string text = "garment.obj cannot be read.";
  for (int line = 0; line < 300; ++line) {
    text += "\nline " + std::to_string(line) + ": this is not a vertex";
  }
  stats_.error = text;
  panels_.setDisplay({.width = 1280, .height = 720, .density = 1.0F, .scale = 1.0F});
  settle();
  const UiRect& notice = button("overlay.error");
  EXPECT_LT(notice.y + notice.height, 700.0);
  EXPECT_TRUE(panels_.covers({notice.x + 20.0, notice.y + notice.height - 10.0})) << "the wheel scrolls it";
}

TEST_F(UserInterfaceTest, TheFirstHintDisappearsWithTheFirstDrag) {
  ASSERT_TRUE(panels_.buttons().contains("hint.drag"));
  const UiRect hint = button("hint.drag");
  EXPECT_FALSE(panels_.covers({hint.x + 5.0, hint.y + 5.0})) << "the cloth behind it can be taken";
  simulation_.apply(session::AttachCommand{{0, Vec3(1.0, 0.0, 0.0), Vec3::Zero()}});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("hint.drag"));
  simulation_.apply(session::DetachCommand{});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("hint.drag"));
}

TEST_F(UserInterfaceTest, BoxesOverThePictureNeverOverlap) {
  stats_.error =
      "shirt.obj is not a mesh. It has a very long explanation, which needs more than one line in a window that "
      "is as small as this one.";
  stats_.loading = "Opening coat.obj \u2026";
  stats_.loadingShare = 0.4;
  panels_.setDisplay({.width = 800, .height = 600, .density = 1.0F, .scale = 1.0F});
  settle();
  double bottom = 0.0;
  for (const char* name : {"overlay.error", "overlay.loading", "hint.drag"}) {
    const UiRect& box = button(name);
    EXPECT_GE(box.y, bottom) << name;
    EXPECT_GE(box.x, panels_.view().x) << name;
    EXPECT_LE(box.x + box.width, 800.0) << name;
    bottom = box.y + box.height;
  }
}

TEST_F(UserInterfaceTest, ResetAllAppearsWhenAValueDiffers) {
  EXPECT_TRUE(click(button("button.reset_all")).requests.empty()) << "there is nothing to restore";
  simulation_.apply(session::SetSettingCommand{"drag", 2.0});
  settle();
  const UiOutput output = click(button("button.reset_all"));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<UiAction>(output.requests.front()), UiAction::ResetAll);
}

TEST_F(UserInterfaceTest, QuittingIsAskedAndAnswered) {
  panels_.askToQuit(true);
  settle();
  ASSERT_TRUE(panels_.buttons().contains("overlay.quit"));
  const UiRect dialog = button("overlay.quit");
  click({dialog.x + 5.0, dialog.y + 5.0, 2.0, 2.0});
  settle();
  ASSERT_TRUE(panels_.buttons().contains("overlay.quit")) << "a click on the question is no answer";
  EXPECT_TRUE(click(button("button.stay")).requests.empty());
  settle();
  EXPECT_FALSE(panels_.buttons().contains("overlay.quit"));
  panels_.askToQuit(true);
  settle();
  EXPECT_TRUE(panels_.closeOverlay()) << "Esc";
  settle();
  EXPECT_FALSE(panels_.buttons().contains("overlay.quit"));
  panels_.askToQuit(true);
  settle();
  const UiOutput output = click(button("button.quit"));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<UiAction>(output.requests.front()), UiAction::QuitAndLoseChanges);
}

TEST(QuitQuestion, NamesWhatIsLost) {
  const ExportProgress film{"film.mp4", 0.5, 3.0};
  EXPECT_EQ(whatQuittingLoses({}, true), "Your changes to this scene would be lost.");
  EXPECT_EQ(whatQuittingLoses(film, false), "The export of film.mp4 would be lost.");
  EXPECT_EQ(whatQuittingLoses(film, true), "The export of film.mp4 and your changes to this scene would be lost.");
  EXPECT_EQ(whatQuittingLoses({}, false), "Nothing would be lost.") << "the export has ended meanwhile";
}

TEST_F(UserInterfaceTest, OneQuestionIsAskedAtATime) {
  panels_.askWhichIsTheCloth({.scenes = {}, .meshes = {"/a/coat.obj", "/a/body.obj"}, .others = {}});
  panels_.askToQuit(true);
  panels_.showHelp(true);
  for (const char* name : {"overlay.quit", "overlay.drop", "overlay.help"}) {
    settle();
    for (const char* other : {"overlay.quit", "overlay.drop", "overlay.help"}) {
      EXPECT_EQ(panels_.buttons().contains(other), std::string(name) == other) << other << " beside " << name;
    }
    EXPECT_TRUE(panels_.closeOverlay());
  }
  EXPECT_FALSE(panels_.closeOverlay());
}

TEST_F(UserInterfaceTest, TheQuestionAboutManyFilesFitsIntoASmallWindow) {
  DroppedFiles files;
  for (int i = 0; i < 40; ++i) {
    files.meshes.push_back("/a/" + std::string(200, 'w') + std::to_string(i) + ".obj");
  }
  panels_.askWhichIsTheCloth(files);
  for (const auto& [width, height] : {std::pair(1280, 720), std::pair(640, 400)}) {
    panels_.setDisplay({.width = width, .height = height, .density = 1.0F, .scale = 1.0F});
    settle();
    for (const char* name : {"overlay.drop", "button.drop.open", "button.drop.cancel"}) {
      const UiRect& rect = button(name);
      EXPECT_GE(rect.x, 0.0) << name;
      EXPECT_GE(rect.y, 0.0) << name;
      EXPECT_LE(rect.x + rect.width, width) << name;
      EXPECT_LE(rect.y + rect.height, height) << name;
    }
  }
}

TEST_F(UserInterfaceTest, TheStatusLineTakesMoreLinesWhereLargeTextDoesNotFitInOne) {
  panels_.setDisplay({.width = 520, .height = 480, .density = 1.0F, .scale = 2.0F});
  settle();
  const UiRect facts = button("status.facts");
  const double line = ImGui::GetFontSize();
  EXPECT_GT(facts.height, 1.5 * line) << "title, vertices and pace need two lines";
  EXPECT_LE(facts.x + facts.width, 520.0);
  EXPECT_LE(facts.y + facts.height, 480.0);
  const UiRect above = button("overlay.status");
  EXPECT_LE(above.y + above.height, 480.0);
  panels_.setDisplay({.width = 1280, .height = 800, .density = 1.0F, .scale = 1.0F});
  settle();
  EXPECT_LT(button("status.facts").height, 1.5 * ImGui::GetFontSize());
}

TEST_F(UserInterfaceTest, TheStatusLineSpeaksOfTheClothFirst) {
  snapshot_.paused = true;
  settle();
  const std::string status = panels_.status();
  const std::size_t vertices = status.find("vertices");
  ASSERT_NE(vertices, std::string::npos) << status;
  EXPECT_EQ(status.find(snapshot_.scene->description.title), 0U) << status;
  EXPECT_GT(status.find("paused"), vertices) << status;
  EXPECT_EQ(status.find("iteration"), std::string::npos) << "the solver is for those who ask: " << status;
}

TEST_F(UserInterfaceTest, AClickOnTheStatusLineShowsTheSolver) {
  EXPECT_FALSE(panels_.buttons().contains("status.details"));
  click(button("status.facts"), 0.1);
  settle();
  EXPECT_TRUE(panels_.buttons().contains("status.details"));
  EXPECT_TRUE(panels_.closeOverlay());
  settle();
  EXPECT_FALSE(panels_.buttons().contains("status.details"));
}

TEST_F(UserInterfaceTest, TheStatusLineGrowsForALongMessage) {
  simulation_.apply(session::SetSettingCommand{"solver", std::string("auto")});  // which gives no warning
  settle();
  EXPECT_FALSE(panels_.buttons().contains("overlay.status"));
  stats_.notice =
      "The file holds 12 pieces, 3 of which touch nothing. They are kept, but nothing holds them, so they will fall to "
      "the ground as soon as the clock runs. Remove them in the program that made the file, or pin them here.";
  settle();
  ASSERT_TRUE(panels_.buttons().contains("overlay.status"));
  EXPECT_GT(button("overlay.status").height, 15.0);
  EXPECT_NE(panels_.status().find("or pin them here."), std::string::npos);
}

TEST_F(UserInterfaceTest, AdvancedIsClosedAtFirstAndMaterialAndAirAreInSight) {
  UserInterface fresh({.width = 1440, .height = 900, .density = 1.0F, .scale = 1.0F}, UserInterface::Backend::None);
  UiOutput output;
  for (int i = 0; i < 3; ++i) {
    fresh.build(snapshot_, stats_, output);
  }
  for (const char* key : {"stiffness", "damping", "drag", "lift", "wind.x", "wind.y", "wind.z"}) {
    ASSERT_TRUE(fresh.widgets().contains(key)) << key;
    const UiRect& row = fresh.widgets().at(key);
    EXPECT_TRUE(row.visible) << key;
    EXPECT_LT(row.y + row.height, 870.0) << key;
  }
  EXPECT_FALSE(fresh.widgets().contains("solver"));
  EXPECT_FALSE(fresh.widgets().contains("substeps"));
}

TEST_F(UserInterfaceTest, ScalesWithTheDisplay) {
  const double height = widget("drag").height;
  panels_.setDisplay({.width = 3840, .height = 6000, .density = 1.0F, .scale = 2.0F});
  settle();
  EXPECT_NEAR(widget("drag").height, 2.0 * height, 3.0);
}

TEST_F(UserInterfaceTest, ATinyWindowIsStillLaidOut) {
  panels_.setDisplay({.width = 60, .height = 20, .density = 1.0F, .scale = 1.0F});
  settle();
  EXPECT_GE(panels_.view().width, 1.0);
  EXPECT_GE(panels_.view().height, 1.0);
}

TEST(UiScale, FollowsTheSettingThenTheMonitor) {
  EXPECT_FLOAT_EQ(uiScale(1.5, 2.0F, 2160), 1.5F);
  EXPECT_FLOAT_EQ(uiScale(0.0, 1.0F, 1080), 1.0F);
  EXPECT_FLOAT_EQ(uiScale(0.0, 1.0F, 2160), 2.0F);
  EXPECT_FLOAT_EQ(uiScale(0.0, 2.5F, 2160), 2.5F);
}

}  // namespace
}  // namespace drape::ui
