#include "contact/contact_scene.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <numeric>

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

/// Small sheets on a large one whose vertices are all pinned: contacts of each are solved by the thread that owns it.
TEST(SelfContactThreads, giveTheSameBitsForSheetsThatTouchCommonPinnedVertices) {
  const Eigen::Quaterniond aside(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  ClothMesh mesh;
  testing::addSheet(48, 2.0, Vec3::Zero(), Eigen::Quaterniond::Identity(), mesh);
  std::vector<int> pins(mesh.positions.size());
  std::iota(pins.begin(), pins.end(), 0);
  for (int i = 0; i < 9; ++i) {
    const Vec3 middle(0.11 * (i % 3), 1.0, 0.11 * (i / 3));  // at rest far above
    testing::addSheet(6, 0.1, middle, aside, mesh);
  }
  const auto model = buildClothModel(mesh, 0.5, MassLumping::Area, pins);
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 4}) {
    ContactScene scene(model, {}, "auto");
    scene.parameters.threads = threads;
    scene.parameters.timeStep = 1.0 / 150.0;
    scene.parameters.material.stiffness = 50.0;
    scene.parameters.contact.self = contact::SelfCollision::Exact;
    for (std::size_t v = pins.size(); v < scene.state.positions.size(); ++v) {
      scene.state.positions[v].y() += contact::ContactParameters{}.thickness - 1.0;
    }
    int contacts = 0;
    scene.run(0.05, [&](const StepReport& report) { contacts += report.contact.selfContacts; });
    EXPECT_GT(contacts, 50);
    EXPECT_EQ(scene.pairsWithItself(), 0U);
    hashes.push_back(stateHash(scene.state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace drape::sim
