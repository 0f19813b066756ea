#include "dressing/dressing.hpp"
#include "../scene/garment_shapes.hpp"
#include "intersection/intersections.hpp"
#include "shapes.hpp"
#include "sim/model/normals.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <utility>

namespace drape::dressing::testing {
namespace {

DressingOptions asInFiles() {
  DressingOptions options;
  options.rule = PlacementRule::File;
  options.step.material.stiffness = 150.0;
  return options;
}

TEST(Dressing, pushesATubeOutOfABodyThatPiercesIt) {
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  const sim::ClothMesh garment = tube(0.19, 0.4);
  const Dressed result = dress(*modelOf(garment), garment.positions, body, asInFiles());
  ASSERT_TRUE(result.fits);
  EXPECT_GT(result.before.body, 50U);
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_TRUE(result.faults.empty());
  EXPECT_TRUE(
      intersection::intersectingPairs({result.positions, garment.triangles}, {body.positions, body.triangles}).empty());
  // The waist of the tube is around the body, which would be inside out otherwise.
  for (const Vec3& position : result.positions) {
    if (std::abs(position.y()) < 0.1) {
      EXPECT_GT(std::hypot(position.x(), position.z()), 0.19);
    }
  }
}

TEST(Dressing, bringsTheArmsBackIntoTheSleevesOfAMisplacedTshirt) {
  const sim::ClothMesh garment = shifted(tshirt(), {0.0, -0.03, 0.04});
  const Dressed result = dress(*modelOf(garment), garment.positions, mannequin(), asInFiles());
  ASSERT_TRUE(result.fits);
  EXPECT_GT(result.before.body, 300U);
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_TRUE(result.faults.empty());
}

TEST(Dressing, bringsTheArmsIntoTheSleevesOfARaisedTshirt) {
  const sim::ClothMesh garment = shifted(tshirt(), {0.0, 0.1, 0.0});
  const Dressed result = dress(*modelOf(garment), garment.positions, mannequin(), asInFiles());
  ASSERT_TRUE(result.fits);
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_TRUE(result.faults.empty());
}

TEST(Dressing, putsACapeOverArmsThatAreHeldAside) {
  const sim::ClothMesh cape = scene::testing::openCape(40.0, 0.9);
  DressingOptions options;
  options.step.material.stiffness = 150.0;
  const Dressed result = dress(*modelOf(cape), cape.positions, figure(), options);
  ASSERT_TRUE(result.fits);
  EXPECT_EQ(result.placement.rule, PlacementRule::Landmarks);
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_TRUE(result.faults.empty());
  EXPECT_TRUE(result.isOpenCape);
}

TEST(Dressing, takesATightSuitAsItIs) {
  const sim::ClothMesh& body = figure();
  const auto surface = modelOf(body);
  sim::ClothMesh suit = body;  // the surface without hands, feet and head, 6 mm outside
  for (std::size_t v = 0; v < suit.positions.size(); ++v) {
    suit.positions[v] += 0.006 * sim::vertexNormal(*surface, body.positions, static_cast<int>(v));
  }
  std::erase_if(suit.triangles, [&](const Triangle& t) {
    const Vec3 centre = (body.positions[t[0]] + body.positions[t[1]] + body.positions[t[2]]) / 3.0;
    return centre.y() < 0.15 || centre.y() > 1.45 || std::abs(centre.x()) > 0.5;
  });
  DressingOptions options;
  options.step.material.stiffness = 150.0;
  const Dressed result = dress(*modelOf(suit), suit.positions, body, options);
  ASSERT_TRUE(result.fits);
  EXPECT_EQ(result.placement.rule, PlacementRule::File);
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_LT(result.stretch, 0.05);
}

TEST(Dressing, givesTheSameBitsWithAnyNumberOfThreads) {
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  const sim::ClothMesh garment = tube(0.19, 0.4);
  DressingOptions options = asInFiles();
  const Dressed one = dress(*modelOf(garment), garment.positions, body, options);
  options.step.threads = 3;
  const Dressed three = dress(*modelOf(garment), garment.positions, body, options);
  EXPECT_EQ(one.positions, three.positions);
}

TEST(Dressing, leavesAGarmentThatCannotBeWornWhereItIs) {
  // The body's middle line passes through the lid of the tube.
  sim::ClothMesh garment = tube(0.25, 0.4);
  const int lid = static_cast<int>(garment.positions.size());
  garment.positions.emplace_back(0.0, 0.2, 0.0);
  const int first = lid - 32;
  for (int k = 0; k < 32; ++k) {
    garment.triangles.push_back({first + k, first + (k + 1) % 32, lid});
  }
  const Dressed result = dress(*modelOf(garment), garment.positions, ellipsoid({0.2, 0.5, 0.2}), asInFiles());
  EXPECT_FALSE(result.fits);
  EXPECT_EQ(result.positions, garment.positions);
  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(result.faults.front().part, BodyPart::Whole);
}

TEST(Dressing, refusesAGarmentInsideTheBody) {
  const sim::ClothMesh garment = tube(0.05, 0.1);
  const Dressed result = dress(*modelOf(garment), garment.positions, ellipsoid({0.4, 0.9, 0.4}), asInFiles());
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_FALSE(result.fits);
  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(result.faults.front().kind, FaultKind::InsideBody);
  EXPECT_EQ(result.positions, garment.positions);
}

TEST(Dressing, tellsThatAGarmentHangsBesideTheBody) {
  const sim::ClothMesh beside = shifted(tube(0.2, 0.2), {0.45, 0.0, 0.0});
  const Dressed result = dress(*modelOf(beside), beside.positions, ellipsoid({0.2, 0.5, 0.2}), asInFiles());
  EXPECT_EQ(result.after.all(), 0U);
  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(result.faults.front().kind, FaultKind::MissesOpening);
  EXPECT_EQ(result.faults.front().opening, OpeningKind::Waist);
}

TEST(Dressing, tellsHowFarAGarmentIsStretched) {
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  const sim::ClothMesh loose = tube(0.22, 0.2);
  EXPECT_LT(dress(*modelOf(loose), loose.positions, body, asInFiles()).stretch, 0.02);
  const sim::ClothMesh small = tube(0.17, 0.2);
  EXPECT_GT(dress(*modelOf(small), small.positions, body, asInFiles()).stretch, 0.12);
}

TEST(Dressing, fillsSmallHolesOfTheBody) {
  const sim::ClothMesh garment = tube(0.19, 0.4);
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  sim::ClothMesh open = body;
  std::erase_if(open.triangles, [&](const Triangle& t) { return open.positions[t[0]].y() > 0.48; });
  ASSERT_LT(open.triangles.size(), body.triangles.size());
  const Dressed result = dress(*modelOf(garment), garment.positions, open, asInFiles());
  EXPECT_EQ(result.filledHoles, 1);
  EXPECT_GT(result.before.body, 0U);
  EXPECT_EQ(result.after.all(), 0U);
  EXPECT_EQ(dress(*modelOf(garment), garment.positions, body, asInFiles()).filledHoles, 0);
}

TEST(Dressing, movesAndTurnsByHandAfterThePlacement) {
  const sim::ClothMesh garment = tube(0.3, 0.4);
  DressingOptions options = asInFiles();
  options.move = Vec3(0.0, 0.05, 0.01);
  const Dressed result = dress(*modelOf(garment), garment.positions, ellipsoid({0.2, 0.5, 0.2}), options);
  EXPECT_TRUE(result.placement.pose.position.isApprox(options.move, 1e-12));
  EXPECT_EQ(result.before.all(), 0U);
}

TEST(Dressing, tellsWhyMeshesCannotBeDressed) {
  const sim::ClothMesh garment = tube(0.3, 0.4);
  const sim::ClothMesh body = ellipsoid({0.2, 0.5, 0.2});
  EXPECT_EQ(misfitOf(garment, body), Misfit::None);
  sim::ClothMesh open = body;
  open.triangles.pop_back();
  EXPECT_EQ(misfitOf(garment, open), Misfit::None);  // a small hole is filled
  std::erase_if(open.triangles, [&](const Triangle& t) { return open.positions[t[0]].y() > 0.0; });
  EXPECT_EQ(misfitOf(garment, open), Misfit::OpenBody);
  sim::ClothMesh insideOut = body;
  for (Triangle& triangle : insideOut.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  EXPECT_EQ(misfitOf(garment, insideOut), Misfit::NoVolume);
  EXPECT_EQ(misfitOf(garment, ellipsoid({0.2, 0.5, 1e-7})), Misfit::NoVolume);
  EXPECT_EQ(misfitOf(tube(30.0, 40.0), body), Misfit::GarmentTooLarge);
  EXPECT_EQ(misfitOf(tube(0.003, 0.004), body), Misfit::GarmentTooSmall);
}

}  // namespace
}  // namespace drape::dressing::testing
