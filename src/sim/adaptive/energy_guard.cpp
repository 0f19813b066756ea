#include "sim/adaptive/energy_guard.hpp"

#include "sim/inner_motion.hpp"
#include "sim/pieces.hpp"
#include "sim/simd/convert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace drape {
namespace {

std::uint64_t bitsOf(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

std::uint64_t sumOf(const std::vector<Vec3>& vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return vectors.empty() ? 0 : sumOfBits(vectors.front().data(), 3 * vectors.size());
}

/// Mass times height, in four sums, since in one each addition would wait for the one before.
double momentOf(const ClothModel& model, const ClothState& state) {
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> sums{};
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    sums[i % lanes] += model.vertexMass[i] * state.positions[i].y();
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// That the energy at the ends of steps may rise by, of all there is [-].
constexpr double mostRise = 0.004;

/// Of all that the energy depends on but the plan.
std::uint64_t markOf(const ClothModel& model, const StepParameters& parameters, const ClothState& state) {
  return sumOf(state.positions) + 7 * sumOf(state.velocities) + bitsOf(parameters.stiffness) +
         3 * bitsOf(parameters.gravity) + 5 * bitsOf(parameters.timeStep) + 7 * bitsOf(model.unitFrequency);
}

std::uint64_t markOf(const StepPlan& plan) {
  return plan.softens ? bitsOf(plan.carried) + static_cast<std::uint64_t>(plan.substeps) : 0;
}

/// Cloth at rest that nothing pulls at has no energy at all that a growth could be held against, but that of rounding:
/// of springs that are off by the last bit of their places, and what that heats up in a step (roundingHeats). Where
/// gravity pulls, its work is far above.
double roundingIn(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                  const ClothState& state, double roundoff) {
  constexpr double leastFall = 1e-2;  // [m^2/s^2]
  constexpr double heatOfSubstep = 0.02;
  constexpr double heldAgainst = 1000.0;  // growth may be a hundredth, and rounding ten times as much as this
  if (parameters.gravity * rates.diagonal > leastFall) {
    return 0.0;
  }
  const double off = roundoff * farthestOf(state.positions);
  const double hardness = parameters.timeStep * std::sqrt(parameters.stiffness * rates.most);
  const double springs = parameters.stiffness * static_cast<double>(model.springs.size()) * off * off;
  const double heat = heatOfSubstep * rates.mass * parameters.stiffness * rates.most * off * off * (1.0 + hardness);
  return heldAgainst * (springs + heat);
}

}  // namespace

double mostWorkOfWind(const LocalRates& rates, const StepParameters& parameters) {
  return mostForceOfWind(rates, parameters) * parameters.wind.norm() * parameters.timeStep;
}

double slowDown(const ClothModel& model, const std::vector<std::vector<std::size_t>>& freePieces, double energy,
                ClothState& state) {
  if (energy <= 0.0) {
    return 0.0;
  }
  const InnerMotion inner(model, freePieces, state);
  const double left = std::max(0.0, inner.energy() - energy);
  inner.scale(inner.energy() > 0.0 ? std::sqrt(left / inner.energy()) : 0.0, state);
  return inner.energy() - left;
}

void EnergyGuard::begin(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                        const ClothState& state, double roundoff) {
  lifted_ = parameters.gravity * momentOf(model, state);
  weight_ = parameters.gravity * rates.mass * rates.diagonal;
  rounding_ = roundingIn(model, rates, parameters, state, roundoff);
  mark_ = markOf(model, parameters, state);
  windy_ = mostWorkOfWind(rates, parameters) > 0.0;
  fades_ = parameters.damping != 0.0 || parameters.drag != 0.0 || parameters.lift != 0.0;
}

bool EnergyGuard::knowsStart(const StepPlan& plan, const StepMemory& memory) const {
  return memory.mark == mark_ + markOf(plan);
}

bool EnergyGuard::isDue(const StepPlan& plan, const StepMemory& memory) const {
  constexpr double passesALook = 24.0;
  constexpr double calm = 0.5;  // of what it may rise by
  const int every = std::max(1, static_cast<int>(passesALook / plan.cost()));
  return memory.steps % every == 0 || windy_ || memory.caution > 0 || !knowsStart(plan, memory) ||
         memory.risen > calm * mostRise * scaleOf(memory.energy, 1.0);
}

/// What growth is held against [J]: the motion and tension that there are, and what falling sets free.
double EnergyGuard::scaleOf(double startEnergy, double ofFall) const {
  return std::max(0.0, startEnergy - lifted_) + ofFall * weight_ + rounding_;
}

bool EnergyGuard::grew(const StepEnergy& energy, double work, bool again, StepMemory& memory) const {
  constexpr double inAll = 0.01;
  constexpr double inOneStep = 0.002;
  constexpr double ofFall = 0.1;
  constexpr double outOfHand = 0.05;  // at the ends: more than should be taken out of the motion
  const double growth = energy.last - energy.first;
  if (!std::isfinite(growth) || !std::isfinite(energy.end)) {
    return true;
  }
  if (energy.ends && memory.risen + energy.end - energy.start - work > outOfHand * scaleOf(energy.start, 1.0)) {
    return true;
  }
  if (growth <= 0.0) {
    memory.gained = std::max(0.0, memory.gained + growth);
    return false;
  }
  const double unexplained = growth - work;
  const double scale = scaleOf(energy.first, ofFall);
  if (unexplained > (again ? inOneStep * scale : inAll * scale - memory.gained)) {
    return true;
  }
  memory.gained = again ? 0.0 : std::max(0.0, memory.gained + unexplained);
  return false;
}

void EnergyGuard::book(const ClothModel& model, const StepParameters& parameters, const StepPlan& plan,
                       const StepEnergy& energy, double work, ClothState& state) {
  StepMemory& memory = state.memory;
  memory.mark = markOf(model, parameters, state) + markOf(plan);
  if (!energy.ends) {
    return;
  }
  const double room = mostRise * scaleOf(energy.start, 1.0);
  memory.risen += energy.end - energy.start - work;
  if (fades_ || work > 0.0) {
    memory.risen = std::max(0.0, memory.risen);
  }
  const double taken = slowDown(model, pieces_.get(model, freePieces), memory.risen - room, state);
  memory.risen -= taken;
  memory.energy = energy.end - taken;
  if (taken > 0.0) {
    memory.mark = markOf(model, parameters, state) + markOf(plan);
  }
}

}  // namespace drape
