#include "intersection/intersections.hpp"
#include "scene/scene_file.hpp"
#include "session/checkpoint.hpp"
#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace drape::session {
namespace {

/// Two sheets that hang from the upper corners of the first one, with a seam along two sides.
std::string twoPieces() {
  return testing::twoSheets(R"(
[[seams]]
from = { cloth = "front", vertices = [0, 72] }
to = { cloth = "back", vertices = [8, 80] }
duration = 0.3

[[seams]]
from = { cloth = "front", vertices = [8, 80] }
to = { cloth = "back", vertices = [0, 72] }
duration = 0.5
)");
}

std::shared_ptr<const scene::Scene> built(const std::string& text = twoPieces()) {
  return testing::sceneFrom(text);
}

void expectWelded(const Simulation& simulation) {
  EXPECT_TRUE(simulation.cloth().openSeams().empty());
  for (const sim::Seam& seam : *simulation.scene().seams) {
    EXPECT_TRUE(sim::isWelded(seam, simulation.state().positions));
  }
}

TEST(Sewing, weldsTheSeamsAndLeavesNoIntersection) {
  Simulation simulation(built());
  testing::takeSteps(simulation, 60);
  EXPECT_EQ(simulation.cloth().openSeams().size(), 2U);
  testing::takeSteps(simulation, 140);
  expectWelded(simulation);
  testing::takeSteps(simulation, 150);
  EXPECT_EQ(intersection::intersectingPairs({simulation.state().positions, simulation.model().triangles}).size(), 0U);
  EXPECT_TRUE(simulation.message().empty()) << simulation.message();
}

TEST(Sewing, showsThePiecesWithTheirOwnPins) {
  Simulation simulation(built());
  testing::takeSteps(simulation, 250);
  expectWelded(simulation);
  simulation.apply(ObserveCommand{true});
  testing::takeSteps(simulation, 1);
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_EQ(snapshot.model->pinned, snapshot.scene->model->pinned);
  EXPECT_EQ(snapshot.model->triangles, snapshot.scene->model->triangles);
  for (const sim::Seam& seam : *simulation.scene().seams) {
    for (const sim::SeamPair& pair : seam.pairs) {
      EXPECT_EQ(snapshot.velocities[pair.a], snapshot.velocities[pair.b]);
    }
  }
}

TEST(Sewing, beginsAgainAtAReset) {
  Simulation simulation(built());
  testing::takeSteps(simulation, 250);
  const auto hash = sim::stateHash(simulation.state());
  simulation.apply(ResetCommand{});
  EXPECT_EQ(simulation.cloth().openSeams().size(), 2U);
  EXPECT_EQ(simulation.state().positions, simulation.scene().start.positions);
  testing::takeSteps(simulation, 250);
  expectWelded(simulation);
  EXPECT_EQ(sim::stateHash(simulation.state()), hash);
}

TEST(Sewing, continuesFromACheckpointToTheSameBits) {
  const auto scene = built();
  for (const int before : {40, 100, 220}) {
    Simulation whole(scene);
    testing::takeSteps(whole, before);
    const std::string bytes = checkpointOf(whole);
    testing::takeSteps(whole, 60);
    Simulation resumed(scene);
    EXPECT_TRUE(continueFrom(bytes, resumed).empty());
    testing::takeSteps(resumed, 60);
    EXPECT_EQ(sim::stateHash(resumed.state()), sim::stateHash(whole.state())) << before;
    EXPECT_EQ(resumed.cloth().openSeams().size(), whole.cloth().openSeams().size());
  }
}

TEST(Sewing, goesBackToTheTimeBeforeAWeld) {
  auto description = scene::parseScene(twoPieces(), "test", "test.toml", std::filesystem::current_path());
  description.settings.timeline.memory = 100.0;
  Simulation simulation(scene::buildScene(description, description.settings));
  testing::takeSteps(simulation, 250);
  simulation.apply(GoToCommand{0.1});
  EXPECT_EQ(simulation.cloth().openSeams().size(), 2U);
  testing::takeSteps(simulation, 250);
  expectWelded(simulation);
}

TEST(Sewing, pinsAndReleasesAWeldedVertex) {
  Simulation simulation(built());
  testing::takeSteps(simulation, 250);
  simulation.apply(SetPinsCommand{{0, 40}});
  testing::takeSteps(simulation, 50);
  expectWelded(simulation);
  EXPECT_TRUE(simulation.model().pinned[40]);
  EXPECT_FALSE(simulation.model().pinned[8]);
  simulation.apply(SetPinsCommand{{81 + 8}});  // of the back, welded to vertex 0 of the front
  const Vec3 place = simulation.state().positions[0];
  testing::takeSteps(simulation, 50);
  expectWelded(simulation);
  EXPECT_EQ(simulation.state().positions[0], place);
}

TEST(Sewing, keepsTheWeldsWhenTheFabricChanges) {
  Simulation simulation(built());
  testing::takeSteps(simulation, 250);
  simulation.apply(SetSettingCommand{"material.preset", std::string("denim")});
  EXPECT_TRUE(simulation.message().empty()) << simulation.message();
  testing::takeSteps(simulation, 50);
  expectWelded(simulation);
  EXPECT_GT(simulation.model().totalMass(), 1.5 * simulation.scene().model->totalMass());
}

TEST(Sewing, weldsTheGhostAtItsOwnTime) {
  auto description = scene::parseScene(twoPieces(), "test", "test.toml", std::filesystem::current_path());
  description.settings.ghost.solver = "auto";
  Simulation simulation(scene::buildScene(description, description.settings));
  testing::takeSteps(simulation, 250);
  expectWelded(simulation);
  ASSERT_NE(simulation.ghost(), nullptr);
  for (const sim::Seam& seam : *simulation.scene().seams) {
    EXPECT_TRUE(sim::isWelded(seam, simulation.ghost()->state().positions));
  }
}

}  // namespace
}  // namespace drape::session
