#include "sim/model/colouring.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>

namespace drape::sim {
namespace {

/// A fan around vertex 0, a lonely triangle with an edge of its own and a triangle with one foot in the fan.
ClothMesh irregularMesh() {
  ClothMesh mesh;
  testing::RandomVectors random(11);
  for (int v = 0; v < 14; ++v) {
    mesh.positions.push_back(random.next(1.0));
  }
  for (int v = 1; v < 9; ++v) {
    mesh.triangles.push_back({0, v, v + 1});
  }
  mesh.triangles.push_back({9, 10, 11});
  mesh.triangles.push_back({3, 12, 13});
  return mesh;
}

std::vector<std::shared_ptr<const ClothModel>> models() {
  return {testing::pinnedSheet(2), testing::pinnedSheet(17),
          buildClothModel(irregularMesh(), 1.0, MassLumping::Area, {})};
}

int maxDegree(const ClothModel& model) {
  std::size_t degree = 0;
  for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
    degree = std::max(degree, model.springEnds[v].size());
  }
  return static_cast<int>(degree);
}

/// Every index once, ascending within a colour, no colour empty.
void expectAPartition(const RaggedRows<int>& colours, std::size_t count) {
  ASSERT_EQ(colours.values().size(), count);
  for (std::size_t c = 0; c < colours.rowCount(); ++c) {
    EXPECT_FALSE(colours[c].empty());
    EXPECT_TRUE(std::is_sorted(colours[c].begin(), colours[c].end()));
  }
  const std::set<int> all(colours.values().begin(), colours.values().end());
  ASSERT_EQ(all.size(), count);
  EXPECT_EQ(*all.begin(), 0);
  EXPECT_EQ(*all.rbegin(), static_cast<int>(count) - 1);
}

TEST(Colouring, givesNoTwoSetsOfAColourAVertexInCommonAndLeavesOutEmptySets) {
  const std::vector<int> lengths{3, 0, 3, 2, 1};
  const RaggedRows<int> sets(lengths, {0, 1, 2, 2, 3, 4, 5, 6, 3});
  const RaggedRows<int> colours = colourSets(sets, 7);
  ASSERT_EQ(colours.rowCount(), 2U);
  EXPECT_TRUE(std::ranges::equal(colours[0], std::vector{0, 3, 4}));
  EXPECT_TRUE(std::ranges::equal(colours[1], std::vector{2}));
}

TEST(Colouring, givesNoTwoSpringsOfAColourAVertexInCommon) {
  for (const auto& model : models()) {
    const RaggedRows<int> colours = colourSprings(*model);
    expectAPartition(colours, model->springs.size());
    for (std::size_t c = 0; c < colours.rowCount(); ++c) {
      std::set<int> touched;
      for (const int s : colours[c]) {
        const Spring& spring = model->springs[s];
        EXPECT_TRUE(touched.insert(spring.a).second);
        EXPECT_TRUE(touched.insert(spring.b).second);
      }
    }
  }
}

TEST(Colouring, givesNoTwoNeighboursTheSameColour) {
  for (const auto& model : models()) {
    const RaggedRows<int> colours = colourVertices(model->springEnds);
    expectAPartition(colours, model->restPositions.size());
    std::vector<std::size_t> colourOf(model->restPositions.size());
    for (std::size_t c = 0; c < colours.rowCount(); ++c) {
      for (const int v : colours[c]) {
        colourOf[v] = c;
      }
    }
    for (const Spring& spring : model->springs) {
      EXPECT_NE(colourOf[spring.a], colourOf[spring.b]);
    }
  }
}

TEST(Colouring, needsNoMoreColoursThanAGreedyOneMay) {
  for (const auto& model : models()) {
    const int degree = maxDegree(*model);
    const auto springColours = static_cast<int>(colourSprings(*model).rowCount());
    const auto vertexColours = static_cast<int>(colourVertices(model->springEnds).rowCount());
    EXPECT_GE(springColours, degree);
    EXPECT_LE(springColours, 2 * degree - 1);
    EXPECT_GE(vertexColours, 3) << "a triangle needs three";
    EXPECT_LE(vertexColours, degree + 1);
  }
}

TEST(Colouring, visitsEveryIndexOnceColourAfterColour) {
  const auto model = testing::pinnedSheet(9);
  const RaggedRows<int> colours = colourVertices(model->springEnds);
  Workers workers;
  std::vector<int> visited;
  forEachByColour(workers, 1, colours, [&](std::size_t i) { visited.push_back(static_cast<int>(i)); });
  EXPECT_EQ(visited, colours.values());
}

TEST(Colouring, hasNoColoursWhereThereAreNoSprings) {
  ClothModel model;
  EXPECT_EQ(colourSprings(model).rowCount(), 0U);
  EXPECT_TRUE(colourVertices(model.springEnds).values().empty());
}

}  // namespace
}  // namespace drape::sim
