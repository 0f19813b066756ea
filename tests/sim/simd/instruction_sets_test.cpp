#include "sim/solvers/solver.hpp"
#include "simd_meshes.hpp"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace drape::sim::simd {
namespace {

using testing::largestDifference;
using testing::pinnedCloth;

/// Lets steps use one set of vector instructions alone, for as long as it lives.
class OnlyInstructions {
 public:
  explicit OnlyInstructions(std::int64_t target) { use(target); }
  OnlyInstructions(const OnlyInstructions&) = delete;
  OnlyInstructions& operator=(const OnlyInstructions&) = delete;
  ~OnlyInstructions() { use(0); }

 private:
  static void use(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

constexpr std::int64_t fused = HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL;

/// The sets that have been built and that this machine has; with fused multiply-add, or without.
std::vector<std::int64_t> instructionSets(bool withFused) {
  std::vector<std::int64_t> sets;
  const std::int64_t there = hwy::SupportedTargets() & HWY_TARGETS;
  for (std::int64_t bit = 1; bit > 0 && bit <= there; bit <<= 1) {
    if ((there & bit) != 0 && ((bit & fused) != 0) == withFused) {
      sets.push_back(bit);
    }
  }
  return sets;
}

struct Kind {
  std::string solver;
  int sweeps = 1;
  Precision precision = Precision::Float;
  ForceDerivative derivative = ForceDerivative::Stabilised;
  double damping = testing::windyStep().material.damping;  // [N s/m]
  bool levels = false;  // springs so stiff for the cost budget that coarse levels are used
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    all.push_back({"one_iteration", 1, precision});
    all.push_back({"one_iteration", 3, precision});
    for (const ForceDerivative derivative : testing::allDerivatives) {
      all.push_back({"one_iteration", 1, precision, derivative});
    }
    all.push_back({"chebyshev", 3, precision});
    all.push_back({"verlet", 1, precision});
    all.push_back({"pcg", 1, precision});
    all.push_back({"xpbd", 1, precision});
    all.push_back({.solver = "auto", .precision = precision});
    all.push_back({.solver = "auto", .precision = precision, .damping = 0.1});
    all.push_back({.solver = "auto", .precision = precision, .levels = true});
  }
  return all;
}

ClothState stepsWith(const Kind& kind, const ClothModel& model, int steps) {
  StepParameters parameters = testing::windyStep();
  parameters.jacobi.sweeps = kind.sweeps;
  parameters.precision = kind.precision;
  parameters.derivative = kind.derivative;
  parameters.material.damping = kind.damping;
  if (kind.levels) {
    parameters.material.stiffness = 5e3;
    parameters.automatic.costBudget = 0.001;
    parameters.automatic.soften = true;
  }
  StepInputs inputs;
  inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {20.0, 2.0}};
  ClothState state = testing::shaken(model, 0.003, 3);
  findSolver(kind.solver)->make()->steps(model, parameters, inputs, steps, state);
  EXPECT_TRUE(isFinite(state));
  return state;
}

std::vector<std::shared_ptr<const ClothModel>> models() {
  return {pinnedCloth(testing::sheet(15)), pinnedCloth(testing::renumbered(testing::unevenSheet(13, 3), 4))};
}

TEST(InstructionSets, giveTheSameBitsWhereTheyHaveFusedMultiplyAdd) {
  const auto sets = instructionSets(true);
  if (sets.size() < 2) {
    GTEST_SKIP() << "this machine has " << sets.size() << " of them";
  }
  for (const auto& model : models()) {
    for (const Kind& kind : kinds()) {
      std::uint64_t first = 0;
      for (const std::int64_t set : sets) {
        const OnlyInstructions only(set);
        const std::uint64_t hash = stateHash(stepsWith(kind, *model, 5));
        first = set == sets.front() ? hash : first;
        EXPECT_EQ(hash, first) << kind.solver << ", " << kind.sweeps << " sweeps, " << hwy::TargetName(set);
      }
    }
  }
}

TEST(InstructionSets, agreeWithinRoundingWhereTheyHaveNone) {
  const auto sets = instructionSets(false);
  const auto fusedSets = instructionSets(true);
  if (sets.empty() || fusedSets.empty()) {
    GTEST_SKIP() << "there is nothing to compare on this machine";
  }
  for (const auto& model : models()) {
    for (const Kind& kind : kinds()) {
      const OnlyInstructions best(fusedSets.front());
      const ClothState expected = stepsWith(kind, *model, 1);
      for (const std::int64_t set : sets) {
        const OnlyInstructions only(set);
        const ClothState state = stepsWith(kind, *model, 1);
        const double rounding = kind.precision == Precision::Float ? 2e-4 : 1e-12;
        EXPECT_LT(largestDifference(state, expected), kind.levels ? 10.0 * rounding : rounding)
            << kind.solver << ", " << kind.sweeps << " sweeps, " << hwy::TargetName(set);
        if (kind.solver == "one_iteration") {
          EXPECT_NE(stateHash(state), stateHash(expected)) << "the other instructions should have been used";
        }
      }
    }
  }
}

TEST(InstructionSets, areRestoredAfterATest) {
  const std::int64_t before = hwy::SupportedTargets();
  {
    const OnlyInstructions only(HWY_SSSE3);
    EXPECT_NE(hwy::SupportedTargets(), before);
  }
  EXPECT_EQ(hwy::SupportedTargets(), before);
}

}  // namespace
}  // namespace drape::sim::simd
