#include "sim/simd/constraint_lanes.hpp"

#include "sim/solvers/solver.hpp"
#include "simd_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace drape::sim::simd {
namespace {

using testing::everyKindOfMesh;
using testing::NamedMesh;
using testing::pinnedCloth;
using testing::shaken;

class EveryMeshOfConstraints : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(EveryMeshOfConstraints, hasEverySpringOnceAndNoVertexTwiceInAColour) {
  const auto model = pinnedCloth(GetParam().mesh);
  const ConstraintLanes lanes(*model);
  std::map<std::pair<int, int>, double> restLengths;
  std::size_t seen = 0;
  for (int colour = 0; colour < lanes.colours(); ++colour) {
    std::set<int> touched;
    const auto c = static_cast<std::size_t>(colour);
    for (int i = lanes.colourBegin[c]; i < lanes.colourBegin[c + 1]; ++i) {
      const ConstraintLanes::Batch& batch = lanes.batches[i];
      for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
        if (batch.a[lane] == lanes.vertexCount()) {
          EXPECT_EQ(batch.b[lane], lanes.vertexCount());
          EXPECT_EQ(i + 1, lanes.colourBegin[c + 1]) << "only the last batch of a colour may have lanes to spare";
          continue;
        }
        EXPECT_TRUE(touched.insert(batch.a[lane]).second);
        EXPECT_TRUE(touched.insert(batch.b[lane]).second);
        const int a = lanes.order[batch.a[lane]];
        const int b = lanes.order[batch.b[lane]];
        restLengths[{a, b}] = static_cast<double>(batch.restLength[lane]);
        ++seen;
      }
    }
  }
  EXPECT_EQ(seen, model->springs.size());
  ASSERT_EQ(restLengths.size(), model->springs.size());
  for (const Spring& spring : model->springs) {
    EXPECT_FLOAT_EQ(static_cast<float>((restLengths[{spring.a, spring.b}])), static_cast<float>(spring.restLength));
  }
}

INSTANTIATE_TEST_SUITE_P(ConstraintLanes, EveryMeshOfConstraints, ::testing::ValuesIn(everyKindOfMesh()),
                         [](const auto& chosen) { return chosen.param.name; });

struct Difference {
  double position = 0.0;  // [m]
  double velocity = 0.0;  // [m/s]
};

Difference between(const ClothState& a, const ClothState& b) {
  Difference largest;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    largest.position = std::max(largest.position, (a.positions[v] - b.positions[v]).norm());
    largest.velocity = std::max(largest.velocity, (a.velocities[v] - b.velocities[v]).norm());
  }
  return largest;
}

/// How far XPBD in float ends from XPBD in double, both from the same start.
Difference floatFromDouble(const ClothModel& model, StepParameters parameters, const StepInputs& inputs, int steps) {
  ClothState single = shaken(model, 0.01, 7);
  ClothState twice = single;
  parameters.precision = Precision::Float;
  findSolver("xpbd")->make()->steps(model, parameters, inputs, steps, single);
  parameters.precision = Precision::Double;
  findSolver("xpbd")->make()->steps(model, parameters, inputs, steps, twice);
  EXPECT_NE(stateHash(single), stateHash(twice));
  EXPECT_DOUBLE_EQ(single.time, steps * parameters.timeStep);
  for (std::size_t v = 0; v < model.pinned.size(); ++v) {
    if (model.pinned[v]) {
      EXPECT_EQ(single.positions[v], twice.positions[v]);
      EXPECT_EQ(single.velocities[v], Vec3(Vec3::Zero()));
    }
  }
  return between(single, twice);
}

StepInputs pullingAttachment() {
  StepInputs inputs;
  inputs.attachment = Attachment{{3, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.3, 0.5)}, {20.0, 2.0}};
  return inputs;
}

