// Placements of cloths and bodies: their mathematics, their place in scene files, and what they leave as it is.
#include "messages/error.hpp"
#include "scene/placements.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"
#include "sim/model/bounds.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

namespace drape::scene {
namespace {

constexpr const char* placedBody = R"(
[cloth]
grid = "horizontal"
position = [0, 1, 0]
[[bodies]]
name = "ball"
)";

SceneDescription placedScene(const std::string& text) {
  return parseScene(text, "placed", "placed.toml", std::filesystem::current_path());
}

std::shared_ptr<const Scene> placedBuild(const SceneDescription& description) {
  return buildScene(description, description.settings);
}

std::string placedRefusal(const std::string& text) {
  try {
    static_cast<void>(placedScene(text));
    return "";
  } catch (const messages::InputError& error) {
    return error.what();
  }
}

constexpr double ninety = 0.5 * std::numbers::pi;

TEST(Placement, ScalesTurnsAndThenMoves) {
  const Placement placement{Vec3(1, 0, 0), Vec3(0, 90, 0), 2.0};
  EXPECT_TRUE(placement.applied(Vec3(0.0, 1.0, 1.0)).isApprox(Vec3(3.0, 2.0, 0.0), 1e-12));
  EXPECT_TRUE(placement.applied(std::vector<Vec3>{Vec3(0.0, 1.0, 1.0)})[0].isApprox(Vec3(3.0, 2.0, 0.0), 1e-12));
  EXPECT_FALSE(placement.isNone());
  EXPECT_TRUE(Placement().isNone());
}

TEST(Placement, TurnsAndScalesAboutAPointThatStays) {
  const Vec3 point(0.3, 1.2, -0.4);
  const Placement start{Vec3(0.25, 0, 0), Vec3(0, 30, 0), 1.0};
  const Vec3 place = start.applied(point);
  const Placement turned = turnedAbout(start, point, Eigen::Quaterniond(Eigen::AngleAxisd(ninety, Vec3::UnitY())));
  EXPECT_LT((turned.applied(point) - place).norm(), 2e-6) << "positions have six decimal places";
  EXPECT_TRUE(turned.rotation.isApprox(Vec3(0, 120, 0), 1e-9)) << turned.rotation.transpose();
  const Placement scaled = scaledAbout(turned, point, 1.5);
  EXPECT_LT((scaled.applied(point) - place).norm(), 2e-6);
  EXPECT_EQ(scaled.scale, 1.5);
  EXPECT_EQ(scaledAbout(start, point, 1e6).scale, maxPlacementScale);
  EXPECT_EQ(movedTo(start, point, place), start);
}

TEST(Placement, IsReadForClothsAndBodies) {
  const SceneDescription scene = placedScene(R"(
[cloth]
grid = "horizontal"
placement = { position = [1, 2, 3], rotation = [0, 45, 0], scale = 1.25 }
[[bodies]]
name = "ball"
shape = "sphere"
placement = { scale = 0.5 }
)");
  EXPECT_EQ(scene.cloth().placement, (Placement{Vec3(1, 2, 3), Vec3(0, 45, 0), 1.25}));
  EXPECT_EQ(scene.bodies.front().placement, (Placement{Vec3::Zero(), Vec3::Zero(), 0.5}));
  EXPECT_EQ(placementsOf(scene), writtenPlacementsOf(scene));
}

TEST(Placement, IsRefusedWithFileLineAndRange) {
  const std::string tooLarge = placedRefusal(
      "[cloth]\ngrid = \"horizontal\"\n"
      "placement = { scale = 200 }\n");
  EXPECT_NE(tooLarge.find("placed.toml:3"), std::string::npos) << tooLarge;
  EXPECT_NE(tooLarge.find("100"), std::string::npos) << tooLarge;
  const std::string unknown = placedRefusal("[cloth]\ngrid = \"horizontal\"\nplacement = { size = 2 }\n");
  EXPECT_NE(unknown.find("size"), std::string::npos) << unknown;
  const std::string figure =
      placedRefusal(std::string(placedBody) + "shape = \"figure\"\nplacement = { scale = 1.1 }\n");
  EXPECT_NE(figure.find("height"), std::string::npos) << figure;
}

TEST(Placement, MovesTheStartOfAClothAndKeepsItsRestShape) {
  SceneDescription description = openScene("skirt");
  const auto before = placedBuild(description);
  description.cloth().placement = {Vec3(0.5, 0.25, 0), Vec3(0, 0, 90), 1.0};
  const auto after = placedBuild(description);
  const Placement& placement = description.cloth().placement;
  for (std::size_t v = 0; v < before->start.positions.size(); ++v) {
    ASSERT_TRUE(after->start.positions[v].isApprox(placement.applied(before->start.positions[v]), 1e-12));
  }
  EXPECT_EQ(after->model->pinned, before->model->pinned);
  EXPECT_EQ(after->model->restPositions, before->model->restPositions) << "so warp stays where it is in the cloth";
  EXPECT_EQ(after->model->vertexMass, before->model->vertexMass);
  EXPECT_EQ(after->groundHeight, before->groundHeight);
}

TEST(Placement, ScalesTheRestShapeOfACloth) {
  SceneDescription description = openScene("skirt");
  description.settings.material.massGivenAs = "density";
  const auto before = placedBuild(description);
  description.cloth().placement.scale = 2.0;
  const auto after = placedBuild(description);
  ASSERT_EQ(after->model->springs.size(), before->model->springs.size());
  for (std::size_t s = 0; s < before->model->springs.size(); ++s) {
    ASSERT_NEAR(after->model->springs[s].restLength, 2.0 * before->model->springs[s].restLength, 1e-12);
  }
  double mass = 0.0;
  double massBefore = 0.0;
  for (std::size_t v = 0; v < before->model->vertexMass.size(); ++v) {
    mass += after->model->vertexMass[v];
    massBefore += before->model->vertexMass[v];
  }
  EXPECT_NEAR(mass, 4.0 * massBefore, 1e-9) << "the density stays";
  EXPECT_NEAR(after->summary.size[1], 2.0 * before->summary.size[1], 1e-12);
}

TEST(Placement, KeepsPinsBandsAndSeamsOnTheirVertices) {
  const std::string keys =
      "[cloth]\nmesh = \"builtin:fitted_skirt.obj\"\nbands = [{ nearest = [0, 1.05, 0], length = 0.8 }]\n";
  const std::string pins =
      "[pins]\nnearest = [[0.2, 0.5, 0.1]]\ntop = 0.05\nboxes = [{ min = [-1, 0.9, 0], max = [1, 2, 1] }]\n";
  const std::string placement = "placement = { position = [3, -1, 2], rotation = [120, 0, 40], scale = 0.4 }\n";
  const auto before = placedBuild(placedScene(keys + pins));
  const auto after = placedBuild(placedScene(keys + placement + pins));
  EXPECT_EQ(after->model->pinned, before->model->pinned);
  EXPECT_GT(before->cloths.front().bands.front().vertices.size(), 10U);
  EXPECT_EQ(after->cloths.front().bands.front().vertices, before->cloths.front().bands.front().vertices);

  SceneDescription sewing = openScene("sewing");
  const auto flat = placedBuild(sewing);
  sewing.cloths[0].placement = {Vec3(0, 0.5, 1), Vec3(0, 170, 0), 1.0};
  const auto moved = placedBuild(sewing);
  ASSERT_EQ(moved->seams->size(), flat->seams->size());
  for (std::size_t s = 0; s < flat->seams->size(); ++s) {
    ASSERT_EQ((*moved->seams)[s].pairs.size(), (*flat->seams)[s].pairs.size());
    for (std::size_t p = 0; p < (*flat->seams)[s].pairs.size(); ++p) {
      EXPECT_EQ((*moved->seams)[s].pairs[p].a, (*flat->seams)[s].pairs[p].a);
      EXPECT_EQ((*moved->seams)[s].pairs[p].b, (*flat->seams)[s].pairs[p].b);
    }
  }
}

TEST(Placement, KeepsTheFileAsTheFrameOfExports) {
  SceneDescription description = openScene("skirt");
  description.cloth().placement = {Vec3(3, -1, 2), Vec3(120, 0, 40), 0.4};
  const auto scene = placedBuild(description);
  const ClothPart& cloth = scene->cloths.front();
  const auto before = placedBuild(openScene("skirt"));
  for (std::size_t v = 0; v < scene->start.positions.size(); v += 17) {
    const Vec3 inFile = cloth.placement.toFile(scene->start.positions[v]);
    EXPECT_LT((inFile - before->cloths.front().placement.toFile(before->start.positions[v])).norm(), 1e-12);
    EXPECT_LT((cloth.placement.toScene(inFile) - scene->start.positions[v]).norm(), 1e-12);
  }
}

TEST(Placement, MovesTheWholeMotionOfABody) {
  const std::string motion =
      "shape = \"sphere\"\nradius = 0.25\n"
      "keyframes = [{ time = 0, position = [1, 0, 0] }, { time = 2, position = [3, 1, 0], rotation = [0, 90, 0] }]\n";
  const auto before = placedBuild(placedScene(placedBody + motion));
  const auto after = placedBuild(
      placedScene(placedBody + motion + "placement = { position = [0, 5, 0], rotation = [0, 90, 0], scale = 2 }\n"));
  EXPECT_EQ(std::get<sim::contact::SphereShape>(after->bodies->front().shape).radius, 0.5);
  const Placement& placement = after->description.bodies.front().placement;
  for (const double time : {0.0, 0.7, 1.3, 2.0}) {
    const sim::contact::Pose own = sim::contact::poseAt(before->bodies->front().motion, time);
    const sim::contact::Pose placed = sim::contact::poseAt(after->bodies->front().motion, time);
    EXPECT_TRUE(placed.position.isApprox(placement.applied(own.position), 1e-12)) << time;
    EXPECT_LT(placed.rotation.angularDistance(placement.pose().rotation * own.rotation), 1e-7) << time;
  }
}

TEST(Placement, IsSavedToTheSameBits) {
  SceneDescription description = openScene("table_runner");
  description.cloths[1].placement = {Vec3(0.1, 0.25, -1.0 / 3.0), Vec3(1.0 / 3.0, 20, 0.7), 1.1};
  description.bodies[0].placement = {Vec3(0.3, 0, 0), Vec3(0, 17.3, 0), 0.9};
  const auto scene = placedBuild(description);
  const std::string text = writeScene(*scene, unchanged(*scene), std::filesystem::current_path()).text;
  const auto again = placedBuild(placedScene(text));
  EXPECT_EQ(placementsOf(again->description), placementsOf(description)) << text;
  EXPECT_EQ(again->start.positions, scene->start.positions);
  EXPECT_EQ(again->groundHeight, scene->groundHeight);
  const auto& one = (*scene->bodies)[0];
  const auto& other = (*again->bodies)[0];
  EXPECT_EQ(sim::contact::poseAt(other.motion, 0.0).position, sim::contact::poseAt(one.motion, 0.0).position);
  EXPECT_EQ(sim::contact::poseAt(other.motion, 0.0).rotation.coeffs(),
            sim::contact::poseAt(one.motion, 0.0).rotation.coeffs());
  EXPECT_EQ(sim::contact::surfaceOf(other.shape).positions, sim::contact::surfaceOf(one.shape).positions);
}

TEST(Placement, IsSavedWithTheShiftOfAMovedBody) {
  SceneDescription description = openScene("sphere");
  description.bodies[0].placement = {Vec3(0.5, 0, 0), Vec3(0, 90, 0), 2.0};
  const auto scene = placedBuild(description);
  SceneNow now = unchanged(*scene);
  for (const sim::contact::Body& body : *scene->bodies) {
    now.bodies.push_back({true, Vec3::Zero(), body.surface});
  }
  now.bodies[0].shift = Vec3(0, 0, 0.25);
  const auto again = placedBuild(placedScene(writeScene(*scene, now, std::filesystem::current_path()).text));
  const Vec3 place = sim::contact::poseAt((*scene->bodies)[0].motion, 0.0).position + now.bodies[0].shift;
  EXPECT_TRUE(sim::contact::poseAt((*again->bodies)[0].motion, 0.0).position.isApprox(place, 1e-12));
}

TEST(Placement, DoesNotMoveAnAutomaticGround) {
  SceneDescription description = placedScene("[cloth]\ngrid = \"vertical\"\nposition = [0, -1, 0]\n");
  const auto before = placedBuild(description);
  ASSERT_LT(before->groundHeight, -1.0) << "it is below the cloth";
  description.cloth().placement.position = Vec3(0, -3, 0);
  const auto after = placedBuild(description);
  EXPECT_EQ(after->groundHeight, before->groundHeight);
  const std::string text = writeScene(*after, unchanged(*after), std::filesystem::current_path()).text;
  EXPECT_EQ(placedBuild(placedScene(text))->groundHeight, before->groundHeight);
}

TEST(Placements, FitTheSceneOrAreRefused) {
  const SceneDescription scene = openScene("table_runner");
  Placements placements = placementsOf(scene);
  ASSERT_EQ(placements.cloths.size(), 2U);
  placements.of({Placeable::Kind::Cloth, 1}).position = Vec3(1, 0, 0);
  const SceneDescription placed = withPlacements(scene, placements);
  EXPECT_EQ(placed.cloths[1].placement.position, Vec3(1, 0, 0));
  EXPECT_TRUE(placed.cloths[1].writtenPlacement.isNone());
  EXPECT_EQ(nameOf(scene, {Placeable::Kind::Cloth, 1}), "runner");
  EXPECT_EQ(nameOf(openScene("grid"), {}), "cloth");
  EXPECT_EQ(placeablesOf(scene).size(), 3U);
  Placements tooFar = placements;
  tooFar.bodies[0].position = Vec3(0, 1e5, 0);
  EXPECT_THROW(static_cast<void>(withPlacements(scene, tooFar)), messages::InputError);
  placements.bodies.clear();
  EXPECT_THROW(static_cast<void>(withPlacements(scene, placements)), messages::InputError);
}

TEST(Placements, CannotScaleAFigure) {
  const SceneDescription dance = openScene("dance");
  EXPECT_NE(whyNotScaled(dance, {Placeable::Kind::Body, 0}).find("measures"), std::string::npos);
  EXPECT_EQ(whyNotScaled(dance, {}), "");
  EXPECT_EQ(whyNotScaled(openScene("sphere"), {Placeable::Kind::Body, 0}), "");
}

}  // namespace
}  // namespace drape::scene
