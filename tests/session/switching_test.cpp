#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::session {
namespace {

double largestMove(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    largest = std::max(largest, (to[i] - from[i]).norm());
  }
  return largest;
}

/// A soft falling sheet, with steps that are stable with every method.
Simulation calmSheet() {
  auto scene = std::make_shared<scene::Scene>(*testing::smallGrid());
  scene->settings.step.material.stiffness = 10.0;
  scene->settings.step.material.damping = 0.002;
  scene->settings.step.timeStep = 1.0 / 150.0;
  scene->settings.step.substeps = 10;
  Simulation simulation(scene);
  for (int i = 0; i < 40; ++i) {
    simulation.step();
  }
  return simulation;
}

/// Changes a setting during a run and compares the next step with the one without the change.
void expectNoJump(Simulation& simulation, const char* key, const settings::SettingValue& value) {
  Simulation unchanged(std::make_shared<scene::Scene>(simulation.scene()));
  unchanged.replay(simulation.log());
  while (unchanged.stepsTaken() < simulation.stepsTaken()) {
    unchanged.step();
  }
  const std::vector<Vec3> before = simulation.state().positions;
  ASSERT_EQ(unchanged.state().positions, before);
  const double time = simulation.state().time;
  const auto hash = sim::stateHash(simulation.state());
  simulation.apply(SetSettingCommand{key, value});
  ASSERT_EQ(simulation.message(), "");
  EXPECT_EQ(sim::stateHash(simulation.state()), hash) << "changing a setting moves nothing";
  unchanged.step();
  simulation.step();
  const double usual = largestMove(before, unchanged.state().positions);
  ASSERT_GT(usual, 1e-3) << "the sheet moves";
  EXPECT_LT(largestMove(before, simulation.state().positions), 1.5 * usual);
  EXPECT_LT(largestMove(simulation.state().positions, unchanged.state().positions), 0.5 * usual);
  EXPECT_NEAR(simulation.state().time, time + simulation.settings().step.timeStep, 1e-12);
  for (int i = 0; i < 40; ++i) {
    simulation.step();
  }
  EXPECT_FALSE(simulation.blewUp()) << simulation.message();
  EXPECT_TRUE(sim::isFinite(simulation.state()));
}

TEST(Pinning, stopsAVertexAtOnceWithAnyIntegration) {
  for (const char* integration : {"backward_euler", "theta", "bdf2"}) {
    Simulation simulation = calmSheet();
    simulation.apply(SetSettingCommand{"integration", std::string(integration)});
    simulation.step();
    const int vertex = simulation.model().triangles[70][0];
    simulation.apply(AttachCommand{{70, Vec3(1.0, 0.0, 0.0), Vec3::Zero()}});
    simulation.step();
    const Vec3 place = simulation.state().positions[static_cast<std::size_t>(vertex)];
    simulation.apply(TogglePinCommand{});
    simulation.step();
    EXPECT_EQ(simulation.state().positions[static_cast<std::size_t>(vertex)], place) << integration;
  }
}

class SwitchingTo : public ::testing::TestWithParam<std::string> {};

TEST_P(SwitchingTo, carriesTheStateOn) {
  Simulation simulation = calmSheet();
  expectNoJump(simulation, "solver", GetParam());
}

TEST_P(SwitchingTo, andAwayFromItCarriesTheStateOn) {
  auto scene = std::make_shared<scene::Scene>(calmSheet().scene());
  scene->settings.solver.name = GetParam();
  Simulation simulation(scene);
  for (int i = 0; i < 40; ++i) {
    simulation.step();
  }
  expectNoJump(simulation, "solver", std::string("one_iteration"));
}

TEST_P(SwitchingTo, anotherIntegrationOrOtherSubstepsCarriesTheStateOn) {
  for (const char* integration : {"theta", "bdf2"}) {
    auto scene = std::make_shared<scene::Scene>(calmSheet().scene());
    scene->settings.solver.name = GetParam();
    Simulation simulation(scene);
    for (int i = 0; i < 20; ++i) {
      simulation.step();
    }
    expectNoJump(simulation, "integration", std::string(integration));
    expectNoJump(simulation, "substeps", 14);
    expectNoJump(simulation, "integration", std::string("backward_euler"));
  }
}

std::vector<std::string> solverNames() {
  std::vector<std::string> names;
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    names.emplace_back(solver.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Solvers, SwitchingTo, ::testing::ValuesIn(solverNames()),
                         [](const auto& solver) { return solver.param; });

}  // namespace
}  // namespace drape::session
