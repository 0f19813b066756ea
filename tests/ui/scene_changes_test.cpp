#include "ui/scene_changes.hpp"

#include "session/simulation.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

/// A scene with bodies, opened and unchanged.
class SceneChanges : public ::testing::Test {
 protected:
  SceneChanges() : scene_(opened()), simulation_(scene_) {}

  static std::shared_ptr<const scene::Scene> opened() {
    const scene::SceneDescription description = scene::openScene("sphere");
    settings::Settings settings = description.settings;
    settings.step.air.drag = 0.25;  // as with --set
    return scene::buildScene(description, settings);
  }

  bool changed(const session::Command& command) {
    simulation_.apply(command);
    return changed();
  }
  bool changed() {
    simulation_.capture(snapshot_);
    return hasChanges(snapshot_, *scene_);
  }

  std::shared_ptr<const scene::Scene> scene_;
  session::Simulation simulation_;
  session::Snapshot snapshot_;
};

TEST_F(SceneChanges, NothingHasChangedAtFirst) {
  EXPECT_FALSE(changed()) << "what the command line set is no change";
  simulation_.step();
  EXPECT_FALSE(changed()) << "time that has passed is none either";
  EXPECT_TRUE(differsFromScene(snapshot_, snapshot_.settings)) << "but the scene itself says something else";
}

TEST_F(SceneChanges, ASettingIsAChangeUntilItsValueIsRestored) {
  EXPECT_TRUE(changed(session::SetSettingCommand{"drag", 0.5}));
  EXPECT_FALSE(changed(session::SetSettingCommand{"drag", 0.25}));
}

TEST_F(SceneChanges, TheViewIsNotLost) {
  EXPECT_FALSE(changed(session::SetSettingCommand{"view.wireframe", true}));
}

TEST_F(SceneChanges, APinIsAChange) {
  simulation_.apply(session::AttachCommand{{0, Vec3(1.0, 0.0, 0.0), Vec3::Zero()}});
  EXPECT_TRUE(changed(session::TogglePinCommand{}));
}

TEST_F(SceneChanges, KeyframesOfPinsAreAChangeUntilTheyAreSaved) {
  sim::contact::BodyMotion motion;
  motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}, {1.0, Vec3(0.0, 0.2, 0.0), Vec3::Zero()}};
  const session::SetPinPathsCommand command{{scene::pathOf({0}, motion, scene_->start.positions)}};
  simulation_.capture(snapshot_);
  const session::UserState before = session::userStateOf(snapshot_);
  EXPECT_TRUE(changed(command));
  const session::UserState saved = session::userStateOf(snapshot_);
  EXPECT_TRUE(hasChanges(saved, before));
  EXPECT_FALSE(hasChanges(saved, saved));
  EXPECT_FALSE(changed(session::SetPinPathsCommand{}));
}

TEST_F(SceneChanges, ABodyThatIsSwitchedOffOrMovedIsAChange) {
  EXPECT_TRUE(changed(session::SwitchBodyCommand{0, false}));
  EXPECT_FALSE(changed(session::SwitchBodyCommand{0, true}));
  sim::contact::SurfaceProperties rough = scene_->bodies->front().surface;
  rough.staticFriction += 1.0;
  EXPECT_TRUE(changed(session::SetSurfaceCommand{0, rough}));
}

TEST(SceneChangesOfAFigure, AreChangesUntilTheSceneIsAsItWas) {
  const scene::SceneDescription description = scene::openScene("dance");
  const auto scene = scene::buildScene(description, description.settings);
  session::Simulation simulation(scene);
  const figure::FigureOptions own = *description.bodies.at(0).figure;
  session::Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_FALSE(hasChanges(snapshot, *scene));
  simulation.apply(session::SetFigureCommand{0, {figure::findMotion("walk"), own.speed, own.proportions}});
  simulation.capture(snapshot);
  EXPECT_TRUE(hasChanges(snapshot, *scene));
  simulation.apply(session::SetFigureCommand{0, own});
  simulation.capture(snapshot);
  EXPECT_FALSE(hasChanges(snapshot, *scene));
}

}  // namespace
}  // namespace drape::ui
