#include "sim/contact/constraints/sharp_feature_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>
#include <tuple>

namespace drape::sim::contact {
namespace {

using testing::RandomVectors;

constexpr ContactOffsets offsets{0.004, 0.0024, 0.0004, 0.002};
constexpr double close = 0.0032;
constexpr double near = 0.008;

/// Separate triangles at random positions close to a mesh.
struct Cloth {
  std::vector<Vec3> start, predicted;
  std::vector<double> displacementBounds, inverseMass;
  std::vector<Triangle> triangles;
  std::vector<OwnedFeatures> owned;
  std::vector<NearestMeshPoint> nearest;

  [[nodiscard]] ClothInBody inBody() const {
    return {start, predicted, displacementBounds, triangles, owned, inverseMass};
  }
};

Cloth scatteredOver(const SearchableMesh& mesh, double size, unsigned seed) {
  RandomVectors random(seed);
  Cloth cloth;
  for (int i = 0; i < 400; ++i) {
    const auto& under = mesh.shape.triangles[static_cast<std::size_t>(7 * i) % mesh.shape.triangles.size()];
    const Vec3& at = vectorAt(mesh.shape.positions, under[static_cast<std::size_t>(i) % 3]);
    const Vec3 middle = at + 0.003 * faceNormal(cornersOf(mesh.shape.positions, under)) + random.next(0.3 * size);
    for (int k = 0; k < 3; ++k) {
      cloth.start.emplace_back(middle + random.next(size));
    }
    cloth.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  cloth.predicted.assign(cloth.start.size(), Vec3::Zero());
  for (std::size_t v = 0; v < cloth.start.size(); ++v) {
    cloth.predicted[v] = cloth.start[v] + random.next(0.02);
  }
  cloth.displacementBounds.assign(cloth.start.size(), 0.05);
  cloth.inverseMass.assign(cloth.start.size(), 1.0);
  cloth.owned.assign(cloth.triangles.size(), {{true, true, true}, {true, true, true}});
  cloth.nearest.resize(cloth.start.size());
  return cloth;
}

/// Tests every pair.
class AllPairs {
 public:
  AllPairs(const ConstraintBuilder& builder, const SearchableMesh& mesh, const Cloth& cloth, Candidates& found)
      : builder_(builder), mesh_(mesh), cloth_(cloth), inBody_(cloth.inBody()), found_(found) {}

  void search(std::size_t t) {
    const Corners corners = cornersOf(cloth_.start, cloth_.triangles[t]);
    for (std::size_t b = 0; b < mesh_.shape.triangles.size(); ++b) {
      const Corners at = cornersOf(mesh_.shape.positions, mesh_.shape.triangles[b]);
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh_.owned[b].corners[k]) {
          const Vec3 weights = nearestOnTriangle(at[k], corners);
          contact(t, isInside(weights), corners, weights, at, onCorner(k));
        }
        for (std::size_t side = 0; side < 3 && mesh_.owned[b].sides[k] && mesh_.sharp[b][k]; ++side) {
          const SegmentPair pair =
              nearestOfSegments({corners[side], corners[(side + 1) % 3]}, {at[k], at[(k + 1) % 3]});
          contact(t, isInside(pair.first) && isInside(pair.second), corners, onSide(side, pair.first), at,
                  onSide(k, pair.second));
        }
      }
    }
  }

 private:
  void contact(std::size_t t, bool inside, const Corners& corners, const Vec3& weights, const Corners& at,
               const Vec3& bodyWeights) {
    const Vec3 point = pointAt(at, bodyWeights);
    const Vec3 offset = pointAt(corners, weights) - point;
    const double gap = offset.norm();
    if (inside && gap < close && gap > 0.0) {
      builder_.addContact(inBody_, t, weights, {gap, offset / gap, point, point}, offsets.edgeOffset, found_);
    }
  }

