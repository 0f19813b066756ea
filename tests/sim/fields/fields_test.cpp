#include "fabric_cloths.hpp"
#include "sim/fields/field_table.hpp"
#include "sim/stepping/contact_loads.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace drape::sim::fields {
namespace {

using testing::sheet;

constexpr double pi = std::numbers::pi;

/// The values of a field of a cloth at these positions. Warp runs along x.
std::vector<double> valuesOf(std::string_view name, const ClothModel& model, std::span<const Vec3> positions,
                             BodyGaps* bodies = nullptr) {
  const auto warp = fabric::warpAlong(Vec3::UnitX(), model.restPositions, model.triangles);
  const FieldGeometry geometry = fieldGeometryOf(model, warp);
  const FieldInputs inputs{.model = model,
                           .geometry = geometry,
                           .positions = positions,
                           .velocities = {},
                           .ghost = {},
                           .contactImpulses = {},
                           .bodies = bodies};
  std::vector<double> values(positions.size());
  EXPECT_TRUE(canCompute(*findField(name), inputs)) << name;
  findField(name)->compute(inputs, values);
  return values;
}

/// Every position x of the sheet becomes map(x).
template <typename Map>
std::vector<Vec3> moved(const ClothModel& model, const Map& map) {
  std::vector<Vec3> positions = model.restPositions;
  std::transform(positions.begin(), positions.end(), positions.begin(), map);
  return positions;
}

void expectAll(const std::vector<double>& values, double expected, double tolerance) {
  for (const double value : values) {
    ASSERT_NEAR(value, expected, tolerance);
  }
}

/// A flat sheet of springs with displaced vertices.
std::shared_ptr<const ClothModel> flatSheet(int n = 9) {
  ClothMesh mesh = sheet(n);
  testing::RandomVectors random(3);
  for (Vec3& position : mesh.positions) {
    const Vec3 by = random.next(0.2 / (n - 1));
    position += Vec3(by.x(), 0.0, by.z());
  }
  return buildClothModel(mesh, 0.15, MassLumping::Area, {});
}

/// The same with a fabric.
std::shared_ptr<const ClothModel> fabricSheet(const fabric::Material& material) {
  const auto model = flatSheet();
  return fabric::withFabric(*model, material, fabric::warpAlong(Vec3::UnitX(), model->restPositions, model->triangles));
}

TEST(Fields, HaveDifferentNamesATitleAndAUnit) {
  std::set<std::string_view> names;
  for (const FieldInfo& field : fieldTable()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_EQ(findField(field.name), &field);
    EXPECT_FALSE(field.title.empty() || field.unit.empty() || field.help.empty()) << field.name;
    EXPECT_GT(field.minExtent, 0.0) << field.name;
  }
  EXPECT_EQ(findField("off"), nullptr);
}

TEST(Fields, AStretchedSheetHasTheStretchOfEachDirection) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1.0, 2.0, 3.0).normalized());
  for (const auto& model : {flatSheet(), fabricSheet(testing::woven())}) {
    const auto positions =
        moved(*model, [&](const Vec3& x) { return Vec3(turn * Vec3(1.2 * x.x(), x.y(), 0.9 * x.z())); });
    expectAll(valuesOf("strain_warp", *model, positions), 120.0, 1e-9);
    expectAll(valuesOf("strain_weft", *model, positions), 90.0, 1e-9);
    expectAll(valuesOf("strain_shear", *model, positions), 0.0, 1e-9);
  }
}

TEST(Fields, ASheetAtRestHasNoStrainAndNoStress) {
  const auto model = fabricSheet(testing::woven());
  expectAll(valuesOf("strain_warp", *model, model->restPositions), 100.0, 1e-9);
  expectAll(valuesOf("strain_weft", *model, model->restPositions), 100.0, 1e-9);
  expectAll(valuesOf("strain_shear", *model, model->restPositions), 0.0, 1e-9);
  expectAll(valuesOf("stress", *model, model->restPositions), 0.0, 1e-6);
}

TEST(Fields, ASheetWhoseYarnsTurnTowardsEachOtherHasThatShearAngle) {
  const auto model = flatSheet();
  const double angle = 20.0 * pi / 180.0;
  const fabric::RestTriangle rest =
      fieldGeometryOf(*model, fabric::warpAlong(Vec3::UnitX(), model->restPositions, model->triangles)).rest.front();
  ASSERT_GT(rest.area, 0.0);
  // Weft runs along z or against it; both yarns keep their length.
  const auto sheared =
      moved(*model, [&](const Vec3& x) { return Vec3(x.x() + std::sin(angle) * x.z(), 0.0, std::cos(angle) * x.z()); });
  std::vector<double> values = valuesOf("strain_shear", *model, sheared);
  for (double& value : values) {
    value = std::abs(value);
  }
  expectAll(values, 20.0, 1e-9);
  expectAll(valuesOf("strain_weft", *model, sheared), 100.0, 1e-9);
  const auto mirrored =
      moved(*model, [&](const Vec3& x) { return Vec3(x.x() - std::sin(angle) * x.z(), 0.0, std::cos(angle) * x.z()); });
  EXPECT_NEAR(valuesOf("strain_shear", *model, mirrored).front(), -valuesOf("strain_shear", *model, sheared).front(),
              1e-9);
}

