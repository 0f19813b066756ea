// A solver that keeps energy, on bodies that put the cloth back where it does not want to be.
#include "contact/meeting.hpp"
#include "sim/diagnostics.hpp"
#include "sim/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape {
namespace {

/// Puts a vertex so near to a side of a triangle that three slivers take its place.
void addSliver(ClothMesh& mesh, std::size_t triangle) {
  constexpr double height = 1e-3;  // of the triangle's [-]
  const Triangle old = mesh.triangles[triangle];
  const auto at = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(old[k])]; };
  mesh.positions.emplace_back((1.0 - height) * (0.4 * at(0) + 0.6 * at(1)) + height * at(2));
  const int middle = static_cast<int>(mesh.positions.size()) - 1;
  mesh.triangles[triangle] = {old[0], old[1], middle};
  mesh.triangles.push_back({old[1], old[2], middle});
  mesh.triangles.push_back({old[2], old[0], middle});
}

/// A stiff free sheet a little above a body.
testing::Meeting stiffSheetOver(const Body& body, double stiffness, bool sliver = false) {
  ClothMesh mesh = testing::sheet(17);
  if (sliver) {
    addSliver(mesh, mesh.triangles.size() / 2);
  }
  for (Vec3& position : mesh.positions) {
    position += Vec3(-0.5, 0.33, -0.5);
  }
  testing::Meeting meeting(buildClothModel(mesh, 0.15, MassLumping::Area, {}), {body}, "auto");
  meeting.parameters.timeStep = 1.0 / 150.0;
  meeting.parameters.stiffness = stiffness;
  meeting.parameters.damping = 0.003;
  return meeting;
}

/// @param mostStretch how much longer than at rest a spring may become, in its lengths
void expectCalm(const char* what, testing::Meeting meeting, double mostStretch = 0.5) {
  const double start = energyOf(meeting.model(), meeting.parameters, meeting.state).total();
  double most = start;
  double longest = 0.0;
  meeting.run(0.6, [&](const StepReport&) {
    most = std::max(most, energyOf(meeting.model(), meeting.parameters, meeting.state).total());
    longest = std::max(longest, maxStretch(meeting.model(), meeting.state));
  });
  EXPECT_LT(most, start + 0.05) << what << " [J]";
  EXPECT_LT(longest, mostStretch) << what;
}

TEST(AutoOnBodies, keepsStiffClothCalmThatIsPutBackByContact) {
  const Body ball = testing::bodyAt(SphereShape{0.3}, Vec3::Zero());
  const Body box = testing::bodyAt(BoxShape{Vec3(0.25, 0.3, 0.25)}, Vec3::Zero());
  for (const double stiffness : {500.0, 5000.0}) {
    expectCalm("ball", stiffSheetOver(ball, stiffness));
    expectCalm("box", stiffSheetOver(box, stiffness));
  }
}

TEST(AutoOnBodies, takesNoMoreRoundsForTheSakeOfASliver) {
  const Body box = testing::bodyAt(BoxShape{Vec3(0.25, 0.3, 0.25)}, Vec3::Zero());
  testing::Meeting even = stiffSheetOver(box, 500.0);
  testing::Meeting uneven = stiffSheetOver(box, 500.0, true);
  const auto roundsNearIt = [](testing::Meeting& meeting) {
    for (int step = 0; step < 15; ++step) {  // it falls by what it is above the box
      meeting.step();
    }
    return meeting.stepper().contactSubsteps();
  };
  const int rounds = roundsNearIt(even);
  EXPECT_GT(rounds, 2);
  EXPECT_LE(roundsNearIt(uneven), rounds + 1);
  expectCalm("box, with a sliver", std::move(uneven),
             10.0);  // the side across the sliver has a thousandth of its length
}

}  // namespace
}  // namespace drape
