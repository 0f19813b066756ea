#include "session/simulation.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/motion/unfolding.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::session {
namespace {

using testing::smallGrid;

Vec3 centreOf(const Simulation& simulation, int triangle) {
  Vec3 centre = Vec3::Zero();
  for (const int v : simulation.model().triangles[static_cast<std::size_t>(triangle)]) {
    centre += simulation.state().positions[static_cast<std::size_t>(v)] / 3.0;
  }
  return centre;
}

AttachCommand attachAt(const Simulation& simulation, int triangle, const Vec3& offset) {
  return {{triangle, Vec3::Constant(1.0 / 3.0), centreOf(simulation, triangle) + offset}};
}

int pinCount(const Simulation& simulation) {
  const auto& pinned = simulation.model().pinned;
  return static_cast<int>(std::count(pinned.begin(), pinned.end(), true));
}

TEST(Simulation, startsAtTheScenesStartWithTheScenesSettings) {
  const auto scene = smallGrid();
  const Simulation simulation(scene);
  EXPECT_EQ(sim::stateHash(simulation.state()), sim::stateHash(scene->start));
  EXPECT_EQ(simulation.settings().material.mass, 0.1);
  EXPECT_EQ(simulation.stepIndex(), 0);
  EXPECT_FALSE(simulation.paused());
}

TEST(Simulation, appliesASettingToTheNextStep) {
  Simulation simulation(smallGrid());
  simulation.apply(SetSettingCommand{"gravity", 0.0});
  simulation.step();
  EXPECT_EQ(simulation.state().velocities[40], Vec3(Vec3::Zero()));
  simulation.apply(SetSettingCommand{"gravity", 5.0});
  simulation.step();
  EXPECT_LT(simulation.state().velocities[40].y(), 0.0);
}

TEST(Simulation, refusesABadSettingWithAMessageAndKeepsTheOldOne) {
  Simulation simulation(smallGrid());
  simulation.apply(SetSettingCommand{"stiffness", -1.0});
  EXPECT_NE(simulation.message().english().find("stiffness"), std::string::npos);
  EXPECT_EQ(simulation.settings().step.material.stiffness, smallGrid()->settings.step.material.stiffness);
  simulation.apply(SetSettingCommand{"no_such_thing", 1.0});
  EXPECT_NE(simulation.message().english().find("no_such_thing"), std::string::npos);
  simulation.apply(SetSettingCommand{"stiffness", 55.0});
  EXPECT_TRUE(simulation.message().empty());
  EXPECT_EQ(simulation.settings().step.material.stiffness, 55.0);
}

TEST(Simulation, changesTheMassWithoutMovingTheCloth) {
  Simulation simulation(smallGrid());
  for (int i = 0; i < 20; ++i) {
    simulation.step();
  }
  const auto hash = sim::stateHash(simulation.state());
  simulation.apply(SetSettingCommand{"mass", 0.7});
  EXPECT_EQ(sim::stateHash(simulation.state()), hash);
  EXPECT_NEAR(simulation.model().totalMass(), 0.7, 1e-12);
  simulation.apply(SetSettingCommand{"density", 0.25});
  EXPECT_NEAR(simulation.model().totalMass(), 0.25, 1e-12) << "the sheet has one square metre";
}

TEST(Simulation, pullsTheAttachedPointToTheMouseAndLetsGo) {
  Simulation simulation(smallGrid());
  simulation.apply(attachAt(simulation, 70, Vec3(0.1, 0.15, 0.05)));
  for (int i = 0; i < 300; ++i) {
    simulation.step();
  }
  Snapshot snapshot;
  simulation.capture(snapshot);
  ASSERT_TRUE(snapshot.attachment.has_value());
  EXPECT_LT((snapshot.attachment->point - snapshot.attachment->target).norm(), 0.02);
  simulation.apply(DetachCommand{});
  const Vec3 before = snapshot.attachment->target;
  for (int i = 0; i < 60; ++i) {
    simulation.step();
  }
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.attachment.has_value());
  EXPECT_GT((centreOf(simulation, 70) - before).norm(), 0.1);
}

TEST(Simulation, refusesToAttachToAMissingTriangle) {
  Simulation simulation(smallGrid());
  simulation.apply(AttachCommand{{100000, Vec3::Constant(1.0 / 3.0), Vec3::Zero()}});
  EXPECT_FALSE(simulation.message().empty());
  simulation.apply(AttachCommand{{0, Vec3(2.0, -0.5, -0.5), Vec3::Zero()}});
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.attachment.has_value());
}