TEST(Fields, AFabricStretchedAlongOneYarnHasTheStressOfItsModulus) {
  fabric::Material material = testing::membraneOnly();
  material.poisson = 0.0;
  const auto model = fabricSheet(material);
  const double stretch = 1.1;
  const double green = 0.5 * (stretch * stretch - 1.0);
  const auto alongWarp = moved(*model, [&](const Vec3& x) { return Vec3(stretch * x.x(), 0.0, x.z()); });
  // Force per present width: the width stays, so it is that per width at rest, F S = stretch C_11 E_11.
  expectAll(valuesOf("stress", *model, alongWarp), stretch * material.stretchWarp * green, 1e-6);
  const auto alongWeft = moved(*model, [&](const Vec3& x) { return Vec3(x.x(), 0.0, stretch * x.z()); });
  expectAll(valuesOf("stress", *model, alongWeft), stretch * material.stretchWeft * green, 1e-6);
}

TEST(Fields, SpringsHaveNoStress) {
  const auto model = flatSheet();
  const FieldGeometry geometry = fieldGeometryOf(*model, model->restPositions);
  EXPECT_FALSE(canCompute(*findField("stress"), {.model = *model,
                                                 .geometry = geometry,
                                                 .positions = model->restPositions,
                                                 .velocities = {},
                                                 .ghost = {},
                                                 .contactImpulses = {}}));
}

class CylinderCurvature : public ::testing::TestWithParam<double> {};

TEST_P(CylinderCurvature, IsOneOverTheRadiusOnEitherSide) {
  const double radius = GetParam();
  const auto model = buildClothModel(sheet(33), 0.1, MassLumping::Area, {});
  // Rolled about the z axis. In the sheet the front looks up: bulging up is positive.
  const auto bent = [&](double side) {
    return moved(*model, [&](const Vec3& x) {
      const double angle = x.x() / radius;
      return Vec3(radius * std::sin(angle), side * radius * (std::cos(angle) - 1.0), x.z());
    });
  };
  const std::vector<double> up = valuesOf("bending", *model, bent(1.0));
  const std::vector<double> down = valuesOf("bending", *model, bent(-1.0));
  for (std::size_t v = 0; v < up.size(); ++v) {
    ASSERT_NEAR(up[v], 1.0 / radius, 0.01 / radius) << "vertex " << v;
    ASSERT_NEAR(down[v], -up[v], 1e-6 / radius) << "vertex " << v;
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, CylinderCurvature, ::testing::Values(0.3, 1.0, 5.0));

TEST(Fields, ASphericalCapHasTheCurvatureOfTheSphere) {
  const double radius = 2.0;
  const auto model = flatSheet(25);
  const auto cap = moved(*model, [&](const Vec3& x) {
    const Vec3 centred(x.x() - 0.5, radius, x.z() - 0.5);
    return Vec3(radius * centred.normalized());
  });
  for (const double value : valuesOf("bending", *model, cap)) {
    ASSERT_NEAR(value, 1.0 / radius, 0.08 / radius);
  }
}

TEST(Fields, AFlatSheetHasNoCurvature) {
  const auto model = flatSheet();
  expectAll(valuesOf("bending", *model, model->restPositions), 0.0, 1e-9);
}

/// Two triangles: all vertices lie on the border.
TEST(Fields, EvenTheSmallestMeshHasACurvatureEverywhere) {
  const auto model = buildClothModel(sheet(2), 0.1, MassLumping::Area, {});
  expectAll(valuesOf("bending", *model, model->restPositions), 0.0, 1e-9);
}

/// A body of that shape at a place, and its gaps to the sheet.
std::vector<double> gapsTo(const contact::BodyShape& shape, const Vec3& place, std::span<const Vec3> positions) {
  auto bodies = std::make_shared<std::vector<contact::Body>>(1);
  bodies->front().shape = shape;
  BodyGaps gaps(bodies);
  BodyPlace at;
  at.pose.position = place;
  at.pose.rotation = Eigen::AngleAxisd(0.5, Vec3::UnitX());
  EXPECT_TRUE(gaps.moveTo({at}));
  const auto model = buildClothModel(sheet(2), 0.1, MassLumping::Area, {});
  std::vector<double> values(positions.size());
  gaps.compute(positions, values);
  return values;
}

TEST(BodyGaps, AreDistancesToTheSurfaceAndNegativeInside) {
  const std::vector<Vec3> points{{0.0, 1.0, 0.0}, {0.0, 0.2, 0.0}, {2.0, 0.0, 0.0}};
  const std::vector<double> sphere = gapsTo(contact::SphereShape{0.5}, Vec3::Zero(), points);
  EXPECT_NEAR(sphere[0], 0.5, 1e-12);
  EXPECT_NEAR(sphere[1], -0.3, 1e-12);
  EXPECT_NEAR(sphere[2], 1.5, 1e-12);
  const std::vector<double> box = gapsTo(contact::BoxShape{Vec3(0.5, 0.5, 0.5)}, Vec3::Zero(), points);
  EXPECT_NEAR(box[2], 1.5, 1e-12);
  EXPECT_LT(box[1], 0.0);
}

TEST(BodyGaps, OfAClosedMeshAreThoseOfTheShapeThatItDescribes) {
  auto cube = std::make_shared<contact::MeshShape>();
  const contact::BodySurface surface = contact::surfaceOf(contact::BoxShape{Vec3(0.3, 0.4, 0.5)});
  cube->positions = surface.positions;
  cube->triangles = surface.triangles;
  testing::RandomVectors random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) {
    points.push_back(random.next(1.0));
  }
  const Vec3 place(0.1, -0.2, 0.05);
  const std::vector<double> box = gapsTo(contact::BoxShape{Vec3(0.3, 0.4, 0.5)}, place, points);
  const std::vector<double> mesh = gapsTo(std::shared_ptr<const contact::MeshShape>(cube), place, points);
  EXPECT_TRUE(std::any_of(box.begin(), box.end(), [](double gap) { return gap < 0.0; }));
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(mesh[i], box[i], 1e-9) << i;
  }
}

