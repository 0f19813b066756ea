// Cloth that starts inside a body moves out at a bounded speed, and then nothing intersects.
#include "sim/contact/recovery/overlap.hpp"

#include "contact/contact_scene.hpp"
#include "intersection/intersections.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace drape::sim::contact {
namespace {

using testing::bodyAt;
using testing::ContactScene;

std::shared_ptr<const ClothModel> sheetAt(int n, double size, const Vec3& middle, const Vec3& turn = Vec3::Zero()) {
  ClothMesh mesh = testing::sheet(n);
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  for (Vec3& position : mesh.positions) {
    position = middle + rotation * (size * (position - Vec3(0.5, 0.0, 0.5)));
  }
  return buildClothModel(mesh, 0.15 * size * size, MassLumping::Area, {});
}

/// A tube around the y axis.
std::shared_ptr<const ClothModel> tube(int around, int along, double radius, double length) {
  ClothMesh mesh;
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      mesh.positions.emplace_back(radius * std::sin(angle), length * (static_cast<double>(j) / along - 0.5),
                                  radius * std::cos(angle));
    }
  }
  const auto at = [&](int i, int j) { return j * around + i % around; };
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return buildClothModel(mesh, 0.1, MassLumping::Area, {});
}

BodyShape meshOf(const BodyShape& shape, bool insideOut = false) {
  BodySurface surface = surfaceOf(shape);
  for (Triangle& t : surface.triangles) {
    if (insideOut) {
      std::swap(t[1], t[2]);
    }
  }
  return std::make_shared<const MeshShape>(MeshShape{surface.positions, surface.triangles, {}, 1.0, false});
}

std::size_t exactPairs(const ContactScene& scene, const Body& body) {
  BodySurface surface = surfaceOf(body.shape);
  const Pose pose = poseAt(body.motion, scene.state.time);
  for (Vec3& position : surface.positions) {
    position = pose.toWorld(position);
  }
  return intersection::intersectingPairs({scene.state.positions, scene.model().triangles},
                                         {surface.positions, surface.triangles})
      .size();
}

/// How a cloth leaves a body.
struct Escape {
  ContactReport first;    ///< of the first step
  double time = 0.0;      ///< when all of it has left [s]
  double fastest = 0.0;   ///< maximum speed of its centre until then [m/s]
  std::size_t pairs = 0;  ///< intersecting pairs afterwards
};

std::unique_ptr<ContactScene> sceneOf(const std::shared_ptr<const ClothModel>& cloth, const Body& body, double gravity,
                                      const std::string& solver = "xpbd") {
  auto scene = std::make_unique<ContactScene>(cloth, std::vector<Body>{body}, solver);
  scene->parameters.timeStep = 1.0 / 100.0;
  scene->parameters.substeps = 4;
  scene->parameters.material.stiffness = 30.0;
  scene->parameters.material.damping = 0.01;
  scene->parameters.gravity = gravity;
  return scene;
}

Vec3 middleOf(const std::vector<Vec3>& positions) {
  return std::accumulate(positions.begin(), positions.end(), Vec3(Vec3::Zero())) /
         static_cast<double>(positions.size());
}

Escape escapeOf(ContactScene& scene, const Body& body) {
  constexpr double longest = 1.5;  // [s]
  Escape escape;
  escape.first = scene.step().contact;
  Vec3 before = middleOf(scene.state.positions);
  ContactReport last = escape.first;
  while (last.overlaps > 0 && scene.state.time < longest) {
    last = scene.step().contact;
    escape.time = scene.state.time;
    const Vec3 now = middleOf(scene.state.positions);
    escape.fastest = std::max(escape.fastest, (now - before).norm() / scene.parameters.timeStep);
    before = now;
  }
  scene.run(0.1, [](const StepReport& report) { EXPECT_EQ(report.contact.overlaps, 0); });
  escape.pairs = exactPairs(scene, body);
  return escape;
}

void expectEscape(const char* what, const std::shared_ptr<const ClothModel>& cloth, const Body& body, double gravity,
                  const std::string& solver = "xpbd") {
  const auto scene = sceneOf(cloth, body, gravity, solver);
  const Escape escape = escapeOf(*scene, body);
  EXPECT_GT(escape.first.overlaps, 0) << what;
  EXPECT_GT(escape.first.deepestOverlap, 0.0) << what;
  EXPECT_LT(escape.time, 1.0) << what;
  EXPECT_EQ(escape.pairs, 0U) << what;
  if (gravity == 0.0) {
    EXPECT_LT(escape.fastest, 1.5) << what;
  }
}

