#include "sim/contact/constraints/mesh_search.hpp"

#include "contact/contact_scene.hpp"
#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/contact/separating_planes/separating_plane_filter.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>

namespace drape::sim::contact {
namespace {

using testing::RandomVectors;

/// Ground with hills and hollows, 1 m x 1 m.
double hillHeight(const Vec3& at) {
  return 0.08 * std::sin(13.0 * at.x()) * std::cos(11.0 * at.z());
}

MeshShape hills(int n) {
  const ClothMesh sheet = testing::sheet(n);
  MeshShape shape{sheet.positions, sheet.triangles, {}, 1.0, false};
  for (Vec3& position : shape.positions) {
    position.y() = hillHeight(position);
  }
  return shape;
}

MeshShape ballShape() {
  const BodySurface surface = surfaceOf(SphereShape{0.3});
  MeshShape shape{surface.positions, surface.triangles, {}, 1.0, false};
  for (Vec3& position : shape.positions) {
    position += Vec3(0.5, -0.29, 0.5);
  }
  return shape;
}

MeshShape box() {
  const BodySurface surface = surfaceOf(BoxShape{Vec3(0.2, 0.1, 0.3)});
  MeshShape shape{surface.positions, surface.triangles, {}, 1.0, false};
  for (Vec3& position : shape.positions) {
    position += Vec3(0.5, -0.09, 0.5);
  }
  return shape;
}

/// A sheet close above a mesh without intersections, and its search.
struct Search {
  Search(MeshShape shape, int n, unsigned seed) : random(seed) {
    const bool hilly = shape.positions.size() < 500 && shape.positions.size() > 8;
    ClothMesh sheet = testing::sheet(n);
    for (Vec3& position : sheet.positions) {
      position.y() = hilly ? hillHeight(position) : 0.0;
      position += random.next(0.003);
    }
    body.surface.thickness = 0.002;
    body.shape = std::make_shared<const MeshShape>(shape);
    while (testing::intersectingPairs(*buildClothModel(sheet, 1.0, MassLumping::Area, {}), sheet.positions,
                                      {shape.positions, shape.triangles}, Pose()) > 0) {
      for (Vec3& position : sheet.positions) {
        position.y() += 0.002;
      }
    }
    model = buildClothModel(sheet, 1.0, MassLumping::Area, {});
    start = sheet.positions;
    mesh = std::make_unique<SearchableMesh>(std::move(shape));
    before = mesh->shape.positions;
    after = before;
    step.body = &body;
  }

  /// Searches for a random motion of every vertex.
  /// @param carry motion of a point with the mesh
  void run(
      const Vec3& way, double spread, const std::function<Vec3(const Vec3&)>& carry = [](const Vec3& p) { return p; }) {
    predicted.clear();
    displacementBounds.clear();
    double move = 0.0;
    for (std::size_t v = 0; v < before.size(); ++v) {
      move = std::max(move, (after[v] - before[v]).norm());
    }
    for (const Vec3& position : start) {
      predicted.emplace_back(carry(position) + way + random.next(spread));
      displacementBounds.push_back((predicted.back() - position).norm() + 2.0 * offsets.contactOffset + move);
    }
    const std::vector<OwnedFeatures> owned = ownedFeatures(model->triangles, model->restPositions.size());
    const ClothClusters clusters(*model);
    candidates.clear();
    Workers workers;
    const ConstraintBuilder builder(step, 0, offsets);
    const MeshInStep inStep{*mesh, before, after, false};
    const std::vector<double> inverseMass(start.size(), 1.0);
    const ClothInBody cloth{start, predicted, displacementBounds, model->triangles, owned, inverseMass};
    meshSearch.findVertexContacts(builder, inStep, cloth, clusters, workers, 1, candidates);
    meshSearch.findSharpFeatureContacts(builder, inStep, cloth, clusters, workers, 1, candidates);
    std::vector<double> displacements;
    for (std::size_t v = 0; v < start.size(); ++v) {
      displacements.push_back((predicted[v] - start[v]).norm());
    }
    EXPECT_FALSE(meshSearch.findPlanes(builder, inStep, cloth, clusters, displacements, workers, 1, candidates));
    planesAtFirst = candidates.planes.size();
    // The vertices may be moved anywhere below, so all planes are needed.
    candidates.planes.clear();
    meshSearch.requestAllPlanes();
    EXPECT_FALSE(meshSearch.findPlanes(builder, inStep, cloth, clusters, displacements, workers, 1, candidates));
  }

