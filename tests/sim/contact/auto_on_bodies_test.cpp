// A solver that keeps energy, on bodies that put the cloth back where it does not want to be.
#include "contact/meeting.hpp"
#include "sim/diagnostics.hpp"
#include "sim/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape {
namespace {

/// A stiff free sheet a little above a body.
testing::Meeting stiffSheetOver(const Body& body, double stiffness) {
  ClothMesh mesh = testing::sheet(17);
  for (Vec3& position : mesh.positions) {
    position += Vec3(-0.5, 0.33, -0.5);
  }
  testing::Meeting meeting(buildClothModel(mesh, 0.15, MassLumping::Area, {}), {body}, "auto");
  meeting.parameters.timeStep = 1.0 / 150.0;
  meeting.parameters.stiffness = stiffness;
  meeting.parameters.damping = 0.003;
  return meeting;
}

void expectCalm(const char* what, testing::Meeting meeting) {
  const double start = energyOf(meeting.model(), meeting.parameters, meeting.state).total();
  double most = start;
  double longest = 0.0;
  meeting.run(0.6, [&](const StepReport&) {
    most = std::max(most, energyOf(meeting.model(), meeting.parameters, meeting.state).total());
    longest = std::max(longest, maxStretch(meeting.model(), meeting.state));
  });
  EXPECT_LT(most, start + 0.05) << what << " [J]";
  EXPECT_LT(longest, 0.5) << what;
}

TEST(AutoOnBodies, keepsStiffClothCalmThatIsPutBackByContact) {
  const Body ball = testing::bodyAt(SphereShape{0.3}, Vec3::Zero());
  const Body box = testing::bodyAt(BoxShape{Vec3(0.25, 0.3, 0.25)}, Vec3::Zero());
  for (const double stiffness : {500.0, 5000.0}) {
    expectCalm("ball", stiffSheetOver(ball, stiffness));
    expectCalm("box", stiffSheetOver(box, stiffness));
  }
}

}  // namespace
}  // namespace drape
