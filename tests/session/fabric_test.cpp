#include "sim/fabric/fabric.hpp"
#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drape::session {
namespace {

using testing::smallGrid;

void set(Simulation& simulation, const std::string& key, const settings::SettingValue& value) {
  simulation.apply(SetSettingCommand{key, value});
}

TEST(Fabric, isPartOfTheModelThatTheSceneBuilds) {
  EXPECT_EQ(smallGrid()->model->fabric, nullptr);
  const auto scene = smallGrid(9, {"material.model=fabric", "material.preset=denim"});
  ASSERT_NE(scene->model->fabric, nullptr);
  EXPECT_EQ(scene->model->fabric->materials[0], fabrics::findPreset("denim")->material);
  EXPECT_NEAR(scene->model->totalMass(), 0.1, 1e-12) << "the scene gives the mass";
  const auto own = smallGrid(9, {"material.model=fabric", "material.preset=denim", "fabric.own_density=on"});
  EXPECT_NEAR(own->model->totalMass(), 0.324, 1e-12) << "the sheet has one square metre";
}

TEST(Fabric, isChangedByItsSettingsWhileTheClothMoves) {
  Simulation simulation(smallGrid(9, {"solver=auto"}));
  set(simulation, "material.model", std::string("fabric"));
  ASSERT_NE(simulation.model().fabric, nullptr) << simulation.message();
  set(simulation, "material.preset", std::string("jersey"));
  EXPECT_EQ(simulation.model().fabric->materials[0].stretchWarp, 17.0);
  set(simulation, "fabric.stretch_warp", 18.0);
  EXPECT_EQ(simulation.model().fabric->materials[0].stretchWarp, 18.0);
  set(simulation, "fabric.own_density", true);
  EXPECT_NEAR(simulation.model().totalMass(), 0.187, 1e-12);
  set(simulation, "material.preset", std::string("silk"));
  EXPECT_NEAR(simulation.model().totalMass(), 0.083, 1e-12);
  set(simulation, "fabric.density", 0.2);
  EXPECT_NEAR(simulation.model().totalMass(), 0.2, 1e-12);
  set(simulation, "density", 0.3);
  EXPECT_NEAR(simulation.model().totalMass(), 0.3, 1e-12);
  EXPECT_EQ(simulation.model().fabric->materials[0].stretchWarp, 1030.0) << "another mass keeps the fabric";
}

TEST(Fabric, leavesNoTraceWhenTheClothIsSpringsAgain) {
  Simulation simulation(smallGrid(9, {"solver=auto"}));
  Simulation untouched(smallGrid(9, {"solver=auto"}));
  for (const char* model : {"fabric", "springs"}) {
    set(simulation, "material.model", std::string(model));
  }
  set(simulation, "material.preset", std::string("denim"));
  EXPECT_EQ(simulation.model().fabric, nullptr);
  EXPECT_TRUE(simulation.model().fabricStiffness.empty());
  EXPECT_EQ(simulation.model().unitFrequency, untouched.model().unitFrequency);
  EXPECT_EQ(simulation.model().vertexMass, untouched.model().vertexMass);
  for (int i = 0; i < 10; ++i) {
    simulation.step();
    untouched.step();
  }
  EXPECT_EQ(sim::stateHash(simulation.state()), sim::stateHash(untouched.state()));
}

TEST(Fabric, doesNotTouchTheModelOfSprings) {
  Simulation simulation(smallGrid(9, {"solver=auto"}));
  const sim::ClothModel* before = &simulation.model();
  set(simulation, "material.preset", std::string("denim"));
  set(simulation, "fabric.shear", 50.0);
  EXPECT_EQ(&simulation.model(), before);
}

TEST(Fabric, refusesABadValueWithAMessageAndKeepsTheOldOne) {
  Simulation simulation(smallGrid(9, {"solver=auto", "material.model=fabric"}));
  const sim::fabric::Material before = simulation.model().fabric->materials[0];
  for (const auto& [key, value] : {std::pair("fabric.shear", -1.0), std::pair("fabric.stretch_warp", std::nan("")),
                                   std::pair("fabric.bend_bias", 1e-9)}) {
    set(simulation, key, value);
    EXPECT_NE(simulation.message().english().find(key), std::string::npos) << simulation.message();
    EXPECT_EQ(simulation.model().fabric->materials[0], before) << key;
    EXPECT_EQ(simulation.settings().fabric.moduli, before) << key;
  }
}

TEST(Fabric, refusesAPatternWhereTheMeshHasNoneAndKeepsTheMesh) {
  Simulation simulation(smallGrid(9, {"solver=auto", "material.model=fabric"}));
  set(simulation, "fabric.rest_shape", std::string("uv"));
  EXPECT_NE(simulation.message().english().find("fabric.rest_shape = uv cannot be used"), std::string::npos)
      << simulation.message();
  EXPECT_EQ(simulation.settings().fabric.restShape, "mesh");
  EXPECT_FALSE(simulation.model().hasPattern);
}

/// The first side of the first triangle that runs along warp, as seen by the fabric [m].
double alongWarp(const sim::ClothModel& model) {
  const Triangle& triangle = model.triangles[0];
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = model.restPositions[triangle[(k + 1) % 3]] - model.restPositions[triangle[k]];
    const Vec2& own = model.fabric->shape.triangles[0].sides[k];
    if (std::abs(side.x()) > 1e-9 && std::abs(side.y()) < 1e-9 && std::abs(side.z()) < 1e-9) {
      length = std::abs(own.x()) / side.norm();
    }
  }
  return length;
}

