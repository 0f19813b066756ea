#include "sim/systems/incremental_potential.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

namespace drape::sim {
namespace {

/// A shaken 4 x 4 sheet whose springs are partly stretched and partly compressed.
struct Scene {
  std::shared_ptr<const ClothModel> model = testing::irregularSheet(4, {5});
  ClothState state = testing::shaken(*model, 0.05, 9);
  StepParameters parameters;
  StepInputs inputs;
  Workers workers;
  IncrementalPotential potential;
  std::vector<Vec3> velocities;

  explicit Scene(double maxForce) {
    parameters.timeStep = 1.0 / 30.0;
    parameters.material.damping = 0.05;
    parameters.air.drag = 0.5;
    parameters.air.lift = 0.5;
    parameters.air.wind = Vec3(1.0, 0.5, -0.3);
    inputs.attachment = Attachment{{7, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {50.0, maxForce}};
    potential.prepare(*model, parameters, inputs, state, workers);
    testing::RandomVectors random(10);
    for (int i = 0; i < model->vertexCount(); ++i) {
      velocities.push_back(i == 5 ? Vec3(Vec3::Zero()) : random.next(1.0));
    }
  }
};

class Potential : public ::testing::TestWithParam<double> {};

TEST_P(Potential, hasTheGradientThatItsDifferencesShow) {
  Scene scene(GetParam());
  scene.potential.evaluate(scene.velocities);
  const std::vector<Vec3> gradient = scene.potential.gradient();
  constexpr double step = 1e-6;
  for (std::size_t i = 0; i < scene.velocities.size(); ++i) {
    for (int c = 0; c < 3 && !scene.model->pinned[i]; ++c) {
      std::vector<Vec3> nudged = scene.velocities;
      nudged[i][c] += step;
      const double above = scene.potential.evaluate(nudged).value;
      nudged[i][c] -= 2.0 * step;
      const double below = scene.potential.evaluate(nudged).value;
      EXPECT_NEAR(gradient[i][c], (above - below) / (2.0 * step), 1e-8) << "vertex " << i;
    }
  }
  EXPECT_EQ(gradient[5], Vec3(Vec3::Zero()));
}

TEST_P(Potential, hasTheSecondDerivativeThatItsGradientsDifferencesShow) {
  Scene scene(GetParam());
  SparseSystem hessian(*scene.model);
  scene.potential.evaluate(scene.velocities);
  scene.potential.fillHessian(ForceDerivative::Exact, hessian);
  const Eigen::MatrixXd whole = Eigen::MatrixXd(hessian.lower()).selfadjointView<Eigen::Lower>();
  constexpr double step = 1e-6;
  for (Eigen::Index column = 0; column < whole.cols(); ++column) {
    Eigen::VectorXd nudged = hessian.gather(scene.velocities);
    std::vector<Vec3> velocities(scene.velocities.size());
    nudged[column] += step;
    hessian.scatter(nudged, velocities);
    scene.potential.evaluate(velocities);
    const Eigen::VectorXd above = hessian.gather(scene.potential.gradient());
    nudged[column] -= 2.0 * step;
    hessian.scatter(nudged, velocities);
    scene.potential.evaluate(velocities);
    const Eigen::VectorXd below = hessian.gather(scene.potential.gradient());
    EXPECT_LT((whole.col(column) - (above - below) / (2.0 * step)).cwiseAbs().maxCoeff(), 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutTheBoundOfTheAttachmentForce, Potential, ::testing::Values(1000.0, 0.5));

TEST(Potential, estimatesTheRoundingErrorOfItsGradient) {
  Scene scene(1000.0);
  const auto value = scene.potential.evaluate(scene.velocities);
  EXPECT_GT(value.rounding, 0.0);
  EXPECT_LT(value.rounding, 1e-13 * value.residual);
}

}  // namespace
}  // namespace drape::sim
