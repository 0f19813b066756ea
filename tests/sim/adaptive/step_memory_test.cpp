#include "sim/adaptive/step_memory.hpp"

#include "sim/solvers/registry.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <memory>

namespace drape::sim::adaptive {
namespace {

/// The memory of another solver.
struct OtherMemory final : SolverMemory {};

TEST(StepMemory, isNewInAStateWithoutOneOrWithThatOfAnotherSolver) {
  ClothState state;
  EXPECT_EQ(stepMemoryOf(state).steps, 0);
  EXPECT_LT(stepMemoryOf(state).error, 0.0) << "not known yet";
  state.memory = std::make_shared<const OtherMemory>();
  EXPECT_EQ(stepMemoryOf(state).steps, 0);
}

TEST(StepMemory, staysInACopyWhenTheStateGetsAnother) {
  ClothState state;
  storeStepMemory({.steps = 3}, state);
  const ClothState copy = state;
  storeStepMemory({.steps = 4}, state);
  EXPECT_EQ(stepMemoryOf(copy).steps, 3);
  EXPECT_EQ(stepMemoryOf(state).steps, 4);
}

TEST(StepMemory, makesACopyContinueToTheSameBits) {
  const auto model = testing::pinnedSheet(9);
  StepParameters parameters;
  parameters.material.damping = 0.01;
  const auto solver = findSolver("auto")->make();
  ClothState state = testing::shaken(*model, 0.01, 3);
  for (int i = 0; i < 5; ++i) {
    solver->step(*model, parameters, {}, state);
  }
  EXPECT_EQ(stepMemoryOf(state).steps, 5);
  ClothState copy = state;
  const auto other = findSolver("auto")->make();
  for (int i = 0; i < 20; ++i) {
    solver->step(*model, parameters, {}, state);
  }
  for (int i = 0; i < 20; ++i) {
    other->step(*model, parameters, {}, copy);
  }
  EXPECT_EQ(stateHash(copy), stateHash(state));
  EXPECT_EQ(stepMemoryOf(copy).forceEvaluations, stepMemoryOf(state).forceEvaluations);
}

}  // namespace
}  // namespace drape::sim::adaptive