  /// Moves every vertex in a random direction, and applies planes and displacement bounds.
  /// @return number of infeasible vertices
  int moveAnywhere(double spread, std::vector<Vec3>& positions) {
    positions = predicted;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      positions[v] += random.next(spread * displacementBounds[v]);
    }
    const std::vector<double> inverseMass(positions.size(), 1.0);
    const MeshInStep inStep{*mesh, before, after, false};
    const auto startOf = [&](int, int v) { return start[v]; };
    const auto carriedOf = [&](int, int v) { return Vec3(start[v] + meshSearch.bodyDisplacementAt(inStep, v)); };
    return SeparatingPlaneFilter().apply(candidates.planes, inverseMass, displacementBounds, 1, {startOf, carriedOf},
                                         start, positions);
  }

  RandomVectors random;
  Body body;
  std::shared_ptr<const ClothModel> model;
  std::vector<Vec3> start, predicted;
  std::vector<double> displacementBounds;
  std::unique_ptr<SearchableMesh> mesh;
  std::vector<Vec3> before, after;
  BodyStep step;
  ContactOffsets offsets{0.004, 0.0024, 0.0004, 0.002};
  MeshSearch meshSearch;
  Candidates candidates;
  std::size_t planesAtFirst = 0;  // before planes of all triangles were requested
};

TEST(MeshSearch, preventsAnyPathIntoARigidMesh) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    for (const MeshShape& shape : {hills(21), ballShape(), box()}) {
      Search search(shape, 14, seed);
      search.run(Vec3(0.01 * seed, -0.03, 0.0), 0.02);
      EXPECT_GT(search.candidates.planes.size(), 100U);
      std::vector<Vec3> positions;
      EXPECT_EQ(search.moveAnywhere(1.0, positions), 0);
      for (std::size_t v = 0; v < positions.size(); ++v) {
        EXPECT_LE((positions[v] - search.start[v]).norm(), search.displacementBounds[v] + 1e-9);
      }
      EXPECT_EQ(testing::intersectingPairs(*search.model, positions, {search.after, shape.triangles}, Pose()), 0)
          << "seed " << seed;
    }
  }
}

TEST(MeshSearch, preventsAnyPathIntoADeformingMesh) {
  int infeasible = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    MeshShape shape = hills(21);
    shape.frames = {shape.positions, shape.positions};
    Search search(shape, 14, seed);
    const auto carry = [&](const Vec3& at) -> Vec3 {
      return at + Vec3(0.01 * std::sin(5.0 * at.z()), 0.01 * std::sin(8.0 * at.x() + seed), 0.0);
    };
    std::transform(search.before.begin(), search.before.end(), search.after.begin(), carry);
    search.mesh->follow(search.before, search.after);
    search.run(Vec3::Zero(), 0.001, carry);
    std::vector<Vec3> positions;
    const int here = search.moveAnywhere(0.3, positions);
    infeasible += here;
    EXPECT_TRUE(here > 0 ||
                testing::intersectingPairs(*search.model, positions, {search.after, shape.triangles}, Pose()) == 0)
        << "seed " << seed;
  }
  EXPECT_LE(infeasible, 2);  // of 1176: planes of different triangles can exclude all feasible positions
}

TEST(MeshSearch, contactsEachVertexAtTheClosestPointOfTheMesh) {
  int vertexContacts = 0;
  for (const MeshShape& shape : {hills(21), ballShape(), box()}) {
    Search search(shape, 14, 3);
    search.run(Vec3(0.0, -0.01, 0.0), 0.0);
    for (const ContactConstraint& contact : search.candidates.contacts) {
      const auto largest = std::max_element(contact.weights.begin(), contact.weights.end());
      if (*largest < 1.0) {
        continue;
      }
      const Vec3& point = search.start[contact.vertices[largest - contact.weights.begin()]];
      double smallest = 1e9;
      for (const Triangle& triangle : shape.triangles) {
        const Corners corners = cornersOf(shape.positions, triangle);
        smallest = std::min(smallest, (pointAt(corners, nearestOnTriangle(point, corners)) - point).norm());
      }
      EXPECT_NEAR(contact.normal.dot(point) - contact.height, smallest, 1e-12);
      ++vertexContacts;
    }
  }
  EXPECT_GT(vertexContacts, 40);
}

