#include "dressing/placement.hpp"
#include "../scene/garment_shapes.hpp"
#include "shapes.hpp"
#include "sim/model/bounds.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <functional>
#include <numbers>

namespace drape::dressing::testing {
namespace {

const std::function<void(double)> noProgress = [](double) {};

/// The number of faults of a garment around the centre lines.
std::size_t faultsOf(const sim::ClothMesh& garment, const ShrinkingBody& body) {
  const BodyParts parts(body);
  const GarmentOpenings openings(garment);
  return Wearing(body, parts, openings, garment.triangles)
      .faults(garment.positions, body.centreLines(), body.frames().front())
      .size();
}

TEST(Placement, leavesAGarmentThatIsAroundTheBody) {
  const ShrinkingBody body(mannequin());
  const Placement placement = place(tshirt(), body, BodyParts(body), PlacementRule::Auto, noProgress);
  EXPECT_EQ(placement.rule, PlacementRule::File);
  EXPECT_TRUE(placement.pose.position.isZero(0.0));
}

/// Turned about the vertical, far from the body. @param quarters turns of 90 degrees
sim::contact::Pose farAway(double quarters) {
  sim::contact::Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.5 * std::numbers::pi * quarters, Vec3::UnitY());
  pose.position = Vec3(1.3, -0.7, 2.0);
  return pose;
}

TEST(Placement, bringsATurnedTshirtFromFarAwayOntoTheBody) {
  const ShrinkingBody body(mannequin());
  for (const double quarters : {0.0, 1.0, 2.0, 3.0}) {
    sim::ClothMesh shirt = tshirt();
    shirt.positions = moved(shirt.positions, farAway(quarters));
    const Placement placement = place(shirt, body, BodyParts(body), PlacementRule::Auto, noProgress);
    EXPECT_EQ(placement.rule, PlacementRule::Landmarks);
    shirt.positions = moved(shirt.positions, placement.pose);
    EXPECT_EQ(faultsOf(shirt, body), 0U) << quarters;
    for (std::size_t v = 0; v < shirt.positions.size(); ++v) {
      ASSERT_LT((shirt.positions[v] - tshirt().positions[v]).norm(), 0.12) << quarters;
    }
  }
}

/// The T-shirt without its right shoulder: what is above a height on that side is cut off.
sim::ClothMesh topForOneShoulder(double height) {
  const sim::ClothMesh& whole = tshirt();
  sim::ClothMesh top;
  std::vector<int> numbers(whole.positions.size(), -1);
  for (const Triangle& t : whole.triangles) {
    const Vec3 centre = (whole.positions[t[0]] + whole.positions[t[1]] + whole.positions[t[2]]) / 3.0;
    if (centre.x() < 0.02 && centre.y() > height) {
      continue;
    }
    Triangle& kept = top.triangles.emplace_back();
    for (std::size_t k = 0; k < t.size(); ++k) {
      int& number = numbers[t[k]];
      if (number < 0) {
        number = static_cast<int>(top.positions.size());
        top.positions.push_back(whole.positions[t[k]]);
      }
      kept[k] = number;
    }
  }
  return top;
}

TEST(Placement, putsATopForOneShoulderThereAndNotAroundTheWaist) {
  const ShrinkingBody body(mannequin());
  for (const double height : {1.2, 1.3}) {  // without the right sleeve, or with a half of it
    const sim::ClothMesh where = topForOneShoulder(height);
    sim::ClothMesh top = where;
    top.positions = moved(top.positions, farAway(0.0));
    const Placement placement = place(top, body, BodyParts(body), PlacementRule::Auto, noProgress);
    top.positions = moved(top.positions, placement.pose);
    EXPECT_EQ(faultsOf(top, body), 0U) << height;
    for (std::size_t v = 0; v < top.positions.size(); ++v) {
      ASSERT_LT((top.positions[v] - where.positions[v]).norm(), 0.12) << height;
    }
  }
}

TEST(Placement, putsBothLegsIntoTheirTrouserLegs) {
  const ShrinkingBody body(figure());
  for (const double quarters : {0.0, 1.0}) {
    sim::ClothMesh trousers = scene::testing::trousers(0.75);
    trousers.positions = moved(trousers.positions, farAway(quarters));
    const Placement placement = place(trousers, body, BodyParts(body), PlacementRule::Auto, noProgress);
    EXPECT_EQ(placement.rule, PlacementRule::Landmarks);
    trousers.positions = moved(trousers.positions, placement.pose);
    EXPECT_EQ(faultsOf(trousers, body), 0U) << quarters;
  }
}

TEST(Wearing, takesSleevesThatAreLongerThanTheArms) {
  const ShrinkingBody body(figure());
  const BodyParts parts(body);
  sim::ClothMesh shirt = tshirt();
  constexpr double sleeve = 0.25;  // from the middle [m]
  for (Vec3& position : shirt.positions) {
    const double beyond = std::abs(position.x()) - sleeve;
    if (beyond > 0.0) {  // 5 times as long, along an arm of the figure
      position += 4.0 * beyond * Vec3(position.x() > 0.0 ? 1.0 : -1.0, -0.7, 0.1);
    }
  }
  const GarmentOpenings openings(shirt);
  ASSERT_GT(openings.find(OpeningKind::LeftSleeve)->centre.x(), 0.75);
  const Wearing wearing(body, parts, openings, shirt.triangles);
  const std::vector<Vec3>& limbs = body.frames().front();
  EXPECT_EQ(wearing.missed(shirt.positions, limbs).size(), 2U);
  for (const Fault& fault : wearing.faults(shirt.positions, body.centreLines(), limbs)) {
    EXPECT_NE(fault.kind, FaultKind::MissesOpening);
  }
}

TEST(Wearing, namesALegThatIsBesideItsTrouserLeg) {
  const ShrinkingBody body(figure());
  const BodyParts parts(body);
  const sim::ClothMesh aside = shifted(scene::testing::trousers(0.75), {0.22, 0.08, 0.0});  // left leg in the right one
  const GarmentOpenings openings(aside);
  const std::vector<Fault> faults = Wearing(body, parts, openings, aside.triangles)
                                        .faults(aside.positions, body.centreLines(), body.frames().front());
  for (const BodyPart leg : {BodyPart::LeftLeg, BodyPart::RightLeg}) {
    EXPECT_TRUE(std::ranges::any_of(
        faults, [&](const Fault& fault) { return fault.kind == FaultKind::MissesOpening && fault.part == leg; }));
  }
}

TEST(Placement, putsACapeThatIsOpenAtTheFrontAroundTheNeck) {
  const ShrinkingBody body(figure());
  const BodyParts parts(body);
  for (const double quarters : {0.0, 2.0}) {
    sim::ClothMesh cape = scene::testing::openCape(40.0, 0.9);
    cape.positions = moved(cape.positions, farAway(quarters));
    const Placement placement = place(cape, body, parts, PlacementRule::Auto, noProgress);
    EXPECT_EQ(placement.rule, PlacementRule::Landmarks);
    cape.positions = moved(cape.positions, placement.pose);
    const GarmentOpenings openings(cape);
    EXPECT_FALSE(openings.facesBack()) << quarters;
    EXPECT_LT((openings.find(OpeningKind::Neck)->centre - parts.landmarks()->neck).norm(), 0.1) << quarters;
  }
}

TEST(Placement, putsAHoodOverTheHeadWithItsOpeningInFront) {
  const ShrinkingBody body(figure());
  const Vec3 head(0.0, 1.62, 0.02);
  for (const double quarters : {0.0, 1.0, 2.0}) {
    sim::ClothMesh robe = scene::testing::hoodedRobe();
    robe.positions = moved(robe.positions, farAway(quarters));
    const Placement placement = place(robe, body, BodyParts(body), PlacementRule::Auto, noProgress);
    robe.positions = moved(robe.positions, placement.pose);
    const Vec3 face = GarmentOpenings(robe).find(OpeningKind::Hood)->centre;
    EXPECT_GT(face.z(), head.z() + 0.05) << quarters;
    EXPECT_NEAR(face.y(), head.y(), 0.1) << quarters;
    EXPECT_NEAR(face.x(), 0.0, 0.03) << quarters;
  }
}

TEST(Placement, doesNotTakeARingAroundTheFeetForWorn) {
  const ShrinkingBody body(figure());
  const sim::ClothMesh ring = shifted(tube(0.25, 0.2), {0.0, 0.15, 0.0});
  const Placement placement = place(ring, body, BodyParts(body), PlacementRule::Auto, noProgress);
  EXPECT_EQ(placement.rule, PlacementRule::Landmarks);
  EXPECT_GT(placement.pose.position.y(), 0.5);
}

TEST(Placement, putsATubeAboveTheMiddleOfABodyThatIsNoPerson) {
  const ShrinkingBody body(ellipsoid({0.2, 0.5, 0.2}));
  const sim::ClothMesh garment = shifted(tube(0.25, 0.4), {2.0, 1.0, 0.5});
  const Placement placement = place(garment, body, BodyParts(body), PlacementRule::Auto, noProgress);
  EXPECT_EQ(placement.rule, PlacementRule::Boxes);
  const Vec3 centre = sim::boundsOf(moved(garment.positions, placement.pose)).center();
  EXPECT_NEAR(centre.x(), 0.0, 0.01);
  EXPECT_NEAR(centre.z(), 0.0, 0.1);
}

TEST(Wearing, namesTheArmsThatPassThroughTheWallsOfTheSleeves) {
  const ShrinkingBody body(mannequin());
  const BodyParts parts(body);
  const sim::ClothMesh raised = shifted(tshirt(), {0.0, 0.2, 0.0});
  const GarmentOpenings openings(raised);
  const std::vector<Fault> faults = Wearing(body, parts, openings, raised.triangles)
                                        .faults(raised.positions, body.centreLines(), body.frames().front());
  for (const BodyPart arm : {BodyPart::LeftArm, BodyPart::RightArm}) {
    EXPECT_TRUE(std::ranges::any_of(faults, [&](const Fault& fault) {
      return fault.kind == FaultKind::PassesWall && fault.part == arm && fault.atSleeve && fault.pairs > 0;
    }));
    EXPECT_TRUE(std::ranges::any_of(
        faults, [&](const Fault& fault) { return fault.kind == FaultKind::MissesOpening && fault.part == arm; }));
  }
}

}  // namespace
}  // namespace drape::dressing::testing