TEST(Fabric, turnsWarpByTheAngleOfTheSettings) {
  // The grid is level, so warp starts along x.
  EXPECT_NEAR(alongWarp(*smallGrid(9, {"material.model=fabric"})->model), 1.0, 1e-12);
  EXPECT_NEAR(alongWarp(*smallGrid(9, {"material.model=fabric", "fabric.warp_angle=60"})->model), 0.5, 1e-12);
  EXPECT_NEAR(alongWarp(*smallGrid(9, {"material.model=fabric", "fabric.warp_angle=90"})->model), 0.0, 1e-12);
}

settings::OwnFabric fabricNamed(const char* name, const char* preset, double bend) {
  settings::Settings settings;
  settings::assignSettingExpression(settings, std::string("material.preset=") + preset);
  settings::OwnFabric fabric = settings::fabricOf(settings, name);
  fabric.material.bendWarp = fabric.material.bendWeft = fabric.material.bendBias = bend;
  return fabric;
}

TEST(Fabric, changesAllValuesTogetherWhereOneByOneWouldBeRefused) {
  Simulation simulation(smallGrid(9, {"solver=auto", "material.model=fabric", "material.preset=silk"}));
  const settings::OwnFabric stiff = fabricNamed("stiff", "denim", 1e-3);
  set(simulation, "fabric.bend_warp", stiff.material.bendWarp);
  EXPECT_FALSE(simulation.message().empty()) << "the first of the values alone is unstable";
  simulation.apply(SetOwnFabricsCommand{settings::withOwnFabric({}, stiff)});
  simulation.apply(UseFabricCommand{stiff});
  EXPECT_TRUE(simulation.message().empty()) << simulation.message();
  EXPECT_EQ(simulation.model().fabric->materials[0], stiff.material);
  EXPECT_EQ(settings::fabricTitle(simulation.settings()), "stiff");
  set(simulation, "material.preset", std::string("silk"));
  set(simulation, "material.preset", std::string("stiff"));
  EXPECT_EQ(simulation.model().fabric->materials[0], stiff.material);
}

TEST(Fabric, refusesAnOwnFabricOutOfRangeAndKeepsTheOldOne) {
  Simulation simulation(smallGrid(9, {"solver=auto", "material.model=fabric"}));
  const sim::fabric::Material before = simulation.model().fabric->materials[0];
  simulation.apply(UseFabricCommand{fabricNamed("bad", "denim", -1.0)});
  EXPECT_NE(simulation.message().english().find("fabric.bend_warp must be"), std::string::npos) << simulation.message();
  EXPECT_EQ(simulation.model().fabric->materials[0], before);
  EXPECT_EQ(settings::fabricTitle(simulation.settings()), "Cotton");
}

TEST(Fabric, refusesWarpFromTextureThatTheClothLacks) {
  Simulation simulation(smallGrid(9, {"solver=auto", "material.model=fabric"}));
  set(simulation, "fabric.warp_from", std::string("uv"));
  EXPECT_NE(simulation.message().english().find("no texture coordinates"), std::string::npos) << simulation.message();
  EXPECT_EQ(simulation.settings().fabric.warpFrom, "auto");
}

TEST(Fabric, causesAdviceToSoftenItWhenItBlowsUp) {
  Simulation simulation(smallGrid(9, {"solver=verlet", "time_step=0.02", "material.model=fabric",
                                      "fabric.stretch_warp=1e6", "fabric.stretch_weft=1e6"}));
  for (int i = 0; i < 500 && !simulation.blewUp(); ++i) {
    simulation.step();
  }
  EXPECT_NE(simulation.message().english().find("a smaller time step or a softer fabric"), std::string::npos)
      << simulation.message();
}

TEST(Fabric, isRefusedWithASolverThatTakesSpringsOnly) {
  Simulation simulation(smallGrid(9, {"solver=kang"}));
  set(simulation, "material.model", std::string("fabric"));
  EXPECT_EQ(simulation.model().fabric, nullptr);
  EXPECT_NE(simulation.message().english().find("solver = kang knows springs only"), std::string::npos)
      << simulation.message();
  set(simulation, "solver", std::string("verlet"));
  set(simulation, "material.model", std::string("fabric"));
  EXPECT_NE(simulation.model().fabric, nullptr) << simulation.message();
  set(simulation, "ghost.solver", std::string("kang"));
  EXPECT_EQ(simulation.settings().ghost.solver, "off");
  EXPECT_THROW(Simulation(smallGrid(9, {"solver=kang", "material.model=fabric"})), messages::InputError);
}

}  // namespace
}  // namespace drape::session