TEST(Simulation, pinsTheAttachedVertexInPlaceAndReleasesIt) {
  Simulation simulation(smallGrid());
  EXPECT_EQ(pinCount(simulation), 2);
  simulation.apply(TogglePinCommand{});
  EXPECT_EQ(pinCount(simulation), 2) << "there is no attachment yet";
  simulation.apply(attachAt(simulation, 70, Vec3(0.0, 0.2, 0.0)));
  for (int i = 0; i < 50; ++i) {
    simulation.step();
  }
  simulation.apply(TogglePinCommand{});
  EXPECT_EQ(pinCount(simulation), 3);
  simulation.apply(DetachCommand{});
  const int vertex = simulation.model().triangles[70][0];
  const Vec3 place = simulation.state().positions[static_cast<std::size_t>(vertex)];
  for (int i = 0; i < 50; ++i) {
    simulation.step();
  }
  EXPECT_EQ(simulation.state().positions[static_cast<std::size_t>(vertex)], place);
  simulation.apply(AttachCommand{{70, Vec3(1.0, 0.0, 0.0), place}});
  simulation.apply(TogglePinCommand{});
  EXPECT_EQ(pinCount(simulation), 2);
}

TEST(Simulation, resetsToTheStartAndRunsTheSameAgain) {
  Simulation simulation(smallGrid());
  const auto run = [&] {
    for (int i = 0; i < 40; ++i) {
      simulation.step();
    }
    return sim::stateHash(simulation.state());
  };
  const auto first = run();
  simulation.apply(ResetCommand{});
  EXPECT_EQ(simulation.stepIndex(), 0);
  EXPECT_EQ(simulation.state().time, 0.0);
  EXPECT_EQ(run(), first);
}

TEST(Simulation, takesOneStepAndStaysPaused) {
  Simulation simulation(smallGrid());
  simulation.apply(SingleStepCommand{});
  EXPECT_TRUE(simulation.paused());
  EXPECT_EQ(simulation.stepIndex(), 1);
}

TEST(Simulation, goesBackToTheLastFiniteStateWhenItBlowsUp) {
  auto scene = std::make_shared<scene::Scene>(*smallGrid());
  scene->settings.step.material.stiffness = 1e7;  // far beyond the stability of explicit steps of this length
  scene->settings.solver.name = "verlet";
  Simulation simulation(scene);
  for (int i = 0; i < 200 && !simulation.paused(); ++i) {
    simulation.step();
  }
  EXPECT_TRUE(simulation.paused());
  EXPECT_TRUE(simulation.blewUp());
  EXPECT_NE(simulation.message().english().find("blew up"), std::string::npos) << simulation.message();
  EXPECT_TRUE(sim::isFinite(simulation.state()));
}

TEST(Simulation, saysWhenSpringsAreStretchedBeyondAllMeasure) {
  auto scene = std::make_shared<scene::Scene>(*smallGrid());
  Snapshot snapshot;
  Simulation(scene).capture(snapshot);
  EXPECT_TRUE(snapshot.message.empty());
  for (Vec3& position : scene->start.positions) {
    position *= 3.5;
  }
  Simulation(scene).capture(snapshot);
  EXPECT_NE(snapshot.message.english().find("time step is too long"), std::string::npos) << snapshot.message;
}

TEST(Simulation, computesTheEnergyBalanceOnRequest) {
  Simulation simulation(smallGrid());
  Snapshot snapshot;
  simulation.apply(SetSettingCommand{"damping", 0.01});
  simulation.step();
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.balance.has_value()) << "it costs, so it is off unless asked for";
  simulation.apply(SetSettingCommand{"energy_balance", true});
  simulation.apply(attachAt(simulation, 70, Vec3(0.1, 0.15, 0.05)));
  const double start = sim::energyOf(simulation.model(), simulation.settings().step, simulation.state()).total();
  for (int i = 0; i < 30; ++i) {
    simulation.step();
  }
  simulation.capture(snapshot);
  ASSERT_TRUE(snapshot.balance.has_value());
  EXPECT_NEAR(snapshot.balance->change(), snapshot.energy.total() - start, 1e-9);
  EXPECT_LT(snapshot.balance->damping(), 0.0);
  EXPECT_GT(snapshot.balance->attachment(), 0.0);
  simulation.apply(ResetCommand{});
  simulation.capture(snapshot);
  EXPECT_EQ(snapshot.balance->change(), 0.0);
}

