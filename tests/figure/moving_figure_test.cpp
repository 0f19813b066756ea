#include "figure/moving_figure.hpp"

#include "figure_mesh.hpp"
#include "intersection/intersections.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::figure {
namespace {

std::shared_ptr<const sim::contact::MeshShape> moving(std::string_view motion, const Proportions& proportions = {},
                                                      double speed = 1.0) {
  return movingFigure(builtFigure().shape.positions, builtFigure().triangles, {findMotion(motion), speed, proportions});
}

std::vector<Vec3> at(const sim::contact::MeshShape& shape, double time) {
  std::vector<Vec3> positions;
  shape.deformation->positionsAt(time, positions);
  return positions;
}

double furthest(const std::vector<Vec3>& first, const std::vector<Vec3>& second) {
  double distance = 0.0;
  for (std::size_t v = 0; v < first.size(); ++v) {
    distance = std::max(distance, (first[v] - second[v]).norm());
  }
  return distance;
}

TEST(MovingFigure, startsAtRestInTheRestPose) {
  for (const Motion& motion : motions()) {
    const auto shape = moving(motion.name);
    EXPECT_TRUE(shape->deforms());
    EXPECT_EQ(furthest(at(*shape, 0.0), builtFigure().shape.positions), 0.0);
    EXPECT_LT(furthest(at(*shape, 1e-4), builtFigure().shape.positions), 1e-6) << motion.name;
  }
}

TEST(MovingFigure, repeatsItsMotionAfterTheBlend) {
  for (const Motion& motion : motions()) {
    const auto shape = moving(motion.name, {}, 2.0);
    const double period = motion.period / 2.0;
    EXPECT_LT(furthest(at(*shape, 1.3), at(*shape, 1.3 + period)), 1e-9) << motion.name;
  }
}

TEST(MovingFigure, movesWithoutJumps) {
  for (const Motion& motion : motions()) {
    const auto shape = moving(motion.name, {}, 2.0);
    constexpr double step = 1.0 / 300.0;
    std::vector<Vec3> before = at(*shape, 0.0);
    for (double time = step; time < 1.5 + 0.5 * motion.period; time += step) {
      std::vector<Vec3> after = at(*shape, time);
      EXPECT_LT(furthest(before, after), 24.0 * step) << motion.name << " at " << time << " s";
      before.swap(after);
    }
  }
}

TEST(MovingFigure, takesItsOwnSizeWithinTheBlend) {
  Proportions tall;
  tall.height = 1.9;
  const auto shape = moving("t_pose", tall);
  const auto heightAt = [&](double time) {
    const std::vector<Vec3> positions = at(*shape, time);
    const auto [low, high] = std::ranges::minmax(positions, {}, [](const Vec3& p) { return p.y(); });
    return high.y() - low.y();
  };
  EXPECT_NEAR(heightAt(0.0), 1.75, 0.01);
  EXPECT_NEAR(heightAt(blendTime), 1.9, 0.005);
}

TEST(MovingFigure, doesNotIntersectItself) {
  for (const Motion& motion : motions()) {
    const auto shape = moving(motion.name);
    for (int k = 0; k < 8; ++k) {
      const std::vector<Vec3> positions = at(*shape, blendTime + motion.period * k / 8.0);
      EXPECT_EQ(intersection::intersectingPairs({positions, shape->triangles}).size(), 0U)
          << motion.name << " at " << k << "/8 of its period";
    }
  }
}

}  // namespace
}  // namespace drape::figure