/// A position of 1 m has an error of 6e-8 m in float. So each correction has about that error, and a velocity 6e-8 m /
/// h.
TEST(XpbdInFloat, takesTheStepOfXpbdInDoubleToWithinTwoMicrometres) {
  for (const NamedMesh& mesh : everyKindOfMesh()) {
    const auto model = pinnedCloth(mesh.mesh);
    if (model->triangles.size() < 4) {
      continue;
    }
    for (const bool air : {false, true}) {
      StepParameters parameters;
      parameters.material.damping = 0.01;
      parameters.air.drag = air ? 0.8 : 0.0;
      parameters.air.lift = air ? 0.5 : 0.0;
      parameters.air.wind = Vec3(1.0, 0.2, -2.0);
      const Difference difference = floatFromDouble(*model, parameters, pullingAttachment(), 1);
      EXPECT_LT(difference.position, 2e-6) << mesh.name << (air ? " in air" : "");
      EXPECT_LT(difference.velocity, 3e-4) << mesh.name << (air ? " in air" : "");
    }
  }
}

TEST(XpbdInFloat, staysNearXpbdInDoubleForATenthOfASecond) {
  const auto model = pinnedCloth(testing::unevenSheet(12, 3));
  StepParameters parameters;
  parameters.material.damping = 0.002;
  parameters.timeStep = 1.0 / 600.0;
  const Difference difference = floatFromDouble(*model, parameters, {}, 60);
  EXPECT_LT(difference.position, 1e-4);
}

TEST(XpbdInFloat, takesManyStepsAtOnceAsOneAfterTheOtherToTheLastBit) {
  const auto model = pinnedCloth(testing::renumbered(testing::unevenSheet(12, 3), 4));
  for (const double drag : {0.0, 0.7}) {
    StepParameters parameters;
    parameters.precision = Precision::Float;
    parameters.material.damping = 0.01;
    parameters.air.drag = drag;
    ClothState together = shaken(*model, 0.01, 3);
    ClothState apart = together;
    const int iterations =
        findSolver("xpbd")->make()->steps(*model, parameters, pullingAttachment(), 4, together).iterations;
    EXPECT_EQ(iterations, 4 * parameters.iteration.iterations);
    const auto solver = findSolver("xpbd")->make();
    for (int step = 0; step < 4; ++step) {
      solver->step(*model, parameters, pullingAttachment(), apart);
    }
    EXPECT_EQ(stateHash(together), stateHash(apart)) << "drag " << drag;
  }
}

/// A fall of h^2 g = 1e-8 m is less than a float of 1 m can tell from none.
TEST(XpbdInFloat, fallsInStepsTooShortForItsPlacesToTell) {
  const auto model = buildClothModel(testing::sheet(4), 0.1, MassLumping::Uniform, {});
  StepParameters parameters;
  parameters.precision = Precision::Float;
  parameters.timeStep = 1.0 / 30000.0;
  parameters.iteration.iterations = 1;
  ClothState state = stateAtRest(model->restPositions);
  findSolver("xpbd")->make()->steps(*model, parameters, {}, 3000, state);
  EXPECT_NEAR(state.velocities[5].y(), -0.981, 0.01);
  EXPECT_NEAR(state.positions[5].y(), -0.5 * 9.81 * 0.01, 0.001);
}

TEST(XpbdInFloat, warnsOfStepsTooShortForFloatWhereItReallyIsOff) {
  const SolverInfo& info = *findSolver("xpbd");
  const auto model = testing::pinnedSheet(9);
  const auto offAfterATenthOfASecond = [&](int stepsASecond) {
    StepParameters parameters;
    parameters.timeStep = 1.0 / stepsASecond;
    parameters.precision = Precision::Float;
    const Difference difference = floatFromDouble(*model, parameters, {}, stepsASecond / 10);
    parameters.precision = Precision::Double;
    EXPECT_FALSE(info.warning(*model, parameters));
    parameters.precision = Precision::Float;
    const auto warning = info.warning(*model, parameters);
    const bool warned = warning && warning->kind == SolverWarning::Kind::InexactInFloat;
    return std::pair(difference.velocity, warned);
  };
  const auto [calm, calmWarned] = offAfterATenthOfASecond(1500);
  EXPECT_FALSE(calmWarned);
  EXPECT_LT(calm, 0.01);
  const auto [off, offWarned] = offAfterATenthOfASecond(60000);
  EXPECT_TRUE(offWarned);
  EXPECT_GT(off, 0.02);
}

}  // namespace
}  // namespace drape::sim::simd