TEST(Overlap, aSheetInsideABoxMovesOut) {
  const Body box = bodyAt(BoxShape{Vec3(0.3, 0.3, 0.3)}, Vec3::Zero(), Vec3(0.1, 0.2, 0.0));
  for (const double gravity : {0.0, 9.81}) {
    expectEscape("middle", sheetAt(11, 0.35, Vec3(0.01, 0.02, 0.0)), box, gravity);
    expectEscape("high", sheetAt(11, 0.4, Vec3(0.0, 0.2, 0.0)), box, gravity);
    expectEscape("upright", sheetAt(11, 0.35, Vec3(0.02, 0.0, 0.01), Vec3(0.0, 0.0, 1.57)), box, gravity);
    expectEscape("aslant", sheetAt(11, 0.3, Vec3(0.02, -0.05, 0.01), Vec3(0.7, 0.0, 0.5)), box, gravity);
  }
}

TEST(Overlap, aSheetInsideAClosedMeshMovesOutForBothOrientations) {
  const auto sheet = sheetAt(11, 0.3, Vec3(0.01, 0.02, 0.0));
  expectEscape("facing outwards", sheet, bodyAt(meshOf(SphereShape{0.3}), Vec3::Zero()), 9.81);
  expectEscape("facing inwards", sheet, bodyAt(meshOf(SphereShape{0.3}, true), Vec3::Zero()), 0.0);
}

TEST(Overlap, aSheetInsideASphereOrCapsuleMovesOut) {
  const auto sheet = sheetAt(11, 0.3, Vec3::Zero());
  expectEscape("sphere", sheet, bodyAt(SphereShape{0.3}, Vec3::Zero()), 0.0);
  expectEscape("capsule", sheet, bodyAt(CapsuleShape{0.25, 0.2}, Vec3(0.0, -0.1, 0.0)), 9.81);
}

TEST(Overlap, aSheetThroughTheMiddleOfABodyMovesOut) {
  const auto sheet = sheetAt(17, 0.9, Vec3(0.01, 0.0, 0.0));
  for (const double gravity : {0.0, 9.81}) {
    expectEscape("mesh", sheet, bodyAt(meshOf(SphereShape{0.2}), Vec3::Zero()), gravity);
    expectEscape("sphere", sheet, bodyAt(SphereShape{0.2}, Vec3::Zero()), gravity);
    expectEscape("box", sheet, bodyAt(BoxShape{Vec3(0.15, 0.1, 0.2)}, Vec3::Zero(), Vec3(0.1, 0.3, 0.2)), gravity);
    expectEscape("less than a triangle", sheet, bodyAt(meshOf(SphereShape{0.02}), Vec3::Zero()), gravity);
  }
}

TEST(Overlap, aTubeTooNarrowForItsBodyWidensWithAnySolver) {
  const Body trunk = bodyAt(meshOf(CapsuleShape{0.2, 0.3}), Vec3::Zero());
  for (const char* solver : {"xpbd", "one_iteration", "auto"}) {
    expectEscape(solver, tube(32, 16, 0.19, 0.5), trunk, 0.0, solver);
  }
  const Body aslant = bodyAt(meshOf(CapsuleShape{0.18, 0.3}), Vec3::Zero(), Vec3(0.15, 0.0, 0.0));
  expectEscape("aslant", tube(32, 16, 0.17, 0.5), aslant, 0.0);
}

TEST(Overlap, aSheetThroughAPostLeavesOverItsEnd) {
  const auto sheet = sheetAt(17, 0.9, Vec3(0.01, 0.0, 0.0));
  const BodyShape post = CapsuleShape{0.1, 0.25};
  for (const double gravity : {0.0, 9.81}) {
    expectEscape("upright", sheet, bodyAt(post, Vec3::Zero()), gravity);
    expectEscape("aslant", sheet, bodyAt(post, Vec3::Zero(), Vec3(0.4, 0.0, 0.3)), gravity);
  }
  expectEscape("mesh", sheet, bodyAt(meshOf(post), Vec3::Zero()), 9.81);
}

/// The winding number of a ring of a tube around an axis through the origin, which is rotated about x.
int windingAround(const std::vector<Vec3>& positions, int around, int ring, double turn) {
  const Eigen::Quaterniond back(Eigen::AngleAxisd(-turn, Vec3::UnitX()));
  double sum = 0.0;
  const auto count = static_cast<std::size_t>(around);
  const auto first = static_cast<std::size_t>(ring) * count;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = back * positions[first + i];
    const Vec3 b = back * positions[first + (i + 1) % count];
    sum += std::atan2(a.z() * b.x() - a.x() * b.z(), a.x() * b.x() + a.z() * b.z());
  }
  return static_cast<int>(std::lround(sum / (2.0 * std::numbers::pi)));
}

