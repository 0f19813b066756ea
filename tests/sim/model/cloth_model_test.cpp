#include "sim/model/cloth_model.hpp"
#include "sim/model/sim_error.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <set>

namespace drape::sim {
namespace {

TEST(ClothModel, hasThePapersCountsFor17And33VerticesASide) {
  const auto small = testing::pinnedSheet(17);
  EXPECT_EQ(small->vertexCount(), 289);
  EXPECT_EQ(small->springs.size(), 800U);
  EXPECT_EQ(small->triangles.size(), 512U);
  const auto large = testing::pinnedSheet(33);
  EXPECT_EQ(large->vertexCount(), 1089);
  EXPECT_EQ(large->springs.size(), 3136U);
  EXPECT_EQ(large->triangles.size(), 2048U);
}

TEST(ClothModel, makesOneSpringForEachEdge) {
  const auto model = testing::pinnedSheet(6);
  std::set<std::pair<int, int>> seen;
  for (const Spring& spring : model->springs) {
    EXPECT_LT(spring.a, spring.b);
    EXPECT_TRUE(seen.insert({spring.a, spring.b}).second);
    const Vec3 offset = model->restPositions[spring.b] - model->restPositions[spring.a];
    EXPECT_DOUBLE_EQ(spring.restLength, offset.norm());
  }
}

TEST(ClothModel, listsEachSpringAtBothItsEnds) {
  const auto model = testing::pinnedSheet(6);
  EXPECT_EQ(model->springEnds.values().size(), 2 * model->springs.size());
  for (int v = 0; v < model->vertexCount(); ++v) {
    for (const SpringEnd& end : model->springEnds[v]) {
      const Spring& spring = model->springs[end.spring];
      EXPECT_TRUE((spring.a == v && spring.b == end.neighbour) || (spring.b == v && spring.a == end.neighbour));
    }
  }
}

TEST(ClothModel, spreadsTheMassByAreaOrEvenly) {
  const auto uniform = buildClothModel(testing::sheet(5), 0.1, MassLumping::Uniform, {});
  EXPECT_NEAR(uniform->totalMass(), 0.1, 1e-15);
  EXPECT_DOUBLE_EQ(uniform->vertexMass[0], uniform->vertexMass[12]);
  const auto byArea = buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {});
  EXPECT_NEAR(byArea->totalMass(), 0.1, 1e-15);
  EXPECT_NEAR(byArea->vertexMass[12] / byArea->vertexMass[2], 2.0, 1e-12) << "an edge has half the area around it";
  EXPECT_NEAR(byArea->restArea(), 1.0, 1e-14);
}

TEST(ClothModel, changesMassAndPinsWithoutTouchingTheOriginal) {
  const auto model = testing::pinnedSheet(4);
  const auto heavy = withMass(*model, 2.0, MassLumping::Uniform);
  EXPECT_NEAR(heavy->totalMass(), 2.0, 1e-14);
  EXPECT_NEAR(model->totalMass(), 0.1, 1e-15);
  std::vector<bool> pinned(16, false);
  pinned[5] = true;
  const auto other = withPins(*model, pinned);
  EXPECT_TRUE(other->pinned[5]);
  EXPECT_FALSE(other->pinned[0]);
  EXPECT_TRUE(model->pinned[0]);
}

TEST(ClothModel, takesOtherMassesAndStiffnessesWithTheFrequenciesThatFollow) {
  const auto model = testing::pinnedSheet(4);
  const auto heavy = withVertexMasses(*model, std::vector<double>(16, 4.0 * model->vertexMass[0]));
  EXPECT_NEAR(heavy->unitFrequency, 0.5 * model->unitFrequency, 1e-12 * model->unitFrequency);
  std::vector<double> relative(model->springs.size(), 1.0);
  EXPECT_TRUE(withSpringStiffness(*model, relative)->evenlyStiff());
  relative[7] = 9.0;
  const auto uneven = withSpringStiffness(*model, relative);
  EXPECT_FALSE(uneven->evenlyStiff());
  EXPECT_EQ(uneven->springs[7].relativeStiffness, 9.0);
  EXPECT_EQ(uneven->stiffestSpring, 9.0);
  EXPECT_GT(uneven->unitFrequency, 1.5 * model->unitFrequency);
  EXPECT_EQ(model->springs[7].relativeStiffness, 1.0);
}

using Fault = ClothModelError::Fault;

/// The fault that `action` throws.
template <typename Action>
ClothModelError faultOf(const Action& action) {
  try {
    static_cast<void>(action());
  } catch (const ClothModelError& error) {
    return error;
  }
  ADD_FAILURE() << "no ClothModelError";
  return {Fault::Mass, {}};
}

/// The fault of building a cloth.
ClothModelError faultOfCloth(const ClothMesh& mesh, double mass, const std::vector<int>& pins = {}) {
  return faultOf([&] { return buildClothModel(mesh, mass, MassLumping::Area, pins); });
}

TEST(ClothModel, refusesMassesAndStiffnessesThatCannotBe) {
  const auto model = testing::pinnedSheet(4);
  std::vector<double> masses = model->vertexMass;
  const ClothModelError fewMasses = faultOf([&] { return withVertexMasses(*model, {1.0}); });
  EXPECT_EQ(fewMasses.fault(), Fault::MassCount);
  EXPECT_EQ(fewMasses.numbers().found, 1);
  EXPECT_EQ(fewMasses.numbers().count, 16);
  masses[3] = 0.0;
  const ClothModelError noMass = faultOf([&] { return withVertexMasses(*model, masses); });
  EXPECT_EQ(noMass.fault(), Fault::VertexMass);
  EXPECT_EQ(noMass.numbers().index, 3);
  EXPECT_EQ(noMass.numbers().value, 0.0);
  std::vector<double> relative(model->springs.size(), 1.0);
  EXPECT_EQ(faultOf([&] { return withSpringStiffness(*model, {1.0}); }).fault(), Fault::StiffnessCount);
  relative[3] = -1.0;
  const ClothModelError negative = faultOf([&] { return withSpringStiffness(*model, relative); });
  EXPECT_EQ(negative.fault(), Fault::Stiffness);
  EXPECT_EQ(negative.numbers().index, 3);
  EXPECT_EQ(negative.numbers().value, -1.0);
  EXPECT_EQ(faultOf([&] { return withPins(*model, {true}); }).fault(), Fault::PinCount);
}

TEST(ClothModel, refusesInvalidMeshesMassesAndPins) {
  const auto mesh = testing::sheet(3);
  EXPECT_EQ(faultOfCloth({}, 0.1).fault(), Fault::NoTriangle);
  EXPECT_EQ(faultOfCloth(mesh, 0.0).fault(), Fault::Mass);
  EXPECT_EQ(faultOfCloth(mesh, -1.0).numbers().value, -1.0);
  const ClothModelError pin = faultOfCloth(mesh, 0.1, {9});
  EXPECT_EQ(pin.fault(), Fault::NoSuchPin);
  EXPECT_EQ(pin.numbers().index, 9);
  EXPECT_EQ(pin.numbers().count, 9);
  auto broken = mesh;
  broken.triangles[0][1] = 99;
  const ClothModelError triangle = faultOfCloth(broken, 0.1);
  EXPECT_EQ(triangle.fault(), Fault::NoSuchVertex);
  EXPECT_EQ(triangle.numbers().index, 0);
  EXPECT_EQ(triangle.numbers().found, 99);
  EXPECT_STREQ(triangle.what(), "ClothModelError::NoSuchVertex, index=0, found=99, count=9, value=0.000000");
  broken = mesh;
  broken.positions[4].y() = std::numeric_limits<double>::quiet_NaN();
  const ClothModelError vertex = faultOfCloth(broken, 0.1);
  EXPECT_EQ(vertex.fault(), Fault::VertexNotFinite);
  EXPECT_EQ(vertex.numbers().index, 4);
}

TEST(ClothModel, givesEvenAVertexOfASliverSomeMass) {
  ClothMesh mesh = testing::sheet(3);
  mesh.positions.emplace_back(0.5, 1e-9, -1e-9);
  mesh.triangles.push_back({0, 1, 9});
  const auto model = buildClothModel(mesh, 0.1, MassLumping::Area, {});
  EXPECT_GT(model->vertexMass[9], 1e-4);
}

}  // namespace
}  // namespace drape::sim
