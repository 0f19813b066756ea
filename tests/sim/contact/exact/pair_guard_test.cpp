#include "sim/contact/exact/pair_guard.hpp"

#include "contact/exact/common_end.hpp"
#include "contact/exact/crossings_at_rest.hpp"
#include "intersection/intersections.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <random>

namespace drape::sim::contact {
namespace {

/// Separate triangles at random places, with random sizes down to slivers, of which some lie in one plane.
ClothMesh triangleSoup(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  ClothMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Vec3 centre(place(random), place(random), place(random));
    const double size = 0.02 * std::pow(10.0, 1.5 * place(random));
    const bool flat = t % 3 == 0;
    for (int k = 0; k < 3; ++k) {
      const Vec3 offset(place(random), flat ? 0.0 : place(random), t % 5 == 0 ? 1e-6 * place(random) : place(random));
      mesh.positions.push_back(centre + size * offset);
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

TEST(PairGuard, letsNoTrianglesOfARandomSoupIntersect) {
  int moved = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const auto model = buildClothModel(triangleSoup(30, random), 1.0, MassLumping::Uniform, {});
    const std::vector<Vec3>& start = model->restPositions;
    if (!intersection::intersectingPairs({start, model->triangles}).empty()) {
      continue;
    }
    std::normal_distribution<double> step(0.0, 0.3);
    std::vector<Vec3> end = start;
    for (Vec3& position : end) {
      position += Vec3(step(random), step(random), step(random));
    }
    const std::vector<Vec3> wanted = end;
    PairSearch search;
    PairGuard guard;
    Workers workers;
    const std::vector<double> inverseMass(start.size(), 1.0);
    const PairGuard::Result result = guard.apply({.model = *model,
                                                  .inverseMass = inverseMass,
                                                  .start = start,
                                                  .fallback = start,
                                                  .bodyPlanes = {},
                                                  .entangled = {},
                                                  .patches = nullptr,
                                                  .thickness = 0.004},
                                                 search, workers, end);
    EXPECT_EQ(result.crossings, 0) << seed;
    EXPECT_EQ(result.touching, 0) << seed;
    EXPECT_TRUE(intersection::intersectingPairs({end, model->triangles}).empty()) << seed;
    moved += end != wanted ? 1 : 0;
  }
  EXPECT_GT(moved, 10);
}

/// Triangles on top of each other, 2 mm apart.
ClothMesh triangleStack(int count) {
  ClothMesh mesh;
  for (int t = 0; t < count; ++t) {
    const double height = 0.002 * t;
    mesh.positions.insert(mesh.positions.end(), {{0.0, height, 0.0}, {0.1, height, 0.0}, {0.0, height, 0.1}});
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

TEST(PairGuard, leavesOnlyPairsOfPinsThatAreDrivenIntoTheCloth) {
  constexpr int count = 40;
  const auto model = buildClothModel(triangleStack(count), 1.0, MassLumping::Uniform, {});
  const std::vector<Vec3>& start = model->restPositions;
  std::vector<double> inverseMass(start.size(), 1.0);
  std::vector<Vec3> end = start;
  for (std::size_t v = start.size() - 3; v < start.size(); ++v) {
    inverseMass[v] = 0.0;
    inverseMass[v - start.size() + 3] = 0.0;
    end[v].y() = 0.004;  // the layers between need more
  }
  const std::vector<Vec3> fallback = end;
  PairSearch search;
  PairGuard guard;
  Workers workers;
  const PairGuard::Result result = guard.apply({.model = *model,
                                                .inverseMass = inverseMass,
                                                .start = start,
                                                .fallback = fallback,
                                                .bodyPlanes = {},
                                                .entangled = {},
                                                .patches = nullptr,
                                                .thickness = 0.004},
                                               search, workers, end);
  EXPECT_GT(result.crossings, 0);
  for (const auto& [first, second] : intersection::intersectingPairs({end, model->triangles})) {
    EXPECT_TRUE(first == 0 || first == count - 1 || second == 0 || second == count - 1) << first << ", " << second;
  }
}

TEST(PairSearch, listsAllPairsWithinReachOnTheWholeWay) {
  std::mt19937 random(7);
  const auto model = buildClothModel(triangleSoup(90, random), 1.0, MassLumping::Uniform, {});
  const std::vector<Vec3>& start = model->restPositions;
  std::normal_distribution<double> step(0.0, 0.05);
  std::vector<Vec3> end = start;
  for (Vec3& position : end) {
    position += Vec3(3.0 + step(random), step(random), step(random));
  }
  PairSearch search;
  Workers workers;
  constexpr double reach = 0.08;
  search.update({.model = *model, .distance = reach, .reach = reach, .patches = nullptr}, start, end, workers);
  const auto isListed = [&](const FeaturePair& pair) {
    return std::any_of(search.pairs().begin(), search.pairs().end(), [&](const PairSearch::Listed& each) {
      const FeaturePair& other = each.pair;
      return other.edges == pair.edges && ((other.first == pair.first && other.second == pair.second) ||
                                           (pair.edges && other.first == pair.second && other.second == pair.first));
    });
  };
  int near = 0;
  for (const double time : {0.0, 0.3, 0.7, 1.0}) {
    std::vector<Vec3> positions = start;
    for (std::size_t v = 0; v < start.size(); ++v) {
      positions[v] += time * (end[v] - start[v]);
    }
    const FeatureMesh& mesh = search.mesh();
    for (int v = 0; v < model->vertexCount(); ++v) {
      for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const FeaturePair pair{v, t, false};
        if (!hasCorner(mesh.triangles[t], v) && gapOf(verticesOf(mesh, pair), positions).distance < reach) {
          ++near;
          EXPECT_TRUE(isListed(pair));
        }
      }
    }
    for (int a = 0; a < static_cast<int>(mesh.edges.edges.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(mesh.edges.edges.size()); ++b) {
        const FeaturePair pair{a, b, true};
        if (!testing::shareEnd(mesh.edges.edges[a], mesh.edges.edges[b]) &&
            gapOf(verticesOf(mesh, pair), positions).distance < reach) {
          ++near;
          EXPECT_TRUE(isListed(pair));
        }
      }
    }
  }
  EXPECT_GT(near, 100);
}

TEST(EdgeCrossings, agreeWithTheExactIntersectionTest) {
  int intersecting = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    const auto model = buildClothModel(triangleSoup(100, random), 1.0, MassLumping::Uniform, {});
    const FeatureMesh mesh = featureMeshOf(*model);
    const std::vector<EdgeCrossing> crossings = testing::crossingsAtRest(*model, mesh);
    std::vector<char> entangled;
    markEntangled(mesh, crossings, model->restPositions.size(), entangled);
    const auto pairs = intersection::intersectingPairs({model->restPositions, model->triangles});
    EXPECT_EQ(crossings.empty(), pairs.empty()) << seed;
    EXPECT_EQ(entangled.empty(), pairs.empty()) << seed;
    intersecting += pairs.empty() ? 0 : 1;
    std::vector<char> expected(model->restPositions.size(), 0);
    for (const intersection::TrianglePair& pair : pairs) {
      for (int k = 0; k < 3; ++k) {
        expected[3 * pair.first + k] = expected[3 * pair.second + k] = 1;
      }
    }
    for (std::size_t v = 0; v < entangled.size(); ++v) {
      EXPECT_LE(entangled[v], expected[v]) << seed;
    }
  }
  EXPECT_GT(intersecting, 3);
}

}  // namespace
}  // namespace drape::sim::contact