  const ConstraintBuilder& builder_;
  const SearchableMesh& mesh_;
  const Cloth& cloth_;
  ClothInBody inBody_;
  Candidates& found_;
};

/// The contacts in a canonical order.
std::vector<std::tuple<int, double, double, double, double>> sorted(const Candidates& found) {
  std::vector<std::tuple<int, double, double, double, double>> all;
  for (const ContactConstraint& contact : found.contacts) {
    all.emplace_back(contact.vertices[0], contact.weights[0], contact.weights[1], contact.height, contact.offset);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// All leaves of a mesh's tree.
struct Leaves {
  explicit Leaves(const MeshTree& tree) : indices(tree.leafCount()) {
    std::iota(indices.begin(), indices.end(), 0);
    for (std::size_t leaf = 0; leaf < indices.size(); ++leaf) {
      boxes.add(tree.leafBox(leaf));
    }
  }

  std::vector<int> indices;
  BoxList boxes;
};

TEST(SharpFeatureSearch, findsTheSameContactsAsATestOfEveryPair) {
  const BodySurface ball = surfaceOf(SphereShape{0.05});
  const BodySurface box = surfaceOf(BoxShape{Vec3(0.02, 0.01, 0.03)});
  for (const BodySurface& surface : {ball, box}) {
    for (const double size : {0.004, 0.03}) {
      const SearchableMesh mesh({surface.positions, surface.triangles, {}, 1.0, false});
      const Cloth cloth = scatteredOver(mesh, size, 5);
      const ClothInBody inBody = cloth.inBody();
      Body body;
      const BodyStep step{&body, {}, {}, mesh.shape.positions, mesh.shape.positions, {}};
      const ConstraintBuilder builder(step, 0, offsets);
      const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions, false};
      const Leaves leaves(mesh.tree);
      Candidates found, expected;
      SharpFeatureSearch sharp(builder, inStep, inBody, cloth.nearest, close, near, found);
      AllPairs all(builder, mesh, cloth, expected);
      for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
        Vec3 outwards = t % 2 == 0 ? Vec3(Vec3::Zero()) : Vec3(Vec3::UnitX());  // any initial direction
        NearbyFeatures memory;
        sharp.search(static_cast<int>(t), leaves.indices, leaves.boxes, 1.0, outwards, memory);
        all.search(t);
      }
      EXPECT_GT(expected.contacts.size(), 50U);
      EXPECT_EQ(sorted(found), sorted(expected));
    }
  }
}

TEST(SharpFeatureSearch, findsTheSameContactsFromRememberedFeaturesWhileTheClothMovesSlowly) {
  const BodySurface ball = surfaceOf(SphereShape{0.05});
  const SearchableMesh mesh({ball.positions, ball.triangles, {}, 1.0, false});
  const Leaves leaves(mesh.tree);
  Cloth cloth = scatteredOver(mesh, 0.03, 5);
  RandomVectors random(2);
  Body body;
  const BodyStep step{&body, {}, {}, mesh.shape.positions, mesh.shape.positions, {}};
  const ConstraintBuilder builder(step, 0, offsets);
  const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions, false};
  std::vector<NearbyFeatures> memory(cloth.triangles.size());
  std::size_t contacts = 0;
  std::size_t remembered = 0;
  for (int i = 0; i < 20; ++i) {
    for (std::size_t v = 0; v < cloth.start.size(); ++v) {
      cloth.start[v] += random.next(0.00005);
      cloth.predicted[v] = cloth.start[v] + random.next(0.0001);
    }
    const ClothInBody inBody = cloth.inBody();
    Candidates found, expected;
    SharpFeatureSearch sharp(builder, inStep, inBody, cloth.nearest, close, near, found);
    AllPairs all(builder, mesh, cloth, expected);
    for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
      const Vec3 before = memory[t].at[0];
      Vec3 outwards = Vec3::Zero();
      sharp.search(static_cast<int>(t), leaves.indices, leaves.boxes, 0.00019, outwards, memory[t]);
      all.search(t);
      remembered += before == memory[t].at[0] ? 1 : 0;
    }
    contacts += expected.contacts.size();
    EXPECT_EQ(sorted(found), sorted(expected)) << "step " << i;
  }
  EXPECT_GT(contacts, 1000U);
  EXPECT_GT(remembered, 10 * cloth.triangles.size());
}

}  // namespace
}  // namespace drape::sim::contact