TEST(MeshSearch, needsAtMostOnePlanePerTriangleOverAConvexMesh) {
  for (const MeshShape& shape : {ballShape(), box()}) {
    Search search(shape, 14, 5);
    search.run(Vec3(0.0, -0.01, 0.0), 0.0);
    EXPECT_LE(search.candidates.planes.size(), 3 * search.model->triangles.size());
  }
}

TEST(MeshSearch, skipsTrianglesThatStayAwayUntilTheyAreRequested) {
  Search still(ballShape(), 14, 5);
  still.run(Vec3::Zero(), 0.0);
  EXPECT_LT(still.planesAtFirst, still.candidates.planes.size());
  Search moving(ballShape(), 14, 5);
  moving.run(Vec3(0.0, -0.01, 0.0), 0.0);
  EXPECT_GT(moving.planesAtFirst, still.planesAtFirst);
}

/// The contacts as numbers, in order.
std::vector<double> numbersOf(const Candidates& candidates) {
  std::vector<double> numbers;
  for (const ContactConstraint& contact : candidates.contacts) {
    numbers.insert(numbers.end(), contact.vertices.begin(), contact.vertices.end());
    numbers.insert(numbers.end(), contact.weights.begin(), contact.weights.end());
    numbers.insert(numbers.end(), contact.normal.begin(), contact.normal.end());
    numbers.insert(numbers.end(), {contact.height, contact.offset});
  }
  return numbers;
}

TEST(MeshSearch, findsTheSameContactsWithAndWithoutCachedData) {
  for (const MeshShape& shape : {hills(21), ballShape(), box()}) {
    Search cached(shape, 14, 3);
    RandomVectors random(8);
    std::size_t contacts = 0;
    for (int i = 0; i < 24; ++i) {
      // Every third search starts from the same positions as the one before, as in a contact substep of `auto`.
      const double speed = i < 12 ? 0.0001 : 0.0004;
      for (Vec3& position : cached.start) {
        position += i % 3 == 0 ? Vec3(0.0, 0.0, 0.0) : Vec3(Vec3(0.0, speed, 0.0) + random.next(speed));
      }
      Search fresh(shape, 14, 3);
      fresh.start = cached.start;
      fresh.random = cached.random;
      const Vec3 way(0.0, i < 12 ? -0.0001 : -0.01, 0.0);
      cached.run(way, speed);
      fresh.run(way, speed);
      EXPECT_EQ(numbersOf(cached.candidates), numbersOf(fresh.candidates)) << "step " << i;
      contacts += fresh.candidates.contacts.size();
    }
    EXPECT_GT(contacts, 20U);
  }
}

TEST(MeshSearch, findsTheSameContactsAfterAListOnADeformingMesh) {
  MeshShape shape = hills(21);
  shape.frames = {shape.positions, shape.positions};
  Search cached(shape, 14, 3);
  const auto moveMesh = [](Search& search, double phase) {
    for (std::size_t v = 0; v < search.before.size(); ++v) {
      const Vec3& rest = search.mesh->shape.positions[v];
      search.before[v] = rest + Vec3(0.0, 0.002 * std::sin(8.0 * rest.x() + phase), 0.0);
      search.after[v] = rest + Vec3(0.0, 0.002 * std::sin(8.0 * rest.x() + phase + 0.3), 0.0);
    }
    search.mesh->follow(search.before, search.after);
  };
  for (Vec3& position : cached.start) {
    position.y() += 0.002;  // so that the mesh does not pierce it
  }
  std::size_t contacts = 0;
  for (int i = 0; i < 12; ++i) {
    // In every second step the cloth starts where it was, but the mesh does not.
    for (Vec3& position : cached.start) {
      position += i % 2 == 0 ? Vec3(0.0, 0.0, 0.0) : cached.random.next(0.0005);
    }
    moveMesh(cached, 2.0 * i);
    cached.offsets.listMargin = 0.4 * cached.offsets.contactOffset;
    cached.run(Vec3(0.0, -0.001, 0.0), 0.0005);
    Search fresh(shape, 14, 3);
    moveMesh(fresh, 2.0 * i);
    fresh.start = cached.start;
    fresh.random = cached.random;
    cached.offsets.listMargin = 0.0;
    cached.run(Vec3(0.0, -0.02, 0.0), 0.0005);
    fresh.run(Vec3(0.0, -0.02, 0.0), 0.0005);
    EXPECT_EQ(numbersOf(cached.candidates), numbersOf(fresh.candidates)) << "step " << i;
    contacts += fresh.candidates.contacts.size();
  }
  EXPECT_GT(contacts, 20U);
}

