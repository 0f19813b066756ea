#include "sim/adaptive/settling.hpp"

#include "sim/adaptive/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::adaptive {
namespace {

void beginInterval(const ClothState& state, StepMemory& memory) {
  memory.settlingReference = std::make_shared<const std::vector<Vec3>>(state.positions);
  memory.settlingReferenceTime = state.time;
}

/// Whether the reference belongs to this motion of the cloth.
bool hasReference(const ClothState& state, const StepMemory& memory) {
  return memory.settlingReference != nullptr && memory.settlingReference->size() == state.positions.size() &&
         state.time >= memory.settlingReferenceTime;
}

/// Counts the intervals in which the cloth hardly moved. Settling ends as soon as it moves.
void updateIntervals(double tolerance, const ClothState& state, StepMemory& memory) {
  if (!hasReference(state, memory)) {
    memory.slowIntervals = 0;
    beginInterval(state, memory);
    return;
  }
  const bool isOver = state.time >= memory.settlingReferenceTime + tuning.settlingInterval;
  if (!isOver && !isSettling(memory)) {
    return;
  }
  if (!hardlyMoved(*memory.settlingReference, state.positions, tolerance)) {
    memory.slowIntervals = 0;
    beginInterval(state, memory);
  } else if (isOver) {
    memory.slowIntervals = std::min(memory.slowIntervals + 1, tuning.settlingIntervals);
    beginInterval(state, memory);
  }
}

}  // namespace

bool isSettling(const StepMemory& memory) {
  return memory.slowIntervals == tuning.settlingIntervals;
}

bool hardlyMoved(const std::vector<Vec3>& before, const std::vector<Vec3>& positions, double distance) {
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double moved = (positions[v] - before[v]).norm();
    sum += moved;
    largest = std::max(largest, moved);
  }
  return sum < distance * static_cast<double>(positions.size()) && largest < tuning.maxSettlingRatio * distance;
}

double settle(const ClothModel& model, const SleepConditions& conditions, StepMemory& memory, ClothState& state) {
  if (conditions.inputs.contacts == nullptr || !isUndisturbed(conditions)) {
    memory.settlingReference.reset();
    memory.slowIntervals = 0;
    return 0.0;
  }
  updateIntervals(conditions.errorTolerance, state, memory);
  if (!isSettling(memory)) {
    return 0.0;
  }
  const double factor = std::exp(-conditions.parameters.timeStep / tuning.settlingTime);
  double energy = 0.0;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    energy += 0.5 * model.vertexMass[v] * state.velocities[v].squaredNorm();
    state.velocities[v] *= factor;
  }
  return (factor * factor - 1.0) * energy;
}

}  // namespace drape::sim::adaptive
