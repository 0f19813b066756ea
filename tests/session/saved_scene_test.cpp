// A saved scene moves as the one that it was saved from.
#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"
#include "session/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace drape::session {
namespace {

std::shared_ptr<const scene::Scene> built(const std::string& name, const std::vector<std::string>& changes) {
  const scene::SceneDescription description = scene::openScene(name);
  settings::Settings settings = description.settings;
  for (const std::string& change : changes) {
    settings::assignSettingExpression(settings, change);
  }
  return scene::buildScene(description, settings);
}

std::shared_ptr<const scene::Scene> reopened(const scene::WrittenScene& written) {
  const scene::SceneDescription description =
      scene::parseScene(written.text, "saved", "saved.toml", std::filesystem::current_path());
  return scene::buildScene(description, description.settings);
}

std::uint64_t hashAfter(Simulation& simulation, double seconds) {
  while (simulation.state().time < seconds) {
    simulation.step();
  }
  return sim::stateHash(simulation.state());
}

struct Change {
  const char* scene;
  std::vector<std::string> changes;
};

class SavedScene : public ::testing::TestWithParam<Change> {};

TEST_P(SavedScene, MovesToTheSameBits) {
  const auto original = built(GetParam().scene, GetParam().changes);
  const auto written = scene::writeScene(*original, scene::unchanged(*original), std::filesystem::current_path());
  EXPECT_TRUE(written.notes.empty());
  Simulation first(original);
  Simulation second(reopened(written));
  constexpr double seconds = 0.5;
  EXPECT_EQ(hashAfter(first, seconds), hashAfter(second, seconds)) << written.text;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SavedScene,
    ::testing::Values(Change{"grid", {"stiffness=77", "wind.x=2.5", "drag=0.3", "grid.resolution=9"}},
                      Change{"flag", {"mass=0.2", "time_step=1/150"}},
                      Change{"curtain", {"material.preset=denim", "fabric.shear=61", "grid.resolution=17"}},
                      Change{"flag_on_pole", {"grid.resolution=13"}}, Change{"cape", {}},
                      Change{"table_runner", {"grid.resolution=9"}}),
    [](const auto& each) { return std::string(each.param.scene); });

TEST(SavedSceneWithPins, StartsWithTheUsersPinsAndBodies) {
  const auto original = built("turning_sphere", {"grid.resolution=9"});
  Simulation simulation(original);
  auto surface = simulation.bodies().surface(0);
  surface.staticFriction = 1.5;
  surface.kineticFriction = 1.25;
  simulation.apply(SetPinsCommand{{0, 7, 40}});
  simulation.apply(SetSurfaceCommand{0, surface});
  scene::SceneNow now{simulation.settings(), simulation.model().pinned, {}, {}};
  for (std::size_t i = 0; i < simulation.bodies().bodies().size(); ++i) {
    now.bodies.push_back({simulation.bodies().isOn(i), Vec3::Zero(), simulation.bodies().surface(i)});
  }
  const auto written = scene::writeScene(*original, now, std::filesystem::current_path());
  ASSERT_EQ(written.notes.size(), 1U) << "the places of the pins";
  Simulation second(reopened(written));
  EXPECT_EQ(second.model().pinned, simulation.model().pinned) << written.text;
  EXPECT_EQ(second.bodies().surface(0), surface);
  EXPECT_EQ(hashAfter(simulation, 0.5), hashAfter(second, 0.5)) << written.text;
}

}  // namespace
}  // namespace drape::session