TEST(MeshTree, hasEveryTriangleInOneLeafAndFindsTheLeavesInABox) {
  const MeshShape shape = hills(12);
  const MeshTree tree(shape.positions, shape.triangles, 4);
  std::vector<int> seen(shape.triangles.size(), 0);
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    EXPECT_LE(tree.leaf(leaf).size(), 4U);
    for (const int t : tree.leaf(leaf)) {
      ++seen[t];
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
  RandomVectors random(7);
  for (int i = 0; i < 50; ++i) {
    const Vec3 corner = random.next(1.0);
    const Eigen::AlignedBox3d box(corner, corner + Vec3::Constant(0.3));
    std::vector<std::size_t> expected;
    for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
      if (tree.leafBox(leaf).intersects(box)) {
        expected.push_back(leaf);
      }
    }
    std::vector<std::size_t> found;
    tree.forEachLeafIn(box, [&](std::size_t leaf) { found.push_back(leaf); });
    EXPECT_EQ(found, expected);
  }
}

TEST(MeshTree, findsLaterLeavesOutsideTheSubtreesThatAreLeftOut) {
  const MeshShape shape = hills(12);
  const MeshTree tree(shape.positions, shape.triangles, 4);
  std::vector<int> sides;  // of each leaf: 0 or 1; -1: neither
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    const double x = tree.leafBox(leaf).center().x();
    sides.push_back(std::abs(x) < 0.1 ? -1 : x < 0.0 ? 0 : 1);
  }
  const std::vector<int> ofNodes = tree.commonValues(sides);
  EXPECT_EQ(ofNodes[0], -1);
  std::size_t found = 0;
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    std::vector<std::size_t> expected;
    for (std::size_t other = leaf; other < tree.leafCount(); ++other) {
      const bool isLeftOut = sides[leaf] >= 0 && sides[other] == sides[leaf];
      if (!isLeftOut && tree.leafBox(other).intersects(tree.leafBox(leaf))) {
        expected.push_back(other);
      }
    }
    const auto isOnSameSide = [&](std::size_t node) { return sides[leaf] >= 0 && ofNodes[node] == sides[leaf]; };
    std::vector<std::size_t> visited;
    tree.forEachLeafFrom(leaf, isOnSameSide, [&](std::size_t other) { visited.push_back(other); });
    EXPECT_EQ(visited, expected) << leaf;
    found += visited.size();
  }
  EXPECT_GT(found, tree.leafCount() / 4);
}

TEST(ClothClusters, containEveryTriangleAndEveryVertexOnceForAnyDivision) {
  const auto model = testing::pinnedSheet(13);
  const ClothClusters clusters(*model);
  std::vector<int> triangles(model->triangles.size(), 0);
  std::vector<int> vertices(model->restPositions.size(), 0);
  const auto count = static_cast<int>(triangles.size());
  for (int begin = 0; begin < count; begin += 37) {
    const auto [first, last] = clusters.clustersWithin(begin, std::min(begin + 37, count));
    for (std::size_t c = first; c < last; ++c) {
      for (const int t : clusters.triangles(c)) {
        ++triangles[t];
      }
      for (const int v : clusters.ownVertices(c)) {
        ++vertices[v];
      }
    }
  }
  EXPECT_EQ(triangles, std::vector<int>(triangles.size(), 1));
  EXPECT_EQ(vertices, std::vector<int>(vertices.size(), 1));
}

}  // namespace
}  // namespace drape::sim::contact
