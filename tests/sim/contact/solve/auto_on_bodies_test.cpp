// An energy-conserving solver with contact, which stretches springs.
#include "contact/contact_scene.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::sim::contact {
namespace {

/// Divides a triangle into slivers by a vertex close to a side.
void addSliver(ClothMesh& mesh, std::size_t triangle) {
  constexpr double height = 1e-3;  // over that of the triangle [-]
  const Triangle old = mesh.triangles[triangle];
  const auto at = [&](std::size_t k) { return mesh.positions[old[k]]; };
  mesh.positions.emplace_back((1.0 - height) * (0.4 * at(0) + 0.6 * at(1)) + height * at(2));
  const int middle = static_cast<int>(mesh.positions.size()) - 1;
  mesh.triangles[triangle] = {old[0], old[1], middle};
  mesh.triangles.push_back({old[1], old[2], middle});
  mesh.triangles.push_back({old[2], old[0], middle});
}

/// A stiff free sheet a little above a body.
testing::ContactScene stiffSheetOver(const Body& body, double stiffness, bool sliver = false) {
  ClothMesh mesh = testing::sheet(17);
  if (sliver) {
    addSliver(mesh, mesh.triangles.size() / 2);
  }
  for (Vec3& position : mesh.positions) {
    position += Vec3(-0.5, 0.33, -0.5);
  }
  testing::ContactScene scene(buildClothModel(mesh, 0.15, MassLumping::Area, {}), {body}, "auto");
  scene.parameters.timeStep = 1.0 / 150.0;
  scene.parameters.material.stiffness = stiffness;
  scene.parameters.material.damping = 0.003;
  return scene;
}

/// @param maxAllowedStretch of a spring, in rest lengths
void expectNoEnergyGain(const char* what, testing::ContactScene scene, double maxAllowedStretch = 0.5) {
  const double start = energyOf(scene.model(), scene.parameters, scene.state).total();
  double largest = start;
  double longest = 0.0;
  scene.run(0.6, [&](const StepReport&) {
    largest = std::max(largest, energyOf(scene.model(), scene.parameters, scene.state).total());
    longest = std::max(longest, maxStretch(scene.model(), scene.state));
  });
  EXPECT_LT(largest, start + 0.05) << what << " [J]";
  EXPECT_LT(longest, maxAllowedStretch) << what;
}

TEST(AutoOnBodies, doesNotAddEnergyToStiffClothInContact) {
  const Body ball = testing::bodyAt(SphereShape{0.3}, Vec3::Zero());
  const Body box = testing::bodyAt(BoxShape{Vec3(0.25, 0.3, 0.25)}, Vec3::Zero());
  for (const double stiffness : {500.0, 5000.0}) {
    expectNoEnergyGain("ball", stiffSheetOver(ball, stiffness));
    expectNoEnergyGain("box", stiffSheetOver(box, stiffness));
  }
}

TEST(AutoOnBodies, needsNoMoreContactSubstepsBecauseOfASliver) {
  const Body box = testing::bodyAt(BoxShape{Vec3(0.25, 0.3, 0.25)}, Vec3::Zero());
  testing::ContactScene even = stiffSheetOver(box, 500.0);
  testing::ContactScene uneven = stiffSheetOver(box, 500.0, true);
  const auto substepsNearIt = [](testing::ContactScene& scene) {
    for (int step = 0; step < 15; ++step) {  // it falls onto the box
      scene.step();
    }
    return scene.stepper().contactSubsteps();
  };
  EXPECT_EQ(substepsNearIt(even), 2);
  EXPECT_EQ(substepsNearIt(uneven), 2);
  expectNoEnergyGain("box, with a sliver", std::move(uneven),
                     10.0);  // the sliver's height is a thousandth of the triangle's
}

}  // namespace
}  // namespace drape::sim::contact
