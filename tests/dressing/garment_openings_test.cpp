#include "dressing/garment_openings.hpp"
#include "../scene/garment_shapes.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::dressing::testing {
namespace {

namespace shapes = scene::testing;

sim::ClothMesh turnedRound(sim::ClothMesh mesh) {
  for (Vec3& position : mesh.positions) {
    position = Vec3(-position.x(), position.y(), -position.z());
  }
  return mesh;
}

TEST(GarmentOpenings, areNamedOnATshirtAndATube) {
  const GarmentOpenings ofShirt(tshirt());
  ASSERT_EQ(ofShirt.all().size(), 4U);
  ASSERT_NE(ofShirt.find(OpeningKind::LeftSleeve), nullptr);
  EXPECT_GT(ofShirt.find(OpeningKind::LeftSleeve)->centre.x(), 0.3);
  EXPECT_LT(ofShirt.find(OpeningKind::RightSleeve)->centre.x(), -0.3);
  EXPECT_GT(ofShirt.find(OpeningKind::Neck)->centre.y(), 1.3);
  EXPECT_FALSE(ofShirt.facesBack());
  const GarmentOpenings ofTube(tube(0.2, 0.5));
  EXPECT_NE(ofTube.find(OpeningKind::Waist), nullptr);
  EXPECT_EQ(ofTube.find(OpeningKind::LeftSleeve), nullptr);
}

TEST(GarmentOpenings, ofTrousersAreAWaistAndTwoLegs) {
  for (const sim::ClothMesh& mesh : {shapes::trousers(0.75), shapes::trousers(0.2), shapes::briefs()}) {
    const GarmentOpenings openings(mesh);
    ASSERT_EQ(openings.all().size(), 3U);
    ASSERT_NE(openings.find(OpeningKind::Waist), nullptr);
    ASSERT_NE(openings.find(OpeningKind::LeftLeg), nullptr);
    ASSERT_NE(openings.find(OpeningKind::RightLeg), nullptr);
    EXPECT_GT(openings.find(OpeningKind::LeftLeg)->centre.x(), 0.05);
    EXPECT_LT(openings.find(OpeningKind::RightLeg)->centre.x(), -0.05);
  }
}

TEST(GarmentOpenings, ofAShirtWithSleevesBelowItsHemAreNoLegs) {
  shapes::GarmentSizes sizes;
  sizes.sleeve = 0.55;
  sim::ClothMesh shirt = shapes::shirt(sizes);
  for (Vec3& position : shirt.positions) {
    if (std::abs(position.x()) < 0.3) {
      position.y() = 0.5 * (position.y() + sizes.height);
    }
  }
  const GarmentOpenings openings(shirt);
  ASSERT_LT(openings.find(OpeningKind::LeftSleeve)->centre.y(), openings.find(OpeningKind::Hem)->centre.y());
  EXPECT_NE(openings.find(OpeningKind::Neck), nullptr);
  EXPECT_NE(openings.find(OpeningKind::LeftSleeve), nullptr);
  EXPECT_EQ(openings.find(OpeningKind::LeftLeg), nullptr);
}

TEST(GarmentOpenings, ofACardiganAreSleevesAndShowItsFront) {
  shapes::GarmentSizes sizes;
  sizes.sleeve = 0.5;
  sizes.frontGap = 0.04;
  const sim::ClothMesh cardigan = shapes::shirt(sizes);
  EXPECT_NE(GarmentOpenings(cardigan).find(OpeningKind::LeftSleeve), nullptr);
  EXPECT_FALSE(GarmentOpenings(cardigan).facesBack());
  const GarmentOpenings turned(turnedRound(cardigan));
  EXPECT_TRUE(turned.facesBack());
  EXPECT_LT(turned.find(OpeningKind::LeftSleeve)->centre.x(), 0.0);
}

TEST(GarmentOpenings, ofACapeThatIsOpenAtTheFrontAreANeckAndShowItsFront) {
  for (const double gap : {10.0, 40.0, 100.0}) {
    const sim::ClothMesh cape = shapes::openCape(gap, 0.9);
    const GarmentOpenings openings(cape);
    ASSERT_EQ(openings.all().size(), 1U) << gap;
    const Opening* neck = openings.find(OpeningKind::Neck);
    ASSERT_NE(neck, nullptr) << gap;
    EXPECT_NEAR(neck->centre.y(), 0.9, 0.05) << gap;
    EXPECT_NEAR(neck->centre.x(), 0.0, 0.01) << gap;
    EXPECT_FALSE(openings.facesBack()) << gap;
    EXPECT_TRUE(GarmentOpenings(turnedRound(cape)).facesBack()) << gap;
  }
}

TEST(GarmentOpenings, ofAWrapSkirtAreAWaist) {
  sim::ClothMesh skirt = shapes::openCape(20.0, 0.6);
  for (Vec3& position : skirt.positions) {  // a cylinder is nearer to it than a cone
    const double radius = std::hypot(position.x(), position.z());
    const double narrow = (0.14 + 0.3 * (radius - 0.1)) / radius;
    position = Vec3(narrow * position.x(), position.y(), narrow * position.z());
  }
  const GarmentOpenings openings(skirt);
  ASSERT_EQ(openings.all().size(), 1U);
  EXPECT_NE(openings.find(OpeningKind::Waist), nullptr);
}

TEST(GarmentOpenings, ofSheetsThatHangOrLieAreNone) {
  EXPECT_TRUE(GarmentOpenings(shapes::sheet(0, 1, 1.0, 1.5, 21)).all().empty());
  EXPECT_TRUE(GarmentOpenings(shapes::sheet(0, 2, 1.0, 1.5, 21)).all().empty());
}

TEST(GarmentOpenings, ofAnApronAreANeckAndShowItsFront) {
  const GarmentOpenings apron(shapes::apron());
  ASSERT_EQ(apron.all().size(), 1U);
  EXPECT_NE(apron.find(OpeningKind::Neck), nullptr);
  EXPECT_FALSE(apron.facesBack());
  EXPECT_TRUE(GarmentOpenings(turnedRound(shapes::apron())).facesBack());
}

TEST(GarmentOpenings, ofAHoodedRobeAreSleevesHemAndHoodAndShowItsFront) {
  const GarmentOpenings robe(shapes::hoodedRobe());
  ASSERT_NE(robe.find(OpeningKind::Hood), nullptr);
  EXPECT_NE(robe.find(OpeningKind::LeftSleeve), nullptr);
  EXPECT_NE(robe.find(OpeningKind::Hem), nullptr);
  EXPECT_EQ(robe.find(OpeningKind::Neck), nullptr);
  EXPECT_FALSE(robe.facesBack());
  EXPECT_TRUE(GarmentOpenings(turnedRound(shapes::hoodedRobe())).facesBack());
}

}  // namespace
}  // namespace drape::dressing::testing
