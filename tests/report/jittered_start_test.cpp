#include "report/jittered_start.hpp"

#include "sim/forces/diagnostics.hpp"

#include <gtest/gtest.h>

namespace drape::report {
namespace {

std::shared_ptr<const scene::Scene> sheet() {
  const scene::SceneDescription description = scene::openScene("grid");
  return scene::buildScene(description, description.settings);
}

TEST(JitteredStart, movesFreeVerticesByAtMostAHundredthOfAnEdge) {
  const auto scene = sheet();
  const auto moved = withJitteredStart(scene, 3);
  const double limit = 0.01 * sim::meanEdge(*scene->model);
  double largest = 0.0;
  int pins = 0;
  for (std::size_t v = 0; v < scene->start.positions.size(); ++v) {
    const Vec3 by = moved->start.positions[v] - scene->start.positions[v];
    largest = std::max(largest, by.lpNorm<Eigen::Infinity>());
    if (scene->model->pinned[v]) {
      EXPECT_EQ(by, Vec3::Zero());
      ++pins;
    }
  }
  EXPECT_GT(pins, 0);
  EXPECT_LE(largest, limit);
  EXPECT_GT(largest, 0.9 * limit);
}

TEST(JitteredStart, isTheSameForTheSameSeedOnly) {
  const auto scene = sheet();
  const auto positions = [&](int start) { return withJitteredStart(scene, start)->start.positions; };
  EXPECT_EQ(positions(1), positions(1));
  EXPECT_NE(positions(1), positions(2));
  EXPECT_EQ(positions(0), scene->start.positions);
}

}  // namespace
}  // namespace drape::report
