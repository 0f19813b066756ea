#include "figure/moving_figure.hpp"

#include "figure_mesh.hpp"
#include "intersection/intersections.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

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

/// A figure that begins with the turn, which can face anywhere.
class ChangingFigure : public ::testing::Test {
 protected:
  std::shared_ptr<const MovingFigure> figure_ = std::make_shared<MovingFigure>(
      builtFigure().shape.positions, builtFigure().triangles, FigureOptions{findMotion("turn"), maxSpeed, {}});

  [[nodiscard]] std::vector<Vec3> at(double time) const {
    std::vector<Vec3> positions;
    figure_->positionsAt(time, positions);
    return positions;
  }
  /// The largest distance that a vertex moves in a step between two times.
  double largestStep(double from, double to, double step) {
    double largest = 0.0;
    std::vector<Vec3> before = at(from);
    for (double time = from + step; time <= to; time += step) {
      std::vector<Vec3> after = at(time);
      largest = std::max(largest, furthest(before, after));
      before.swap(after);
    }
    return largest;
  }
};

TEST_F(ChangingFigure, goesFromMotionToMotionWithoutJumps) {
  constexpr double step = 1.0 / 300.0;
  double time = 0.9;  // within the first blend
  int change = 0;
  for (const Motion& from : motions()) {
    for (const Motion& to : motions()) {
      for (const Motion* next : {&from, &to}) {
        const std::vector<Vec3> before = at(time);
        figure_ = figure_->changed(time, {next, change % 2 == 0 ? maxSpeed : minSpeed, {}});
        EXPECT_LT(furthest(at(time), before), 1e-9) << from.name << " to " << to.name;
        const double pause = 0.15 + 0.37 * (change++ % 5);  // some changes come before the end of the blend
        EXPECT_LT(largestStep(time, time + pause, step), 24.0 * step) << from.name << " to " << to.name;
        time += pause;
      }
    }
  }
}

TEST_F(ChangingFigure, endsInTheMotionFromItsBegin) {
  for (const Motion& motion : motions()) {
    const double time = 3.21;
    const auto changed = figure_->changed(time, {&motion, 1.0, {}});
    EXPECT_EQ(changed->options().motion, &motion);
    const auto fresh = moving(motion.name);
    if (motion.name != "turn") {  // which goes on from where it was
      std::vector<Vec3> positions;
      changed->positionsAt(time + 1.7, positions);
      EXPECT_LT(furthest(positions, drape::figure::at(*fresh, 1.7)), 1e-9) << motion.name;
    }
  }
}

TEST_F(ChangingFigure, keepsThePlaceInItsMotionWhenOnlyTheSpeedChanges) {
  figure_ = figure_->changed(2.0, {findMotion("walk"), 1.0, {}});
  const auto faster = figure_->changed(4.0, {findMotion("walk"), 2.0, {}});
  std::vector<Vec3> positions;
  figure_->positionsAt(7.0, positions);
  std::vector<Vec3> others;  // after 2 s at the one speed, and 1.5 s at the other
  faster->positionsAt(5.5, others);
  EXPECT_LT(furthest(positions, others), 1e-9);
}

TEST_F(ChangingFigure, takesAnotherSizeWithinASecondAndKeepsItAfterAnother) {
  const auto heightAt = [&](double time) {
    const std::vector<Vec3> positions = at(time);
    const auto [low, high] = std::ranges::minmax(positions, {}, [](const Vec3& p) { return p.y(); });
    return high.y() - low.y();
  };
  FigureOptions tall{findMotion("t_pose"), 1.0, {}};
  figure_ = figure_->changed(2.0, tall);
  tall.proportions.height = 1.9;
  figure_ = figure_->changed(4.0, tall);
  EXPECT_NEAR(heightAt(4.0), 1.75, 0.01);
  EXPECT_NEAR(heightAt(5.0), 1.9, 0.005);
  tall.proportions.waist = 0.9;
  figure_ = figure_->changed(5.5, tall);
  EXPECT_NEAR(heightAt(5.7), 1.9, 0.005);
  EXPECT_NEAR(heightAt(9.0), 1.9, 0.005);
}

TEST_F(ChangingFigure, startsAgainWithItsOptions) {
  FigureOptions options{findMotion("squat"), 1.5, {}};
  options.proportions.height = 1.6;
  const auto again = figure_->changed(2.0, options)->restarted(options);
  const auto fresh = movingFigure(builtFigure().shape.positions, builtFigure().triangles, options);
  for (const double time : {0.0, 0.4, 1.9}) {
    std::vector<Vec3> positions;
    again->positionsAt(time, positions);
    EXPECT_EQ(furthest(positions, drape::figure::at(*fresh, time)), 0.0);
  }
}

TEST(FigureOptions, haveRanges) {
  EXPECT_TRUE(isAllowed({}));
  EXPECT_FALSE(isAllowed({findMotion("walk"), 2.5, {}}));
  EXPECT_FALSE(isAllowed({findMotion("walk"), 0.0, {}}));
  EXPECT_FALSE(isAllowed({findMotion("walk"), std::nan(""), {}}));
  EXPECT_FALSE(isAllowed({nullptr, 1.0, {}}));
  for (const ProportionInfo& each : proportionTable()) {
    FigureOptions options;
    options.proportions.*each.value = each.max;
    EXPECT_TRUE(isAllowed(options)) << each.key;
    options.proportions.*each.value = each.max + 0.01;
    EXPECT_FALSE(isAllowed(options)) << each.key;
    options.proportions.*each.value = each.min - 0.01;
    EXPECT_FALSE(isAllowed(options)) << each.key;
  }
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