TEST(Simulation, hasTheSameMotionWithAndWithoutTheEnergyBalance) {
  Simulation plain(smallGrid());
  Simulation measured(smallGrid());
  measured.apply(SetSettingCommand{"energy_balance", true});
  for (int i = 0; i < 30; ++i) {
    plain.step();
    measured.step();
  }
  EXPECT_EQ(sim::stateHash(plain.state()), sim::stateHash(measured.state()));
}

TEST(Simulation, movesPinsAndTheGhostsPinsAndNothingElse) {
  Simulation simulation(smallGrid());
  simulation.apply(SetSettingCommand{"ghost.solver", std::string("verlet")});
  const sim::ClothState before = simulation.state();
  simulation.apply(MovePinsCommand{Vec3(0.0, 0.0, 0.5)});
  const auto& pinned = simulation.model().pinned;
  for (std::size_t v = 0; v < pinned.size(); ++v) {
    const Vec3 expected = before.positions[v] + (pinned[v] ? Vec3(0.0, 0.0, 0.5) : Vec3(0.0, 0.0, 0.0));
    EXPECT_EQ(simulation.state().positions[v], expected);
    EXPECT_EQ(simulation.ghost()->state().positions[v], expected);
  }
  simulation.step();
  EXPECT_EQ(simulation.message(), "");
}

TEST(Simulation, saysWhenThereAreNoPinsToMove) {
  Simulation simulation(smallGrid(9, {"pins=none"}));
  simulation.apply(MovePinsCommand{Vec3(0.0, 0.0, 0.5)});
  EXPECT_NE(simulation.message().english().find("there are no pins"), std::string::npos);
}

TEST(Simulation, unfoldsAStartInOnePointAndSaysSo) {
  auto scene = std::make_shared<scene::Scene>(*smallGrid(9, {"gravity=0", "damping=0.05", "pins=none"}));
  scene->start = sim::stateAtRest(std::vector<Vec3>(scene->start.positions.size(), Vec3(0.0, 1.0, 0.0)));
  Simulation simulation(scene);
  EXPECT_NE(simulation.message().english().find("can unfold"), std::string::npos);
  for (int step = 0; step < 150; ++step) {
    simulation.step();
  }
  EXPECT_GE(sim::dimensionsOf(simulation.state().positions, 0.05), 2) << "edges are of 0.125 m";
}

TEST(Simulation, replaysItsLogToTheSameBits) {
  const auto scene = smallGrid();
  Simulation original(scene);
  const auto advance = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      original.step();
    }
  };
  advance(10);
  original.apply(SetSettingCommand{"stiffness", 300.0});
  original.apply(attachAt(original, 30, Vec3(0.0, 0.3, 0.0)));
  advance(15);
  original.apply(MoveAttachmentCommand{Vec3(0.2, 1.5, 0.1)});
  original.apply(TogglePinCommand{});
  original.apply(SingleStepCommand{});
  advance(7);
  original.apply(ResetCommand{});
  advance(20);
  original.apply(DetachCommand{});

  Simulation again(scene);
  again.replay(original.log());
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(original.state()));
  EXPECT_EQ(again.stepsTaken(), original.stepsTaken());
}

TEST(Simulation, loadsAnotherSceneWithItsOwnSettings) {
  Simulation simulation(smallGrid());
  simulation.apply(SetSettingCommand{"stiffness", 333.0});
  const auto other = smallGrid(12);
  simulation.apply(LoadSceneCommand{other});
  EXPECT_EQ(simulation.model().vertexCount(), 144);
  EXPECT_EQ(simulation.settings().step.material.stiffness, other->settings.step.material.stiffness);
  simulation.step();
  EXPECT_TRUE(sim::isFinite(simulation.state()));
}

TEST(Simulation, forwardsAnExceptionFromAStep) {
  struct Enough {};
  Simulation simulation(smallGrid(9, {"solver=newton", "tolerance=1e-9"}));
  simulation.setProgressCallback([] { throw Enough(); });
  EXPECT_THROW(simulation.step(), Enough);
  EXPECT_EQ(simulation.stepsTaken(), 0);
}

TEST(Simulation, numbersSnapshotsSoThatEveryChangeShows) {
  Simulation simulation(smallGrid());
  Snapshot snapshot;
  simulation.capture(snapshot);
  const auto before = snapshot.version;
  simulation.capture(snapshot);
  EXPECT_EQ(snapshot.version, before);
  simulation.step();
  simulation.capture(snapshot);
  EXPECT_GT(snapshot.version, before);
}

}  // namespace
}  // namespace drape::session
