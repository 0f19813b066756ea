#include "session/simulation.hpp"
#include "sim/measures/measures.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::session {
namespace {

using testing::smallGrid;

void set(Simulation& simulation, const char* key, const settings::SettingValue& value) {
  simulation.apply(SetSettingCommand{key, value});
  ASSERT_EQ(simulation.message(), "");
}

/// Typical actions of a user, with or without a ghost: the first cloth must be the same.
void use(Simulation& simulation) {
  set(simulation, "wind.z", 2.0);
  set(simulation, "drag", 0.5);
  testing::takeSteps(simulation, 10);
  simulation.apply(AttachCommand{{70, Vec3::Constant(1.0 / 3.0), Vec3(0.1, 1.2, 0.3)}});
  testing::takeSteps(simulation, 15);
  simulation.apply(TogglePinCommand{});
  set(simulation, "stiffness", 300.0);
  testing::takeSteps(simulation, 15);
  simulation.apply(DetachCommand{});
  set(simulation, "mass", 0.2);
  testing::takeSteps(simulation, 15);
}

TEST(Ghost, doesNotChangeABitOfTheFirstCloth) {
  Simulation alone(smallGrid());
  use(alone);
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    Simulation haunted(smallGrid());
    set(haunted, "ghost.solver", std::string(solver.name));
    set(haunted, "ghost.substeps", 8);
    use(haunted);
    EXPECT_EQ(sim::stateHash(haunted.state()), sim::stateHash(alone.state())) << solver.name;
  }
}

TEST(Ghost, ofTheSameSolverHasTheSameMotion) {
  Simulation simulation(smallGrid());
  set(simulation, "ghost.solver", simulation.settings().solver.name);
  use(simulation);
  ASSERT_NE(simulation.ghost(), nullptr);
  EXPECT_EQ(sim::stateHash(simulation.ghost()->state()), sim::stateHash(simulation.state()))
      << "attachment, pins, mass and settings are the same for both";
}

TEST(Ghost, beginsWhereTheFirstClothIsAndPartsFromIt) {
  Simulation simulation(smallGrid());
  testing::takeSteps(simulation, 30);
  set(simulation, "ghost.substeps", 10);
  set(simulation, "ghost.solver", std::string("one_iteration"));
  Snapshot snapshot;
  simulation.capture(snapshot);
  ASSERT_TRUE(snapshot.ghost.has_value());
  EXPECT_EQ(snapshot.ghost->meanDistance, 0.0);
  testing::takeSteps(simulation, 30);
  simulation.capture(snapshot);
  EXPECT_GT(snapshot.ghost->meanDistance, 1e-3);
  EXPECT_EQ(snapshot.ghost->meanDistance, sim::meanDistance(snapshot.positions, snapshot.ghost->positions));
  EXPECT_GT(snapshot.ghost->stepSeconds, 0.0);
}

TEST(Ghost, isRemovedWhenItIsTurnedOff) {
  Simulation simulation(smallGrid());
  set(simulation, "ghost.solver", std::string("one_iteration"));
  set(simulation, "ghost.solver", std::string("off"));
  Snapshot snapshot;
  snapshot.ghost.emplace();
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.ghost.has_value());
}

TEST(Ghost, goesBackToTheStartWithTheFirstCloth) {
  Simulation simulation(smallGrid());
  set(simulation, "ghost.substeps", 10);
  set(simulation, "ghost.solver", std::string("one_iteration"));
  testing::takeSteps(simulation, 30);
  const auto moved = sim::stateHash(simulation.ghost()->state());
  simulation.apply(ResetCommand{});
  EXPECT_EQ(sim::stateHash(simulation.ghost()->state()), sim::stateHash(simulation.state()));
  testing::takeSteps(simulation, 30);
  EXPECT_EQ(sim::stateHash(simulation.ghost()->state()), moved);
}

TEST(Ghost, comesWithASceneThatAsksForIt) {
  auto scene = std::make_shared<scene::Scene>(*smallGrid());
  scene->settings.ghost.solver = "one_iteration";
  Simulation simulation(scene);
  ASSERT_NE(simulation.ghost(), nullptr);
  EXPECT_EQ(sim::stateHash(simulation.ghost()->state()), sim::stateHash(scene->start));
  const auto other = smallGrid(12);
  simulation.apply(LoadSceneCommand{other});
  EXPECT_EQ(simulation.ghost(), nullptr) << "the other scene has none";
}

/// With axial force derivatives a large step blows up, and twenty small ones do not.
std::shared_ptr<const scene::Scene> explosive() {
  auto scene = std::make_shared<scene::Scene>(*smallGrid());
  scene->settings.step.derivative = sim::ForceDerivative::Axial;
  scene->settings.step.material.stiffness = 1e3;
  scene->settings.step.timeStep = 1.0 / 30.0;
  scene->settings.step.substeps = 20;
  scene->settings.ghost.solver = "one_iteration";
  return scene;
}

TEST(Ghost, thatBlowsUpIsRemovedAndTheFirstClothContinues) {
  Simulation simulation(explosive());
  int steps = 0;
  for (; simulation.ghost() != nullptr && steps < 200; ++steps) {
    simulation.step();
  }
  ASSERT_EQ(simulation.ghost(), nullptr);
  EXPECT_EQ(simulation.settings().ghost.solver, "off");
  EXPECT_NE(simulation.message().english().find("ghost"), std::string::npos) << simulation.message();
  EXPECT_FALSE(simulation.blewUp());
  EXPECT_FALSE(simulation.paused());
  EXPECT_EQ(simulation.stepIndex(), steps);
  simulation.step();
  EXPECT_EQ(simulation.stepIndex(), steps + 1);
  EXPECT_TRUE(sim::isFinite(simulation.state()));
}

TEST(Ghost, isReplayed) {
  const auto scene = smallGrid();
  Simulation original(scene);
  set(original, "ghost.substeps", 5);
  testing::takeSteps(original, 5);
  set(original, "ghost.solver", std::string("one_iteration"));
  use(original);
  set(original, "ghost.substeps", 2);
  testing::takeSteps(original, 5);
  set(original, "gravity", 5.0);

  Simulation again(scene);
  again.replay(original.log());
  ASSERT_NE(again.ghost(), nullptr);
  EXPECT_EQ(sim::stateHash(again.ghost()->state()), sim::stateHash(original.ghost()->state()));
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(original.state()));
}

}  // namespace
}  // namespace drape::session