TEST(Overlap, aSleevePiercedByALimbMovesAroundIt) {
  constexpr int around = 24;
  constexpr int along = 12;
  const auto sleeve = tube(around, along, 0.07, 0.25);
  for (const double turn : {0.3, 0.5}) {  // [rad] the limb pierces the wall of the sleeve before its ends
    for (const bool round : {true, false}) {
      const BodyShape limb = CapsuleShape{0.04, 0.6};
      const Body body = bodyAt(round ? limb : meshOf(limb), Vec3::Zero(), Vec3(turn, 0.0, 0.0));
      const auto scene = sceneOf(sleeve, body, 0.0);
      const Escape escape = escapeOf(*scene, body);
      EXPECT_GT(escape.first.overlaps, 0) << turn;
      EXPECT_LT(escape.time, 1.0) << turn;
      EXPECT_EQ(escape.pairs, 0U) << turn;
      for (int ring = 0; ring <= along; ++ring) {
        EXPECT_EQ(windingAround(scene->state.positions, around, ring, turn), 1) << turn << ", ring " << ring;
      }
    }
  }
}

TEST(CommonExit, requiresThatAdjacentClothCanFollow) {
  // A sheet across a post can only leave over its ends; one that ends soon behind the post can also leave sideways.
  CapsuleSolid post({Vec3(0.0, -0.5, 0.0), Vec3(0.0, 0.5, 0.0)}, 0.1);
  const std::vector<Vec3> sideways{Vec3::UnitX()};
  for (const double size : {1.0, 0.3}) {
    const auto sheet = sheetAt(31, size, Vec3(0.05, 0.0, 0.0));
    std::vector<char> inside;
    std::vector<int> members;
    for (int v = 0; v < sheet->vertexCount(); ++v) {
      inside.push_back(static_cast<char>(post.contains(vectorAt(sheet->restPositions, v))));
      if (inside.back() != 0) {
        members.push_back(v);
      }
    }
    CommonExit exit(post, sheet->restPositions, sheet->triangles, inside);
    exit.begin(members, sideways);
    EXPECT_EQ(exit.find(0.3, true).empty(), size == 1.0) << size;
    EXPECT_EQ(exit.find(0.3, false).size(), members.size()) << size;
    EXPECT_TRUE(exit.find(0.1, false).empty()) << "too far";
    exit.begin(members, {Vec3::UnitX(), Vec3::UnitY()});
    EXPECT_EQ(exit.find(0.7, true).front().second.normal, size == 1.0 ? Vec3::UnitY() : Vec3::UnitX()) << size;
  }
}

TEST(Overlap, continuesWithTheSameBitsFromACopiedStateAndForAnyNumberOfThreads) {
  const Body ball = bodyAt(meshOf(SphereShape{0.2}), Vec3::Zero());
  const auto sheet = sheetAt(34, 0.9, Vec3(0.01, 0.0, 0.0));
  const auto first = sceneOf(sheet, ball, 9.81);
  first->run(0.05);
  const auto second = sceneOf(sheet, ball, 9.81);
  second->state = first->state;
  second->parameters.threads = 3;
  for (int i = 0; i < 10; ++i) {
    EXPECT_GT(first->step().contact.overlaps, 0);
    second->step();
    ASSERT_EQ(stateHash(first->state), stateHash(second->state)) << i;
  }
}

TEST(Overlap, doesNotReportPinsInsideABody) {
  // Pinned at one corner, which is inside; its neighbours are not.
  const auto sheet = withPins(*sheetAt(5, 0.4, Vec3(0.2, 0.0, 0.2)), [] {
    std::vector<bool> pinned(25, false);
    pinned[0] = true;
    return pinned;
  }());
  for (const BodyShape& shape : {BodyShape(SphereShape{0.05}), BodyShape(BoxShape{Vec3::Constant(0.05)})}) {
    const Body knob = bodyAt(shape, Vec3::Zero());
    const auto scene = sceneOf(sheet, knob, 9.81);
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(scene->step().contact.overlaps, 0);
    }
    EXPECT_EQ(scene->state.positions[0], sheet->restPositions[0]);
  }
}

