#include "session/stretch_cause.hpp"

#include "scene/rest_pattern.hpp"
#include "session/simulation.hpp"
#include "sim/measures/hanging_load.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace drape::session {
namespace {

/// A scene after some simulated time, and its snapshot.
struct Outcome {
  Simulation simulation;
  Snapshot snapshot;
};

Outcome simulated(const std::shared_ptr<const scene::Scene>& scene, double seconds) {
  Outcome outcome{Simulation(scene), {}};
  while (outcome.simulation.state().time < seconds && !outcome.simulation.blewUp()) {
    outcome.simulation.step();
  }
  outcome.simulation.capture(outcome.snapshot);
  return outcome;
}

/// The diagnosis for a small grid with these settings after that time; Solver without text when there is none.
StretchDiagnosis causeFor(const std::vector<std::string>& settings, double seconds = 1.0) {
  const Outcome outcome = simulated(testing::smallGrid(9, settings), seconds);
  EXPECT_TRUE(outcome.snapshot.overstretched.has_value()) << "stretch " << outcome.snapshot.maxStretch;
  return outcome.snapshot.overstretched.value_or(StretchDiagnosis{});
}

/// Free vertices four times as far from the origin as at the start, and moving, as a solver that fails leaves them.
sim::ClothState thrownApart(const scene::Scene& scene) {
  sim::ClothState state = scene.start;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (!scene.model->pinned[v]) {
      state.positions[v] *= 4.0;
      state.velocities[v] = 1e6 * state.positions[v];
    }
  }
  return state;
}

TEST(StretchCause, ClothThatHangsAsItShouldHasNone) {
  const Outcome outcome = simulated(testing::smallGrid(9, {"solver=auto", "stiffness=200"}), 0.5);
  EXPECT_FALSE(outcome.snapshot.overstretched.has_value());
  EXPECT_EQ(outcome.snapshot.message, "");
}

TEST(StretchCause, SoftClothIsNamedWithItsStretchAndTheStiffnessThatHelps) {
  const StretchDiagnosis found = causeFor({"solver=auto", "stiffness=0.5", "damping=0.05"});
  EXPECT_EQ(found.cause, StretchCause::Soft);
  EXPECT_NE(found.advice.text.english().find("Too soft"), std::string::npos) << found.advice.text;
  EXPECT_NE(found.advice.text.english().find("% at a stiffness of 0.5 N/m"), std::string::npos) << found.advice.text;
  EXPECT_EQ(found.advice.text.english().find("time step"), std::string::npos) << found.advice.text;
  ASSERT_EQ(found.advice.key, "stiffness");
  const Outcome cured =
      simulated(testing::smallGrid(9, {"solver=auto", "damping=0.05", "stiffness=" + found.advice.value}), 1.0);
  EXPECT_LT(cured.snapshot.maxStretch, 0.6) << "what is advised helps";
}

TEST(StretchCause, HeavyClothIsNamedWithItsDensity) {
  const StretchDiagnosis found = causeFor({"solver=auto", "density=80", "stiffness=200", "damping=1"});
  EXPECT_EQ(found.cause, StretchCause::Heavy);
  EXPECT_NE(found.advice.text.english().find("the cloth weighs 80 kg"), std::string::npos) << found.advice.text;
  EXPECT_EQ(found.advice.key, "density");
}

TEST(StretchCause, TheStretchThatTheWeightImpliesIsNearTheOneThatComesOut) {
  scene::SceneDescription description = scene::openScene("grid");
  description.cloth().source = scene::GridSource{scene::GridSource::Plane::Vertical};
  description.cloth().pins.at(0).corners.clear();
  description.cloth().pins.at(0).edges = {"top"};
  description.settings.grid.resolution = 9;
  for (const char* setting : {"solver=auto", "stiffness=2", "damping=0.1", "drag=1"}) {
    settings::assignSettingExpression(description.settings, setting);
  }
  const Outcome outcome = simulated(scene::buildScene(description, description.settings), 6.0);
  const double expected = sim::strainByWeight(outcome.simulation.model(), outcome.simulation.settings().step);
  EXPECT_GT(outcome.snapshot.maxStretch, 0.5 * expected);
  EXPECT_LT(outcome.snapshot.maxStretch, 2.0 * expected);
}

