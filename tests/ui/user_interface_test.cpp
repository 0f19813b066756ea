#include "ui/user_interface.hpp"

#include "panel_fixture.hpp"
#include "sim/solver.hpp"

#include <imgui.h>

namespace drape {
namespace {

class UserInterfaceTest : public PanelFixture {};

TEST_F(UserInterfaceTest, PlayUnpauses) {
  const UiOutput output = click(button("button.play"));
  ASSERT_EQ(output.commands.size(), 1U);
  EXPECT_FALSE(std::get<PauseCommand>(output.commands.front()).paused);
}

TEST_F(UserInterfaceTest, StepAndResetAreCommands) {
  const UiOutput step = click(button("button.step"));
  ASSERT_EQ(step.commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<SingleStepCommand>(step.commands.front()));
  const UiOutput reset = click(button("button.reset"));
  ASSERT_EQ(reset.commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<ResetCommand>(reset.commands.front()));
}

TEST_F(UserInterfaceTest, ASolverOutOfItsDepthHasOneClickToAuto) {
  simulation_.apply(SetSettingCommand{"stiffness", 10.0});
  simulation_.apply(SetSettingCommand{"time_step", 1e-3});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.auto")) << "nothing is wrong";
  simulation_.apply(SetSettingCommand{"stiffness", 1e5});
  settle();
  ASSERT_EQ(panels_.buttons().contains("button.auto"), findSolver("auto") != nullptr);
  if (findSolver("auto") != nullptr) {
    const UiOutput output = click(button("button.auto"));
    EXPECT_EQ(std::get<std::string>(lastValue(output, "solver")), "auto");
    apply(output);
    settle();
    EXPECT_FALSE(panels_.buttons().contains("button.auto"));
  }
}

TEST_F(UserInterfaceTest, AClockThatFallsBehindForStiffnessHasOneClickToKeepPace) {
  simulation_.apply(SetSettingCommand{"solver", std::string("auto")});
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.soften"));
  simulation_.apply(SetSettingCommand{"auto.work", 0.1});
  simulation_.apply(SetSettingCommand{"stiffness", 1e5});
  simulation_.step();
  settle();
  const UiOutput output = click(button("button.soften"));
  EXPECT_TRUE(std::get<bool>(lastValue(output, "auto.soften")));
  apply(output);
  simulation_.step();
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.soften"));
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
    const auto& command = std::get<SwitchBodyCommand>(output.commands.front());
    EXPECT_EQ(command.body, index);
    EXPECT_FALSE(command.on);
    apply(output);
    settle();
    EXPECT_FALSE(simulation_.bodies().isOn(static_cast<std::size_t>(index)));
    EXPECT_TRUE(std::get<SwitchBodyCommand>(click(button(name), 0.1).commands.at(0)).on) << "and on again";
  }
}

TEST_F(ContactPanelTest, ChangesTheSurfaceOfOneBody) {
  settle();
  EXPECT_FALSE(panels_.widgets().contains("body.ground.thickness")) << "until it is asked for";
  click(button("surface.ground"));
  settle();
  const SurfaceProperties before = simulation_.bodies().surface(1);
  UiOutput output = typeInto(widget("body.ground.thickness"), "1/100");
  ASSERT_EQ(output.commands.size(), 1U);
  EXPECT_EQ(std::get<SetSurfaceCommand>(output.commands.front()).body, 1);
  apply(output);
  settle();
  EXPECT_EQ(simulation_.bodies().surface(1).thickness, 0.01);
  EXPECT_EQ(simulation_.bodies().surface(1).staticFriction, before.staticFriction);
  apply(typeInto(widget("body.ground.kinetic_friction"), "99"));
  settle();
  EXPECT_EQ(simulation_.bodies().surface(1).kineticFriction, 10.0) << "the most that is allowed";
  EXPECT_EQ(simulation_.bodies().surface(1).staticFriction, 10.0) << "which is never less";
  apply(drag(widget("body.ground.static_friction"), 0.9, 0.1));
  settle();
  EXPECT_NEAR(simulation_.bodies().surface(1).staticFriction, 0.2, 0.02);
  EXPECT_EQ(simulation_.bodies().surface(1).kineticFriction, simulation_.bodies().surface(1).staticFriction);
  EXPECT_TRUE(typeInto(widget("body.ground.thickness"), "thin").commands.empty());
  // A right click gives back what the scene says.
  apply(click(widget("body.ground.thickness"), 0.5, 1));
  EXPECT_EQ(simulation_.bodies().surface(1).thickness, before.thickness);
  EXPECT_EQ(simulation_.bodies().surface(0), simulation_.scene().bodies->at(0).surface) << "the other one's is its own";
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
  const UiOutput output = click(button("button.open"));
  ASSERT_EQ(output.requests.size(), 1U);
  EXPECT_EQ(std::get<OpenSceneRequest>(output.requests.front()).nameOrPath, "shirt.obj");
}

TEST_F(UserInterfaceTest, ABuiltInSceneIsChosenFromTheList) {
  click(button("scene.choice"));
  settle();
  const std::string first = sceneList().front().name;
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
  stats_.error.clear();
  frame();
  stats_.error = "shirt.obj is not a mesh";
  settle();
  EXPECT_TRUE(panels_.buttons().contains("button.close")) << "the same thing went wrong again";
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
}  // namespace drape