TEST(Overlap, anOpenMeshHasNoInside) {
  // A box without a lid: cloth in it may stay.
  BodySurface box = surfaceOf(BoxShape{Vec3::Constant(0.3)});
  box.triangles.resize(10);
  const Body openBox =
      bodyAt(std::make_shared<const MeshShape>(MeshShape{box.positions, box.triangles, {}, 1.0, false}), Vec3::Zero());
  const auto scene = sceneOf(sheetAt(9, 0.3, Vec3::Zero()), openBox, 0.0);
  EXPECT_EQ(scene->step().contact.overlaps, 0);
  EXPECT_EQ(scene->state.positions, scene->model().restPositions);
}

/// The mesh of a shape at rest.
struct Still {
  explicit Still(const BodySurface& surface)
      : mesh(MeshShape{surface.positions, surface.triangles, {}, 1.0, false}),
        inStep{mesh, mesh.shape.positions, mesh.shape.positions, false} {}
  SearchableMesh mesh;
  MeshInStep inStep;
};

TEST(MeshSolid, classifiesPointsAlsoInLineWithItsVerticesAndEdges) {
  const Still box(surfaceOf(BoxShape{Vec3(0.25, 0.5, 0.75)}));
  MeshSolid solid(box.inStep);
  testing::RandomVectors random(4);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    Vec3 point = random.next(1.0);
    if (i % 2 == 0) {
      point = (8.0 * point).array().round() / 8.0;  // in line with corners, edges and diagonals
    }
    const Eigen::Array3d depth = Vec3(0.25, 0.5, 0.75).array() - point.array().abs();
    if ((depth == 0.0).any()) {
      continue;  // on a face, or in line with one
    }
    inside += (depth > 0.0).all() ? 1 : 0;
    EXPECT_EQ(solid.contains(point), (depth > 0.0).all()) << point.transpose();
  }
  EXPECT_GT(inside, 100);
}

TEST(MeshSolid, countsARayThroughAnEdgeOrACornerOnce) {
  const Still box(surfaceOf(BoxShape{Vec3::Constant(0.5)}));
  std::vector<Crossing> crossings;
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(-1, 1, -1)}) {
    crossingsAlong(box.inStep, Vec3::Zero(), direction.normalized(), crossings);
    EXPECT_EQ(windingOf(crossings), 1) << direction.transpose();
    crossingsAlong(box.inStep, 3.0 * direction, -direction.normalized(), crossings);
    EXPECT_EQ(windingOf(crossings), 0) << direction.transpose();
    EXPECT_GE(crossings.size(), 2U);
  }
}

TEST(Solids, returnExitsOnTheirSurface) {
  const Still ball(surfaceOf(SphereShape{0.5}));
  MeshSolid mesh(ball.inStep);
  CapsuleSolid round({Vec3(0.0, -0.1, 0.0), Vec3(0.0, 0.1, 0.0)}, 0.4);
  testing::RandomVectors random(9);
  for (Solid* solid : {static_cast<Solid*>(&mesh), static_cast<Solid*>(&round)}) {
    for (int i = 0; i < 100; ++i) {
      const Vec3 point = random.next(0.25);
      const Vec3 direction = random.next(1.0).normalized();
      ASSERT_TRUE(solid->contains(point));
      const NearPoint nearest = solid->nearestExit(point);
      const NearPoint along = solid->exitAlong(point, direction);
      EXPECT_LE(nearest.gap, 0.0);
      EXPECT_LE(along.gap, nearest.gap + 1e-9) << "no way out is shorter";
      for (const NearPoint& exit : {nearest, along}) {
        EXPECT_LT((point - exit.gap * exit.normal - exit.endPoint).norm(), 1e-9);
        EXPECT_TRUE(solid->contains(exit.endPoint - 1e-6 * exit.normal));
        EXPECT_FALSE(solid->contains(exit.endPoint + 1e-6 * exit.normal));
      }
      const auto passage = solid->passageAlong(point - 3.0 * direction, direction);
      ASSERT_TRUE(passage.has_value());
      EXPECT_LT((passage->exit.endPoint - along.endPoint).norm(), 1e-9);
      EXPECT_TRUE(solid->contains(point + (passage->enter - 3.0 + 1e-6) * direction));
      EXPECT_FALSE(solid->contains(point + (passage->enter - 3.0 - 1e-6) * direction));
      EXPECT_FALSE(solid->passageAlong(point + 3.0 * direction, direction).has_value());
      const NearPoint outside = solid->nearestSurface(along.endPoint + 0.1 * along.normal);
      EXPECT_GT(outside.gap, 0.0);
      EXPECT_FALSE(solid->contains(outside.endPoint + 1e-6 * outside.normal));
    }
  }
}

}  // namespace
}  // namespace drape::sim::contact
