#include "sim/simd/conjugate_gradients.hpp"

#include "sim/simd/slice_step.hpp"
#include "sim/solvers/solver.hpp"
#include "simd_meshes.hpp"
#include "sliced_stepping.hpp"

#include <gtest/gtest.h>
#include <cstdint>
#include <limits>

namespace drape::sim::simd {
namespace {

using testing::everything;
using testing::largestDifference;
using testing::membersBy;
using testing::pinnedCloth;
using testing::shaken;
using testing::Turns;

/// Some iterations of a step, share by share and phase by phase, on the calling thread.
template <typename T>
std::uint64_t hashOfIterations(const ClothModel& model, int members, Turns turns) {
  SlicedCloth<T> cloth(model);
  ConjugateGradients<T> system(cloth.layout);
  const SliceStep<T> step = sliceStepOf<T>(everything(), {});
  cloth.prepare(members, 0);
  const auto each = [&](auto&& visit) {
    for (const int member : membersBy(turns, members)) {
      visit(blockShareOf(cloth.layout, member, members));
    }
  };
  const auto phase = [&](ConjugatePhase part, double factor) {
    each([&](const StepShare& share) { conjugatePhase(cloth, system, step, share, part, static_cast<T>(factor)); });
  };
  ClothState state = shaken(model, 0.002, 3);
  each([&](const StepShare& share) { cloth.load(state, share); });
  phase(ConjugatePhase::Start, 0.0);
  for (int iteration = 0; iteration < 4; ++iteration) {
    const double descent = system.descent();
    phase(ConjugatePhase::Multiply, 0.0);
    phase(ConjugatePhase::Descend, descent / system.curvature());
    phase(ConjugatePhase::Turn, system.descent() / descent);
  }
  phase(ConjugatePhase::Advance, 0.0);
  each([&](const StepShare& share) { cloth.store(state, share); });
  EXPECT_TRUE(isFinite(state));
  return stateHash(state);
}

TEST(ConjugateGradients, haveTheSameBitsForAnyNumberOfSharesTakenInAnyOrder) {
  for (const ClothMesh& mesh : {testing::sheet(57), testing::renumbered(testing::unevenSheet(45, 3), 4)}) {
    const auto model = pinnedCloth(mesh);
    const auto single = hashOfIterations<float>(*model, 1, Turns::Forwards);
    const auto twice = hashOfIterations<double>(*model, 1, Turns::Forwards);
    EXPECT_NE(single, twice);
    for (const int members : {2, 3, 5}) {
      for (const Turns turns : {Turns::Backwards, Turns::EveryOther}) {
        EXPECT_EQ(hashOfIterations<float>(*model, members, turns), single) << members << " shares";
        EXPECT_EQ(hashOfIterations<double>(*model, members, turns), twice) << members << " shares";
      }
    }
  }
}

TEST(ConjugateGradients, giveEveryBlockToOneShare) {
  const SliceLayout layout = buildSliceLayout(*pinnedCloth(testing::sheet(45)));
  for (const int members : {1, 2, 3, 8, 50}) {
    int next = 0;
    for (int member = 0; member < members; ++member) {
      const StepShare share = blockShareOf(layout, member, members);
      EXPECT_EQ(share.begin, next);
      EXPECT_TRUE(share.begin % blockSlices == 0 || share.begin == layout.slices());
      next = share.end;
    }
    EXPECT_EQ(next, layout.slices());
  }
}

/// Positions in float are accurate to 6e-8 m, so a spring's force is accurate to 6e-8 m times its stiffness. That is
/// what a solve in float leaves of the velocity change: 1e-5 of it in ordinary cloth, 3e-4 at 1e5 N/m.
TEST(ConjugateGradients, inFloatComeAsNearToTheSolutionAsInDoubleUpToRounding) {
  for (const double stiffness : {10.0, 1e3, 1e5}) {
    const auto model = pinnedCloth(testing::unevenSheet(21, 3));
    StepParameters parameters = everything();
    parameters.material.stiffness = stiffness;
    parameters.iteration.tolerance = 1e-6;
    const ClothState start = shaken(*model, 0.002, 7);
    ClothState exact = start;
    ClothState single = start;
    findSolver("pcg")->make()->step(*model, parameters, {}, exact);
    parameters.precision = Precision::Float;
    EXPECT_TRUE(findSolver("pcg")->make()->step(*model, parameters, {}, single).converged);
    double change = 0.0;
    for (std::size_t v = 0; v < start.velocities.size(); ++v) {
      change = std::max(change, (exact.velocities[v] - start.velocities[v]).norm());
    }
    double difference = 0.0;
    for (std::size_t v = 0; v < start.velocities.size(); ++v) {
      difference = std::max(difference, (exact.velocities[v] - single.velocities[v]).norm());
    }
    EXPECT_GT(difference, 0.0) << "it should have been float";
    EXPECT_LT(difference, (stiffness > 1e4 ? 1e-3 : 5e-5) * change) << stiffness;
  }
}

}  // namespace
}  // namespace drape::sim::simd
