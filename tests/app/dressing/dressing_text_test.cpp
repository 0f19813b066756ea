#include "app/dressing/dressing_text.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace drape::app {
namespace {

using dressing::BodyPart;
using dressing::Fault;
using dressing::FaultKind;
using dressing::Piercing;

scene::Scene sceneWithBall() {
  sim::contact::Body ball;
  ball.name = "ball";
  scene::Scene scene;
  scene.bodies = std::make_shared<const std::vector<sim::contact::Body>>(2, ball);
  return scene;
}

TEST(PiercingText, namesThePartOfAPerson) {
  const Piercing piercing{0, 35, {{FaultKind::PassesWall, BodyPart::RightArm, true, 35}}, Vec3::Zero()};
  EXPECT_EQ(inWords(piercing, sceneWithBall()),
            "The right arm passes through the sleeve's wall: 35 pairs of triangles");
}

TEST(PiercingText, listsSeveralParts) {
  const Piercing piercing{
      0,
      36,
      {{FaultKind::PassesWall, BodyPart::LeftArm, true, 35}, {FaultKind::PassesWall, BodyPart::Trunk, false, 1}},
      Vec3::Zero()};
  EXPECT_EQ(inWords(piercing, sceneWithBall()),
            "The left arm passes through the sleeve's wall (35 pairs of triangles), the trunk passes through the "
            "garment (1 pair of triangles)");
}

TEST(PiercingText, namesTheTwoPartsWithTheMostPairsAndCountsTheOthers) {
  const Piercing piercing{0,
                          43,
                          {{FaultKind::PassesWall, BodyPart::Trunk, false, 20},
                           {FaultKind::PassesWall, BodyPart::Head, false, 15},
                           {FaultKind::PassesWall, BodyPart::LeftLeg, false, 5},
                           {FaultKind::PassesWall, BodyPart::RightLeg, false, 3}},
                          Vec3::Zero()};
  EXPECT_EQ(inWords(piercing, sceneWithBall()),
            "The trunk passes through the garment (20 pairs of triangles), the head passes through the garment (15 "
            "pairs of triangles), and so do 2 other parts");
  Piercing less = piercing;
  less.faults.pop_back();
  EXPECT_TRUE(inWords(less, sceneWithBall()).english().ends_with(", and so does 1 other part"));
}

TEST(PiercingText, saysWhereABodyWithoutPartsIs) {
  const Piercing piercing{1, 12, {{FaultKind::PassesWall, BodyPart::Whole, false, 12}}, Vec3(0.1, 1.25, -0.2)};
  EXPECT_EQ(inWords(piercing, sceneWithBall()),
            "The body 'ball' passes through the cloth near (0.10, 1.25, -0.20) m: 12 pairs of triangles");
}

TEST(PiercingText, countsOtherBodies) {
  const Piercing piercing{0, 35, {{FaultKind::PassesWall, BodyPart::RightArm, true, 35}}, Vec3::Zero()};
  EXPECT_EQ(inWords(std::vector<Piercing>{piercing, piercing}, sceneWithBall()),
            "The right arm passes through the sleeve's wall: 35 pairs of triangles; 1 other body passes through the "
            "cloth too");
}

TEST(DressingText, saysThatAGarmentIsInsideTheBody) {
  dressing::Dressed result;
  result.fits = false;
  result.openings = 3;
  result.faults = {{.kind = FaultKind::InsideBody}};
  EXPECT_EQ(
      refusalOf(result, text::Sentence::verbatim("shorts.obj")),
      "The body cannot wear shorts.obj: even where the body is a thin line, the garment is inside the body. It is "
      "too small for this body; is the unit of both files right?");
}

TEST(DressingText, saysThatAGarmentIsTooTight) {
  dressing::Dressed result;
  result.stretch = 0.1;
  EXPECT_EQ(summaryOf(result), "placed as in its file; no triangles intersected there, and no triangles at the end");
  result.stretch = 1.4;
  EXPECT_EQ(
      summaryOf(result),
      "placed as in its file; no triangles intersected there, and no triangles at the end; where it is tightest the "
      "garment is stretched by 140 %, so it is too small or its unit is another one");
}

}  // namespace
}  // namespace drape::app