TEST(StretchCause, AStepAboveTheLimitOfTheSolverIsNamed) {
  const auto scene = testing::smallGrid(9, {"solver=xpbd", "iterations=1", "stiffness=1e5", "time_step=0.02"});
  const sim::ClothState pulled = thrownApart(*scene);
  const StretchDiagnosis found = diagnoseStretch(*scene, scene->settings, *scene->model, pulled, false);
  EXPECT_EQ(found.cause, StretchCause::TimeStep);
  EXPECT_NE(found.advice.text.english().find("The time step is too long for the solver xpbd"), std::string::npos);
  EXPECT_EQ(found.advice.value, "auto");
}

TEST(StretchCause, OnlyAFailedSolverIsCalledOverstretched) {
  const auto scene = testing::smallGrid(9, {"solver=auto", "stiffness=500"});
  const sim::ClothState pulled = thrownApart(*scene);
  const StretchDiagnosis failed = diagnoseStretch(*scene, scene->settings, *scene->model, pulled, false);
  EXPECT_EQ(failed.cause, StretchCause::Solver);
  EXPECT_TRUE(failed.advice.text.english().starts_with("Overstretched")) << failed.advice.text;
  const StretchDiagnosis attachment = diagnoseStretch(*scene, scene->settings, *scene->model, pulled, true);
  EXPECT_EQ(attachment.cause, StretchCause::Attachment);
  EXPECT_EQ(attachment.advice.text.english().find("Overstretched"), std::string::npos);
}

TEST(StretchCause, AdviceForAFabricDoesNotNameSprings) {
  for (const char* modulus : {"1", "1000"}) {
    const std::string is = std::string("=") + modulus;
    const auto scene = testing::smallGrid(9, {"solver=auto", "material.model=fabric", "fabric.stretch_warp" + is,
                                              "fabric.stretch_weft" + is, "stiffness=0.5", "damping=1"});
    const sim::ClothState pulled = thrownApart(*scene);
    const bool soft = is == "=1";
    for (const bool byMouse : {false, true}) {
      const StretchDiagnosis found = diagnoseStretch(*scene, scene->settings, *scene->model, pulled, byMouse);
      EXPECT_EQ(found.cause, soft ? StretchCause::Soft : byMouse ? StretchCause::Attachment : StretchCause::Solver);
      EXPECT_EQ(found.advice.text.english().find("spring"), std::string::npos) << found.advice.text;
      EXPECT_EQ(found.advice.text.english().find("stiffness"), std::string::npos) << found.advice.text;
      EXPECT_NE(found.advice.key, "stiffness");
      if (soft || byMouse) {
        EXPECT_NE(found.advice.text.english().find("stiffer fabric"), std::string::npos) << found.advice.text;
      }
    }
  }
}

TEST(StretchCause, APatternThatDoesNotFitIsNamed) {
  scene::SceneDescription description = scene::openScene("skirt");
  settings::assignSettingExpression(description.settings, "fabric.rest_shape=uv");
  const auto fitting = scene::buildScene(description, description.settings);
  const double scale = scene::patternScale(fitting->cloths.front().uvs, fitting->settings);
  const auto causeAt = [&](double factor) {
    settings::Settings settings = description.settings;
    settings.fabric.uvScale = factor * scale;
    const auto scene = scene::buildScene(description, settings);
    const sim::ClothState pulled = thrownApart(*scene);
    return diagnoseStretch(*scene, scene->settings, *scene->model, pulled, false);
  };
  const StretchDiagnosis found = causeAt(0.3);
  EXPECT_EQ(found.cause, StretchCause::Pattern);
  EXPECT_TRUE(found.advice.text.english().starts_with("The pattern does not fit: the mesh is strained"))
      << found.advice.text;
  EXPECT_EQ(found.advice.key, "fabric.rest_shape");
  EXPECT_EQ(found.advice.value, "mesh");
  EXPECT_EQ(causeAt(1.0).cause, StretchCause::Solver);
}

