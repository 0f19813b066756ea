#include "fabrics/presets.hpp"
#include "intersection/intersections.hpp"
#include "scene/scene_file.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace drape::session {
namespace {

/// A taut sheet, and a smaller one above it. @param gap between them at the start [m]
Simulation twoSheets(double gap, const std::string& settings) {
  const std::string text =
      "[[cloths]]\nname = \"taut\"\ngrid = \"horizontal\"\n"
      "pins = { edges = [\"left\", \"right\", \"top\", \"bottom\"] }\n"
      "[[cloths]]\nname = \"loose\"\ngrid = \"horizontal\"\nposition = [0.01, " +
      std::to_string(gap) +
      ", 0.02]\nrotation = [0, 10, 0]\n"
      "[cloths.settings]\ngrid.width = 0.4\ngrid.height = 0.4\ngrid.resolution = 9\nmaterial.preset = \"denim\"\n"
      "[settings]\ngrid.resolution = 15\ndamping = 0.003\n" +
      settings;
  const scene::SceneDescription description = scene::parseScene(text, "sheets", "sheets.toml", {});
  return Simulation(scene::buildScene(description, description.settings));
}

const scene::ClothPart& loose(const Simulation& simulation) {
  return simulation.scene().cloths[1];
}

constexpr int side = 15;  // vertices of the taut sheet

/// The height of the taut sheet at a point, by its triangles at rest: they hardly move sideways [m].
double heightOfTaut(const std::vector<Vec3>& positions, const Vec3& point) {
  const double u = (point.x() + 0.5) * (side - 1);
  const double v = (point.z() + 0.5) * (side - 1);
  const int column = std::min(side - 2, static_cast<int>(u));
  const int row = std::min(side - 2, static_cast<int>(v));
  const auto y = [&](int r, int c) { return positions[(row + r) * side + column + c].y(); };
  const double a = u - column;
  const double b = v - row;
  return a > b ? y(0, 0) + a * (y(0, 1) - y(0, 0)) + b * (y(1, 1) - y(0, 1))
               : y(0, 0) + b * (y(1, 0) - y(0, 0)) + a * (y(1, 1) - y(1, 0));
}

/// The least height of the loose sheet above the taut one [m].
double heightAbove(const Simulation& simulation) {
  const std::vector<Vec3>& positions = simulation.state().positions;
  double min = 1.0;
  for (int v = loose(simulation).firstVertex; v < static_cast<int>(positions.size()); ++v) {
    min = std::min(min, positions[v].y() - heightOfTaut(positions, positions[v]));
  }
  return min;
}

std::size_t intersectingPairs(const Simulation& simulation) {
  return intersection::intersectingPairs({simulation.state().positions, simulation.model().triangles}).size();
}

TEST(SeveralCloths, MeetEachOtherWithEveryKindOfSelfCollision) {
  for (const std::string method : {"exact", "hash"}) {
    Simulation simulation =
        twoSheets(0.03, "stiffness = 100\nself_collision = \"" + method + "\"\nsolver = \"auto\"\n");
    std::size_t pairs = 0;
    for (int step = 0; step < 90; ++step) {
      simulation.step();
      pairs += method == "exact" ? intersectingPairs(simulation) : 0;
    }
    EXPECT_EQ(pairs, 0U);
    EXPECT_GT(heightAbove(simulation), 0.0) << method;
    EXPECT_LT(heightAbove(simulation), 0.06) << method << ": it lies on the taut sheet, and the hash keeps 0.05 m";
  }
}

TEST(SeveralCloths, KeepTheThicknessAlsoIfTheyStartCloser) {
  Simulation simulation = twoSheets(0.001, "stiffness = 100\nself_collision = \"exact\"\ncloth_thickness = 0.006\n");
  for (int step = 0; step < 60; ++step) {
    simulation.step();
  }
  EXPECT_EQ(intersectingPairs(simulation), 0U);
  EXPECT_GT(heightAbove(simulation), 0.0045);
}

double massOfLoose(const Simulation& simulation) {
  const auto first = simulation.model().vertexMass.begin() + loose(simulation).firstVertex;
  return std::accumulate(first, first + loose(simulation).vertexCount, 0.0);
}

TEST(SeveralCloths, KeepTheirOwnFabricWhenThatOfTheSceneChanges) {
  Simulation simulation = twoSheets(0.1, "material.model = \"fabric\"\nmaterial.preset = \"silk\"\n");
  const auto trianglesOf = static_cast<std::size_t>(loose(simulation).firstTriangle);
  simulation.apply(SetSettingCommand{"material.preset", std::string("linen")});
  EXPECT_EQ(simulation.model().fabric->materials[0], fabrics::findPreset("linen")->material);
  EXPECT_EQ(simulation.model().fabric->materials[trianglesOf], fabrics::findPreset("denim")->material);
  EXPECT_NEAR(massOfLoose(simulation), 0.16 * fabrics::findPreset("denim")->density, 1e-12);
  simulation.apply(SetSettingCommand{"density", 0.5});
  EXPECT_NEAR(massOfLoose(simulation), 0.16 * 0.5, 1e-12) << "it has no density of its own";
  EXPECT_NEAR(simulation.model().totalMass(), (1.0 + 0.16) * 0.5, 1e-12);
}

TEST(SeveralCloths, TakeTheSameStepsAfterAReset) {
  Simulation simulation = twoSheets(0.03, "stiffness = 100\nself_collision = \"exact\"\n");
  const auto endOf = [&] {
    for (int step = 0; step < 30; ++step) {
      simulation.step();
    }
    return simulation.state().positions;
  };
  const std::vector<Vec3> first = endOf();
  simulation.apply(ResetCommand{});
  EXPECT_EQ(endOf(), first);
}

}  // namespace
}  // namespace drape::session
