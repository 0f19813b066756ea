#include "sim/systems/sparse_system.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

namespace drape::sim {
namespace {

using Eigen::MatrixXd;

Mat3 symmetric(testing::RandomVectors& random) {
  Mat3 block;
  block << random.next(1.0), random.next(1.0), random.next(1.0);
  return block + block.transpose();
}

struct Blocks {
  std::vector<Mat3> diagonal;
  std::vector<Mat3> springs;
};

Blocks randomBlocks(const ClothModel& model) {
  testing::RandomVectors random(1);
  Blocks blocks;
  for (int i = 0; i < model.vertexCount(); ++i) {
    blocks.diagonal.push_back(symmetric(random));
  }
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    blocks.springs.push_back(symmetric(random));
  }
  return blocks;
}

/// The whole matrix with all vertices, from the blocks alone.
MatrixXd denseOf(const ClothModel& model, const Blocks& blocks) {
  MatrixXd dense = MatrixXd::Zero(3 * model.vertexCount(), 3 * model.vertexCount());
  for (int i = 0; i < model.vertexCount(); ++i) {
    dense.block<3, 3>(3 * i, 3 * i) = blocks.diagonal[i];
  }
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    dense.block<3, 3>(3 * model.springs[s].a, 3 * model.springs[s].b) = blocks.springs[s];
    dense.block<3, 3>(3 * model.springs[s].b, 3 * model.springs[s].a) = blocks.springs[s];
  }
  return dense;
}

/// Rows and columns of the free vertices.
MatrixXd withoutPins(const ClothModel& model, const MatrixXd& dense) {
  std::vector<int> kept;
  for (int i = 0; i < model.vertexCount(); ++i) {
    for (int c = 0; c < 3 && !model.pinned[i]; ++c) {
      kept.push_back(3 * i + c);
    }
  }
  return dense(kept, kept);
}

MatrixXd wholeOf(const SparseSystem& system) {
  const MatrixXd lower(system.lower());
  return MatrixXd(lower.selfadjointView<Eigen::Lower>());
}

TEST(SparseSystem, equalsTheDenseMatrixOfItsBlocksWithoutThePinnedRows) {
  for (const std::vector<int>& pins : {std::vector<int>{}, {0}, {24}, {3, 7, 12}}) {
    const auto model = testing::irregularSheet(5, pins);
    const Blocks blocks = randomBlocks(*model);
    SparseSystem system(*model);
    Workers workers;
    system.fill(*model, 1, workers, blocks.diagonal, blocks.springs);
    EXPECT_EQ(wholeOf(system), withoutPins(*model, denseOf(*model, blocks))) << pins.size() << " pins";
    EXPECT_TRUE(MatrixXd(system.lower()).isLowerTriangular());
  }
}

TEST(SparseSystem, addsABlockToAPairOfVerticesAndToItsMirrorImage) {
  const auto model = testing::irregularSheet(5, {6});
  const Blocks blocks = randomBlocks(*model);
  testing::RandomVectors random(2);
  for (const Triangle& triangle : model->triangles) {
    SparseSystem system(*model);
    Workers workers;
    system.fill(*model, 1, workers, blocks.diagonal, blocks.springs);
    MatrixXd dense = denseOf(*model, blocks);
    const Mat3 block = symmetric(random);
    const auto a = static_cast<std::size_t>(triangle[2]);
    const auto b = static_cast<std::size_t>(triangle[0]);
    system.add(*model, a, b, block);
    dense.block<3, 3>(3 * triangle[2], 3 * triangle[0]) += block;
    dense.block<3, 3>(3 * triangle[0], 3 * triangle[2]) += block;
    system.add(*model, a, a, block);
    dense.block<3, 3>(3 * triangle[2], 3 * triangle[2]) += block;
    EXPECT_EQ(wholeOf(system), withoutPins(*model, dense));
  }
}

TEST(SparseSystem, gathersTheFreeVerticesAndScattersThemBack) {
  const auto model = testing::irregularSheet(4, {5});
  testing::RandomVectors random(3);
  std::vector<Vec3> vectors;
  for (int i = 0; i < model->vertexCount(); ++i) {
    vectors.push_back(random.next(1.0));
  }
  const SparseSystem system(*model);
  std::vector<Vec3> back(vectors.size(), Vec3::Ones());
  system.scatter(system.gather(vectors), back);
  vectors[5].setZero();
  EXPECT_EQ(back, vectors);
}

TEST(SparseSystem, isEmptyWhereEverythingIsPinned) {
  const auto model = testing::irregularSheet(2, {0, 1, 2, 3});
  EXPECT_EQ(SparseSystem(*model).lower().rows(), 0);
}

}  // namespace
}  // namespace drape::sim
