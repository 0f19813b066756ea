#include "session/simulation.hpp"
#include "session/user_state.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace drape::session {
namespace {

std::vector<Vec3> raised(const Simulation& simulation, double by) {
  std::vector<Vec3> positions = simulation.state().positions;
  for (Vec3& position : positions) {
    position.y() += by;
  }
  return positions;
}

TEST(PlaceClothCommand, startsTheSceneInOtherPositions) {
  Simulation simulation(testing::smallGrid());
  testing::takeSteps(simulation, 5);
  const std::vector<Vec3> places = raised(simulation, 0.3);
  simulation.apply(PlaceClothCommand{places, true});
  EXPECT_EQ(simulation.state().positions, places);
  EXPECT_EQ(simulation.state().velocities[7], Vec3::Zero());
  EXPECT_EQ(simulation.stepIndex(), 0);
  EXPECT_EQ(simulation.state().time, simulation.scene().start.time);
  testing::takeSteps(simulation, 5);
  EXPECT_NE(simulation.state().positions, places);
  simulation.apply(ResetCommand{});
  EXPECT_EQ(simulation.state().positions, places) << "reset returns there";
  Snapshot snapshot;
  simulation.capture(snapshot);
  ASSERT_TRUE(snapshot.placedStart);
  EXPECT_EQ(*snapshot.placedStart, places);
}

TEST(PlaceClothCommand, withoutPositionsReturnsToTheStartOfTheScene) {
  Simulation simulation(testing::smallGrid());
  simulation.apply(PlaceClothCommand{raised(simulation, 0.3), true});
  testing::takeSteps(simulation, 2);
  simulation.apply(PlaceClothCommand{{}, true});
  EXPECT_EQ(simulation.state().positions, simulation.scene().start.positions);
  EXPECT_EQ(simulation.stepIndex(), 0);
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.placedStart);
}

TEST(PlaceClothCommand, isPartOfTheStateToWhichUndoReturns) {
  Simulation simulation(testing::smallGrid());
  Snapshot snapshot;
  simulation.capture(snapshot);
  const UserState bare = userStateOf(snapshot);
  simulation.apply(PlaceClothCommand{raised(simulation, 0.3), true});
  simulation.capture(snapshot);
  const UserState placed = userStateOf(snapshot);
  EXPECT_FALSE(areSame(bare, placed));
  for (const Command& command : commandsBetween(placed, bare, simulation.scene())) {
    simulation.apply(command);
  }
  EXPECT_EQ(simulation.state().positions, simulation.scene().start.positions);
  for (const Command& command : commandsBetween(bare, placed, simulation.scene())) {
    simulation.apply(command);
  }
  EXPECT_EQ(simulation.state().positions, *placed.placedStart);
  simulation.capture(snapshot);
  EXPECT_TRUE(areSame(userStateOf(snapshot), placed)) << "the same positions in another place of memory";
}

TEST(PlaceClothCommand, isForgottenByTheNextScene) {
  Simulation simulation(testing::smallGrid());
  simulation.apply(PlaceClothCommand{raised(simulation, 0.3), true});
  const auto scene = testing::smallGrid();
  simulation.apply(LoadSceneCommand{scene});
  EXPECT_EQ(simulation.state().positions, scene->start.positions);
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.placedStart);
}

TEST(PlaceClothCommand, canGoOnAtThePresentTime) {
  Simulation simulation(testing::smallGrid());
  testing::takeSteps(simulation, 5);
  const double time = simulation.state().time;
  const std::vector<Vec3> places = raised(simulation, 0.3);
  simulation.apply(PlaceClothCommand{places, false});
  EXPECT_EQ(simulation.state().positions, places);
  EXPECT_EQ(simulation.state().time, time);
  EXPECT_EQ(simulation.stepIndex(), 5);
  simulation.apply(ResetCommand{});
  EXPECT_EQ(simulation.state().positions, simulation.scene().start.positions);
}

TEST(PlaceClothCommand, refusesOtherNumbersOfPlacesAndPlacesThatAreNotFinite) {
  Simulation simulation(testing::smallGrid());
  const std::vector<Vec3> before = simulation.state().positions;
  std::vector<Vec3> places = raised(simulation, 0.3);
  places.back().x() = std::numeric_limits<double>::quiet_NaN();
  simulation.apply(PlaceClothCommand{places, true});
  EXPECT_NE(simulation.message(), "");
  EXPECT_EQ(simulation.state().positions, before);
  places.pop_back();
  simulation.apply(PlaceClothCommand{places, true});
  EXPECT_NE(simulation.message(), "");
  EXPECT_EQ(simulation.state().positions, before);
}

TEST(PlaceClothCommand, isReplayedWithTheSameBits) {
  Simulation first(testing::smallGrid());
  testing::takeSteps(first, 3);
  first.apply(PlaceClothCommand{raised(first, 0.2), true});
  testing::takeSteps(first, 3);
  Simulation second(testing::smallGrid());
  second.replay(first.log(), first.stepsTaken());
  EXPECT_EQ(stateHash(second.state()), stateHash(first.state()));
}

}  // namespace
}  // namespace drape::session
