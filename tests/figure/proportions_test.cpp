#include "figure/proportions.hpp"

#include "figure_mesh.hpp"

#include <gtest/gtest.h>

namespace drape::figure {
namespace {

FigureShape sized(const Proportions& wanted) {
  const BuiltFigure& figure = builtFigure();
  return withProportions(figure.shape, figure.triangles, figure.weights, wanted);
}

Proportions measuresOf(const FigureShape& shape) {
  return measured(shape, builtFigure().triangles, builtFigure().weights);
}

TEST(Proportions, areThoseOfTheFigureAsBuiltUnlessGiven) {
  const FigureShape same = sized({});
  for (std::size_t v = 0; v < same.positions.size(); ++v) {
    EXPECT_EQ(same.positions[v], builtFigure().shape.positions[v]);
  }
}

TEST(Proportions, areMetByTheFigure) {
  for (const ProportionInfo& info : proportionTable()) {
    const double built = *(measuresOf(builtFigure().shape).*info.value);
    EXPECT_GT(built, info.min) << info.key;
    EXPECT_LT(built, info.max) << info.key;
    for (const double factor : {0.92, 1.15}) {
      Proportions wanted;
      wanted.*info.value = factor * built;
      EXPECT_NEAR(*(measuresOf(sized(wanted)).*info.value), factor * built, 0.01 * built) << info.key;
    }
  }
}

TEST(Proportions, moveTheJointsOfTheArmsAndTheHeight) {
  Proportions wanted;
  wanted.height = 1.60;
  wanted.shoulder = 0.42;
  const FigureShape shape = sized(wanted);
  const Vec3& shoulder = shape.places[indexOf(Joint::LeftUpperArm)];
  EXPECT_NEAR(shoulder.x(), 0.21, 1e-9);
  EXPECT_LT(shoulder.y(), restOf(Joint::LeftUpperArm).y() - 0.09);
}

}  // namespace
}  // namespace drape::figure