TEST(BodyGaps, IgnoreBodiesThatAreOff) {
  BodyGaps gaps(std::make_shared<std::vector<contact::Body>>(1));
  BodyPlace off;
  off.on = false;
  EXPECT_FALSE(gaps.moveTo({off}));
}

/// A sheet that lies on a plane, moved by a solver.
class SheetOnAPlane : public ::testing::TestWithParam<const char*> {};

TEST_P(SheetOnAPlane, PressesWithItsWeightPerArea) {
  const double density = 0.2;
  ClothMesh mesh = sheet(9);
  const auto model = buildClothModel(mesh, density, MassLumping::Area, {});
  contact::Body ground;
  ground.shape = contact::PlaneShape{};
  std::vector<contact::BodyStep> bodies(1);
  bodies.front().body = &ground;
  bodies.front().surface = ground.surface;
  StepInputs inputs;
  inputs.bodies = &bodies;
  StepParameters parameters;
  parameters.timeStep = 1.0 / 120.0;
  parameters.material.stiffness = 100.0;
  parameters.contact.self = contact::SelfCollision::Off;
  ClothState state = stateAtRest(model->restPositions);
  for (Vec3& position : state.positions) {
    position.y() = ground.surface.thickness + 0.5 * parameters.contact.thickness;
  }
  Stepper stepper(GetParam());
  stepper.keepContactLoads(true);
  for (int step = 0; step < 60; ++step) {
    stepper.step(*model, parameters, inputs, state);
  }
  const std::vector<double> impulses = stepper.contactLoads().impulses();
  const FieldGeometry geometry = fieldGeometryOf(*model, model->restPositions);
  const FieldInputs fieldInputs{.model = *model,
                                .geometry = geometry,
                                .positions = state.positions,
                                .velocities = {},
                                .ghost = {},
                                .contactImpulses = impulses,
                                .timeStep = parameters.timeStep};
  std::vector<double> pressure(state.positions.size());
  findField("contact_pressure")->compute(fieldInputs, pressure);
  expectAll(pressure, density * parameters.gravity, 0.02 * density * parameters.gravity);
}

INSTANTIATE_TEST_SUITE_P(Solvers, SheetOnAPlane, ::testing::Values("auto", "newton", "xpbd", "one_iteration"));

TEST(ContactLoads, OfClothBetweenTwoLayersAreThoseOfOneSide) {
  const auto model = buildClothModel(sheet(3), 0.1, MassLumping::Area, {});
  SubstepContact above;
  above.vertices = {4, 0, 0, 0};
  above.weights = {1.0, 0.0, 0.0, 0.0};
  above.impulse = Vec3(0.0, -0.3, 0.1);
  SubstepContact below = above;
  below.impulse = Vec3(0.0, 0.5, 0.0);
  ContactLoads loads;
  EXPECT_FALSE(loads.known());
  loads.begin(*model);
  loads.add(*model, std::vector{above, below}, model->restPositions);
  EXPECT_DOUBLE_EQ(loads.impulses()[4], 0.5);
  EXPECT_DOUBLE_EQ(loads.impulses()[0], 0.0);
}

TEST(ContactLoads, DoNotChangeTheMotion) {
  const auto model = testing::pinnedSheet(7);
  StepParameters parameters;
  parameters.contact.self = contact::SelfCollision::Auto;
  ClothState plain = testing::shaken(*model, 0.01, 3);
  ClothState watched = plain;
  Stepper one("auto");
  Stepper other("auto");
  other.keepContactLoads(true);
  for (int step = 0; step < 40; ++step) {
    one.step(*model, parameters, {}, plain);
    other.step(*model, parameters, {}, watched);
  }
  EXPECT_EQ(stateHash(plain), stateHash(watched));
}

}  // namespace
}  // namespace drape::sim::fields