TEST(StretchCause, SliversAreNamedWithTheirPosition) {
  const auto grid = testing::smallGrid(9, {"solver=auto", "stiffness=500"});
  auto scene = std::make_shared<scene::Scene>(*grid);
  sim::ClothMesh mesh{grid->model->restPositions, grid->model->triangles};
  const Triangle first = mesh.triangles.front();
  const auto a = static_cast<std::size_t>(first[0]);
  const auto b = static_cast<std::size_t>(first[1]);
  mesh.positions[b] = mesh.positions[a] + (mesh.positions[b] - mesh.positions[a]) / 6000.0;
  scene->model = sim::buildClothModel(mesh, 0.1, sim::MassLumping::Area, {0, 8});
  sim::ClothState state = sim::stateAtRest(mesh.positions);
  state.positions[b] = mesh.positions[a] + 5.0 * (mesh.positions[b] - mesh.positions[a]);
  const StretchDiagnosis found = diagnoseStretch(*scene, scene->settings, *scene->model, state, false);
  EXPECT_EQ(found.cause, StretchCause::Slivers);
  EXPECT_NE(found.advice.text.english().find("1 edge is overstretched. The shortest is 1/6000"), std::string::npos)
      << found.advice.text;
  EXPECT_NE(found.advice.text.english().find("The first is at ("), std::string::npos) << found.advice.text;
}

TEST(StretchCause, AWrongUnitIsNamed) {
  const auto grid = testing::smallGrid(9, {"solver=auto", "grid.width=75", "grid.height=75", "stiffness=50"});
  auto scene = std::make_shared<scene::Scene>(*grid);
  scene->description.cloth().source = scene::MeshFileSource{"shirt.obj", false};
  scene->reading = scene::MeshReading{};
  scene->summary.size = {75.0, 0.0, 75.0};
  scene->model = sim::withMass(*grid->model, 0.15 * 75.0 * 75.0, sim::MassLumping::Area);
  const sim::ClothState pulled = thrownApart(*scene);
  const StretchDiagnosis found = diagnoseStretch(*scene, scene->settings, *scene->model, pulled, false);
  EXPECT_EQ(found.cause, StretchCause::Unit);
  EXPECT_NE(found.advice.text.english().find("probably in centimetres"), std::string::npos) << found.advice.text;
  EXPECT_EQ(found.advice.key + "=" + found.advice.value, "unit=cm");
}

TEST(StretchCause, PinsThatMoveApartAreNamed) {
  const auto scene = testing::smallGrid(9, {"solver=auto", "stiffness=500"});
  sim::ClothState apart = thrownApart(*scene);
  for (std::size_t v = 0; v < apart.positions.size(); ++v) {
    apart.positions[v] = 4.0 * scene->start.positions[v];
  }
  const StretchDiagnosis found = diagnoseStretch(*scene, scene->settings, *scene->model, apart, false);
  EXPECT_EQ(found.cause, StretchCause::Attachment);
  EXPECT_TRUE(found.advice.text.english().starts_with("Pins stretch the cloth: they are 4 times")) << found.advice.text;
}

TEST(StretchCause, StretchedClothThatHardlyMovesDoesNotBlameTheSolver) {
  const auto scene = testing::smallGrid(9, {"solver=auto", "stiffness=500"});
  sim::ClothState still = thrownApart(*scene);
  std::ranges::fill(still.velocities, Vec3::Zero());
  const StretchDiagnosis found = diagnoseStretch(*scene, scene->settings, *scene->model, still, false);
  EXPECT_EQ(found.cause, StretchCause::External);
  EXPECT_TRUE(found.advice.text.english().starts_with("Bodies or the weight stretch the cloth")) << found.advice.text;
}

TEST(StretchCause, PinsThatWereMovedAreNamed) {
  Simulation simulation(testing::smallGrid(9, {"solver=auto", "stiffness=200"}));
  testing::takeSteps(simulation, 30);
  simulation.apply(PlacePinsCommand{{0}, {simulation.state().positions[0] + Vec3(0.0, 0.5, 0.0)}});
  Snapshot snapshot;
  simulation.capture(snapshot);
  ASSERT_TRUE(snapshot.overstretched.has_value());
  EXPECT_EQ(snapshot.overstretched->cause, StretchCause::Attachment);
  EXPECT_TRUE(snapshot.message.english().starts_with("Pins pull at the cloth")) << snapshot.message;
}

}  // namespace
}  // namespace drape::session
