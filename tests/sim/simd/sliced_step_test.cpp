#include "reference_step.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/solvers/solver.hpp"
#include "simd_meshes.hpp"
#include "sliced_stepping.hpp"

#include <gtest/gtest.h>
#include <set>

namespace drape::sim::simd {
namespace {

using testing::everyKindOfMesh;
using testing::everything;
using testing::largestDifference;
using testing::NamedMesh;
using testing::pinnedCloth;
using testing::shaken;
using testing::SteppingByHand;
using testing::Turns;

/// An attachment to a triangle whose corners are in more than one slice, if there is one.
StepInputs attachmentAcrossSlices(const ClothModel& model) {
  const SliceLayout layout = buildSliceLayout(model);
  StepInputs inputs;
  inputs.attachment = Attachment{{0, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {20.0, 2.0}};
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    std::set<int> slices;
    for (const int vertex : model.triangles[t]) {
      slices.insert(layout.indexOf[vertex] / sliceLanes);
    }
    if (slices.size() > 1) {
      inputs.attachment->triangle = static_cast<int>(t);
    }
  }
  return inputs;
}

/// Meshes that a dense matrix can be made of in no time.
std::vector<NamedMesh> smallMeshes() {
  return {{"uneven", testing::unevenSheet(6, 3)},
          {"renumbered", testing::renumbered(testing::unevenSheet(6, 3), 5)},
          {"pieces", testing::together(testing::fan(18), testing::sheet(3))}};
}

TEST(SlicedStep, equalsTheDenseReferenceOnUnevenMeshesWithAirAndAnAttachmentAcrossSlices) {
  for (const NamedMesh& mesh : smallMeshes()) {
    const auto model = pinnedCloth(mesh.mesh);
    const StepInputs inputs = attachmentAcrossSlices(*model);
    for (const int sweeps : {1, 2, 3, 5}) {
      StepParameters parameters = everything();
      parameters.jacobi.sweeps = sweeps;
      parameters.jacobi.relaxation = sweeps == 2 ? 0.8 : 1.0;
      SteppingByHand<double> fast(*model, parameters, 1, Turns::Forwards);
      ClothState state = shaken(*model, 0.02, 7);
      ClothState plain = state;
      for (int step = 0; step < 3; ++step) {
        fast.oneIteration(inputs, 1, state);
        testing::referenceStep(*model, parameters, inputs, plain);
      }
      EXPECT_LT(largestDifference(state, plain), 1e-10) << mesh.name << " " << sweeps << " sweeps";
    }
  }
}

TEST(SlicedStep, equalsTheDenseReferenceInEveryVariantOfTheForceDerivativeOnAnUnevenMesh) {
  const auto model = pinnedCloth(testing::renumbered(testing::unevenSheet(6, 3), 5));
  for (const auto variant : testing::allDerivatives) {
    StepParameters parameters = everything();
    parameters.derivative = variant;
    SteppingByHand<double> fast(*model, parameters, 2, Turns::Backwards);
    ClothState state = shaken(*model, 0.02, 7);
    ClothState plain = state;
    fast.oneIteration({}, 1, state);
    testing::referenceStep(*model, parameters, {}, plain);
    EXPECT_LT(largestDifference(state, plain), 1e-10) << static_cast<int>(variant);
  }
}

/// With G the sweep without its constant part p, Jacobi's answers are J_k = G J_(k-1) + p from J_(-1) = 0, so a sum of
/// them has the sum of their followers for a follower, and Chebyshev's x_(k+1) = w (G x_k + p - x_(k-1)) + x_(k-1) is
/// such a sum too. The dense reference gives each J_k.
TEST(SlicedStep, equalsASumOfDenseJacobiAnswersWithChebyshevsWeights) {
  const auto model = pinnedCloth(testing::renumbered(testing::unevenSheet(6, 3), 5));
  const StepParameters parameters = everything();
  const ClothState start = shaken(*model, 0.02, 7);
  const std::vector<double> weights{1.3, 1.1, 1.25, 1.2};
  for (int sweeps = 1; sweeps <= static_cast<int>(weights.size()); ++sweeps) {
    std::vector<std::vector<double>> part(2, std::vector<double>(6, 0.0));  // x_(-1) = J_(-1), x_0 = J_0
    part[0][0] = 1.0;
    part[1][1] = 1.0;
    for (int k = 1; k <= sweeps; ++k) {
      const double w = weights[k - 1];
      const auto old = part[part.size() - 2];
      std::vector<double> next(6, 0.0);
      for (std::size_t j = 0; j < 6; ++j) {
        next[j] = (1.0 - w) * old[j] + (j > 0 ? w * part.back()[j - 1] : 0.0);
      }
      part.push_back(next);
    }
    std::vector<Vec3> expected = start.velocities;
    for (int k = 0; k <= sweeps; ++k) {
      ClothState plain = start;
      StepParameters jacobi = parameters;
      jacobi.jacobi.sweeps = k;
      testing::referenceStep(*model, jacobi, {}, plain);
      for (std::size_t v = 0; v < expected.size(); ++v) {
        expected[v] += part.back()[k + 1] * (plain.velocities[v] - start.velocities[v]);
      }
    }
    StepParameters accelerated = parameters;
    accelerated.jacobi.sweeps = sweeps;
    SteppingByHand<double> fast(*model, accelerated, 2, Turns::Forwards);
    fast.accelerateBy({weights.begin(), weights.begin() + sweeps});
    ClothState state = start;
    fast.oneIteration({}, 1, state);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      EXPECT_LT((state.velocities[v] - expected[v]).norm(), 1e-10) << sweeps << " sweeps";
    }
  }
}

/// A position of 1 m has an error of 6e-8 m in float. With 100 N/m, 3 g and 1/150 s that causes 3e-5 m/s and 2e-7 m a
/// step.
TEST(SlicedStep, staysNearTheDenseReferenceInFloat) {
  for (const NamedMesh& mesh : smallMeshes()) {
    const auto model = pinnedCloth(mesh.mesh);
    const StepInputs inputs = attachmentAcrossSlices(*model);
    for (const auto variant : {ForceDerivative::Stabilised, ForceDerivative::Scalar, ForceDerivative::Axial}) {
      StepParameters parameters = everything();
      parameters.derivative = variant;
      SteppingByHand<float> fast(*model, parameters, 1, Turns::Forwards);
      ClothState state = shaken(*model, 0.02, 7);
      ClothState plain = state;
      fast.oneIteration(inputs, 1, state);
      testing::referenceStep(*model, parameters, inputs, plain);
      double distance = 0.0;
      for (std::size_t v = 0; v < state.positions.size(); ++v) {
        distance = std::max(distance, (state.positions[v] - plain.positions[v]).norm());
      }
      EXPECT_LT(distance, 1e-6) << mesh.name;
      EXPECT_LT(largestDifference(state, plain), 2e-4) << mesh.name;
      EXPECT_GT(distance, 1e-10) << mesh.name << ": it should have been float";
    }
  }
}

template <typename T>
std::uint64_t hashOfSteps(const ClothModel& model, int sweeps, int members, Turns turns) {
  StepParameters parameters = everything();
  parameters.jacobi.sweeps = sweeps;
  SteppingByHand<T> stepping(model, parameters, members, turns);
  ClothState state = shaken(model, 0.002, 3);
  stepping.oneIteration(attachmentAcrossSlices(model), 3, state);
  stepping.verlet(3, state);
  EXPECT_TRUE(isFinite(state));
  return stateHash(state);
}

class EveryMeshInShares : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(EveryMeshInShares, hasTheSameBitsForAnyNumberOfSharesTakenInAnyOrder) {
  const auto model = pinnedCloth(GetParam().mesh);
  for (const int sweeps : {1, 3}) {
    const auto single = hashOfSteps<float>(*model, sweeps, 1, Turns::Forwards);
    const auto twice = hashOfSteps<double>(*model, sweeps, 1, Turns::Forwards);
    EXPECT_NE(single, twice);
    for (const int members : {2, 3, 4, 8}) {
      for (const Turns turns : {Turns::Forwards, Turns::Backwards, Turns::EveryOther}) {
        EXPECT_EQ(hashOfSteps<float>(*model, sweeps, members, turns), single) << members << " shares";
        EXPECT_EQ(hashOfSteps<double>(*model, sweeps, members, turns), twice) << members << " shares";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SlicedStep, EveryMeshInShares, ::testing::ValuesIn(everyKindOfMesh()),
                         [](const auto& chosen) { return chosen.param.name; });

TEST(SlicedStep, hasTheSameBitsInAsManySharesWhereSweepsMeetInTheMiddleOfOne) {
  const auto model = pinnedCloth(testing::sheet(49));
  for (const int sweeps : {1, 3, 5}) {
    const auto alone = hashOfSteps<float>(*model, sweeps, 1, Turns::Forwards);
    for (const int members : {2, 3, 4, 8}) {
      EXPECT_EQ(hashOfSteps<float>(*model, sweeps, members, Turns::Backwards), alone) << members << " shares";
    }
  }
}

TEST(SlicedStep, takesManyStepsAtOnceAsOneAfterTheOther) {
  const auto model = pinnedCloth(testing::renumbered(testing::unevenSheet(12, 3), 4));
  for (const char* name : {"one_iteration", "verlet", "chebyshev", "pcg"}) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      StepParameters parameters = everything();
      parameters.precision = precision;
      parameters.timeStep = 1.0 / 1500.0;
      const StepInputs inputs = attachmentAcrossSlices(*model);
      ClothState together = shaken(*model, 0.002, 3);
      ClothState apart = together;
      findSolver(name)->make()->steps(*model, parameters, inputs, 4, together);
      const auto solver = findSolver(name)->make();
      for (int step = 0; step < 4; ++step) {
        solver->step(*model, parameters, inputs, apart);
      }
      if (precision == Precision::Double) {
        EXPECT_LT(largestDifference(together, apart), 1e-12) << name;
      } else {
        EXPECT_LT(largestDifference(together, apart), 1e-3) << name;
      }
    }
  }
}

TEST(SlicedClothCache, keepsTheLayoutWhenOnlyMassesAndPinsChange) {
  const auto model = pinnedCloth(testing::sheet(9));
  SlicedClothCache<float> cache;
  const SlicedCloth<float>& cloth = cache.get(*model);
  const int* const layout = cloth.layout.order.data();
  std::vector<bool> pinned(model->pinned.size(), false);
  pinned[7] = true;
  const auto other = withMass(*withPins(*model, pinned), 0.3, MassLumping::Uniform);
  const SlicedCloth<float>& same = cache.get(*other);
  EXPECT_EQ(same.layout.order.data(), layout) << "no new one should have been made";
  for (std::size_t k = 0; k < other->vertexMass.size(); ++k) {
    const auto v = static_cast<std::size_t>(same.layout.order[k]);
    EXPECT_EQ(same.mass.data()[k], static_cast<float>(other->vertexMass[v]));
    EXPECT_EQ(same.free.data()[k], v == 7 ? 0.0F : 1.0F);
  }
}

TEST(SlicedClothCache, makesANewLayoutWhenTrianglesRestShapeOrSizeChange) {
  const ClothMesh mesh = testing::sheet(9);
  ClothMesh turned = mesh;
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  ClothMesh longer = mesh;
  longer.positions[5].x() += 0.01;
  for (const ClothMesh& changed : {turned, longer, testing::sheet(10), testing::renumbered(mesh, 2)}) {
    SlicedClothCache<double> cache;
    const auto first = pinnedCloth(mesh);
    static_cast<void>(cache.get(*first));
    const auto second = pinnedCloth(changed);
    const SlicedCloth<double>& cloth = cache.get(*second);
    SlicedCloth<double> fresh(*second);
    ASSERT_EQ(cloth.layout.order, fresh.layout.order);
    EXPECT_EQ(cloth.restLength, fresh.restLength);
    ASSERT_EQ(cloth.layout.corners.size(), fresh.layout.corners.size());
    for (std::size_t c = 0; c < fresh.layout.corners.size(); ++c) {
      EXPECT_EQ(cloth.layout.corners[c].slotA, fresh.layout.corners[c].slotA);
      EXPECT_EQ(cloth.layout.corners[c].slotB, fresh.layout.corners[c].slotB);
    }
  }
}

}  // namespace
}  // namespace drape::sim::simd
