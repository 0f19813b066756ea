#include "contact/contact_scene.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using testing::bodyAt;
using testing::ContactScene;

/// A ball that swells and shrinks.
std::shared_ptr<const contact::MeshShape> swellingBall() {
  const contact::BodySurface ball = contact::surfaceOf(contact::SphereShape{0.3});
  contact::MeshShape mesh{ball.positions, ball.triangles, {ball.positions, ball.positions}, 0.02, true};
  for (Vec3& position : mesh.frames[1]) {
    position *= 1.03;
  }
  return std::make_shared<const contact::MeshShape>(std::move(mesh));
}

/// Enough triangles for several threads to get some.
TEST(BodyContactThreads, giveTheSameBitsOnMeshesAndOnWhatIsRound) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 4}) {
    ContactScene scene(
        testing::freeSheet(34, 1.0, Vec3(0.0, 0.305, 0.0)),
        {bodyAt(swellingBall(), Vec3::Zero()), bodyAt(contact::BoxShape{Vec3(0.1, 0.3, 0.1)}, Vec3(0.4, 0.0, 0.3)),
         bodyAt(contact::SphereShape{0.1}, Vec3(-0.4, 0.2, 0.3))});
    scene.parameters.threads = threads;
    scene.parameters.timeStep = 1.0 / 150.0;
    int contacts = 0;
    scene.run(0.03, [&](const StepReport& report) { contacts += report.contact.bodyContacts; });
    EXPECT_GT(contacts, 50);
    hashes.push_back(stateHash(scene.state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(BodyContactThreads, giveTheSameBitsWhenASolverResolvesTheContacts) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 4}) {
    ContactScene scene(testing::freeSheet(50, 1.0, Vec3(0.0, 0.304, 0.0)),
                       {bodyAt(contact::BoxShape{Vec3(0.1, 0.3, 0.1)}, Vec3::Zero()),
                        bodyAt(contact::SphereShape{0.1}, Vec3(-0.4, 0.2, 0.3))},
                       "auto");
    scene.parameters.threads = threads;
    scene.parameters.timeStep = 1.0 / 150.0;
    scene.parameters.material.stiffness = 500.0;
    scene.parameters.contact.self = contact::SelfCollision::Hash;
    int contacts = 0;
    scene.run(0.05, [&](const StepReport& report) { contacts += report.contact.bodyContacts; });
    EXPECT_GT(contacts, 50);
    hashes.push_back(stateHash(scene.state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace drape::sim
