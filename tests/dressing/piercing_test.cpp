#include "dressing/piercing.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace drape::dressing::testing {
namespace {

sim::contact::Body bodyOf(const std::string& name, const sim::ClothMesh& mesh) {
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->positions = mesh.positions;
  shape->triangles = mesh.triangles;
  sim::contact::Body body;
  body.name = name;
  body.shape = std::shared_ptr<const sim::contact::MeshShape>(shape);
  body.motion.keyframes = {sim::contact::Keyframe{}};
  return body;
}

/// A scene of a garment, the ground, and bodies.
std::shared_ptr<const scene::Scene> sceneOf(const sim::ClothMesh& garment, std::vector<sim::contact::Body> bodies) {
  auto scene = std::make_shared<scene::Scene>();
  scene->model = modelOf(garment);
  scene->start.positions = garment.positions;
  bodies.insert(bodies.begin(), scene::groundBody());
  scene->bodies = std::make_shared<const std::vector<sim::contact::Body>>(std::move(bodies));
  return scene;
}

std::vector<Piercing> atStart(const std::shared_ptr<const scene::Scene>& scene) {
  return PiercingSearch(scene).find(scene->start.positions, bodiesAtStart(*scene));
}

TEST(Piercing, isAbsentWhereTheGarmentIsWorn) {
  EXPECT_TRUE(atStart(sceneOf(tshirt(), {bodyOf("mannequin", mannequin())})).empty());
}

TEST(Piercing, namesTheArmThatPassesThroughTheWallOfASleeve) {
  // Lower than it is worn: the arms pass through the upper side of the sleeves.
  const auto found = atStart(sceneOf(shifted(tshirt(), {0.0, -0.03, 0.0}), {bodyOf("mannequin", mannequin())}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().body, 1U);
  std::size_t pairs = 0;
  for (const Fault& fault : found.front().faults) {
    pairs += fault.pairs;
  }
  EXPECT_EQ(pairs, found.front().pairs);
  for (const BodyPart arm : {BodyPart::LeftArm, BodyPart::RightArm}) {
    EXPECT_EQ(std::ranges::count(found.front().faults, arm, &Fault::part), 1);
    EXPECT_TRUE(std::ranges::any_of(found.front().faults,
                                    [&](const Fault& fault) { return fault.part == arm && fault.atSleeve; }));
  }
}

TEST(Piercing, knowsNoPartsOfABodyThatIsNoPersonAndSaysWhereItIs) {
  const sim::ClothMesh ball = shifted(ellipsoid({0.05, 0.05, 0.05}), {0.19, 0.1, 0.0});
  const auto found = atStart(sceneOf(tube(0.19, 0.4), {bodyOf("ball", ball)}));
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found.front().faults.size(), 1U);
  EXPECT_EQ(found.front().faults.front().part, BodyPart::Whole);
  EXPECT_EQ(found.front().faults.front().pairs, found.front().pairs);
  EXPECT_LT((found.front().centre - Vec3(0.19, 0.1, 0.0)).norm(), 0.05);
}

TEST(Piercing, putsTheBodyWithTheMostPairsFirstAndTakesOpenOnes) {
  sim::ClothMesh open = shifted(ellipsoid({0.02, 0.02, 0.02}), {-0.19, 0.0, 0.0});
  open.triangles.pop_back();
  const sim::ClothMesh wide = ellipsoid({0.2, 0.5, 0.2});
  const auto found = atStart(sceneOf(tube(0.19, 0.4), {bodyOf("open", open), bodyOf("wide", wide)}));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].body, 2U);
  EXPECT_EQ(found[1].body, 1U);
  EXPECT_GT(found[0].pairs, found[1].pairs);
  EXPECT_EQ(found[1].faults.front().part, BodyPart::Whole);
}

TEST(Piercing, followsABodyThatMoved) {
  const auto scene = sceneOf(tube(0.19, 0.4), {bodyOf("ball", ellipsoid({0.05, 0.05, 0.05}))});
  PiercingSearch search(scene);
  EXPECT_TRUE(search.find(scene->start.positions, bodiesAtStart(*scene)).empty());
  sim::contact::Pose pose;
  pose.position = Vec3(0.19, 0.0, 0.0);
  const std::vector<PlacedBody> moved{{1, placedBody((*scene->bodies)[1], pose)}};
  EXPECT_EQ(search.find(scene->start.positions, moved).size(), 1U);
}

}  // namespace
}  // namespace drape::dressing::testing
