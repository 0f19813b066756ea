#include "sim/adaptive/step_memory.hpp"

#include <utility>

namespace drape::sim::adaptive {
namespace {

struct AdaptiveMemory final : SolverMemory {
  explicit AdaptiveMemory(StepMemory all) : values(std::move(all)) {}

  StepMemory values;
};

}  // namespace

StepMemory stepMemoryOf(const ClothState& state) {
  const auto* const memory = dynamic_cast<const AdaptiveMemory*>(state.memory.get());
  return memory == nullptr ? StepMemory{} : memory->values;
}

void storeStepMemory(StepMemory memory, ClothState& state) {
  state.memory = std::make_shared<const AdaptiveMemory>(std::move(memory));
}

}  // namespace drape::sim::adaptive
