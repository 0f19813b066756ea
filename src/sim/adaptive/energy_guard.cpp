#include "sim/adaptive/energy_guard.hpp"

#include "sim/adaptive/tuning.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/model/pieces.hpp"
#include "sim/motion/inner_motion.hpp"
#include "sim/motion/stretching_motion.hpp"
#include "sim/simd/convert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace drape::sim::adaptive {
namespace {

std::uint64_t bitsOf(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

std::uint64_t sumOf(const std::vector<Vec3>& vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return vectors.empty() ? 0 : simd::sumOfBits(vectors.front().data(), 3 * vectors.size());
}

/// Sum of mass times height [kg m]. Four partial sums, since each addition to a single sum waits for the one before.
double massTimesHeight(const ClothModel& model, const ClothState& state) {
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> sums{};
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    sums[i % lanes] += model.vertexMass[i] * state.positions[i].y();
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// The kinetic energy of a cloth's motion as a whole, without rotation [J].
double translationEnergy(const ClothModel& model, const ClothState& state) {
  Vec3 momentum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    momentum += model.vertexMass[v] * state.velocities[v];
  }
  return 0.5 * momentum.squaredNorm() / model.totalMass();
}

/// The fingerprint of everything that the energy depends on, except the plan.
std::uint64_t fingerprintOf(const ClothModel& model, const CommonParameters& parameters, const ClothState& state) {
  return sumOf(state.positions) + 7 * sumOf(state.velocities) + bitsOf(parameters.material.stiffness) +
         3 * bitsOf(parameters.gravity) + 5 * bitsOf(parameters.timeStep) + 7 * bitsOf(model.unitFrequency) +
         (model.fabric ? 11 * model.fabric->fingerprint : 0);
}

/// The plan's part of the fingerprint.
std::uint64_t fingerprintOf(const StepPlan& plan) {
  return plan.softens ? bitsOf(plan.hOmegaLimit) + 2 * static_cast<std::uint64_t>(plan.substeps) +
                            (plan.usesCoarseLevels ? 1 : 0)
                      : 0;
}

/// The energy of rounding errors times a margin [J]; 0 with gravity, whose energy is far above it. Cloth at rest
/// without gravity has no other energy: springs deviate by the rounding of positions, each substep adds heat
/// (roundingAddsEnergy), and the terms of the bending energy do not cancel exactly. The guard needs it as a reference.
double roundingEnergyOf(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                        const ClothState& state, double roundoff, const Vec3& origin) {
  if (parameters.gravity * rates.diagonal > tuning.minGuardedFallEnergy) {
    return 0.0;
  }
  const double error = roundoff * maxCoordinate(state.positions, origin);  // of a position [m]
  const double hOmega = parameters.timeStep * std::sqrt(parameters.material.stiffness * rates.percentile99);
  const double springs = parameters.material.stiffness * static_cast<double>(model.springs.size()) * error * error;
  const double heat = tuning.roundingHeat * rates.mass * parameters.material.stiffness * rates.percentile99 * error *
                      error * (1.0 + hOmega);
  return tuning.roundingMargin * (springs + heat + roundoff * rates.bendingTerms);
}

}  // namespace

double maxWindWork(const LocalRates& rates, const CommonParameters& parameters) {
  return maxWindForce(rates, parameters) * parameters.air.wind.norm() * parameters.timeStep;
}

double removeInnerMotion(const ClothModel& model, const std::vector<std::vector<std::size_t>>& freePieces,
                         double energy, ClothState& state) {
  if (energy <= 0.0) {
    return 0.0;
  }
  const double stretching = removeStretchingMotion(model, energy, tuning.stretchingSweeps, state);
  if (stretching >= energy) {
    return energy;
  }
  const InnerMotion inner(model, freePieces, state);
  const double left = std::max(0.0, inner.energy() - (energy - stretching));
  inner.scale(inner.energy() > 0.0 ? std::sqrt(left / inner.energy()) : 0.0, state);
  return stretching + inner.energy() - left;
}

void EnergyGuard::prepare(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                          const ClothState& state, double roundoff, const Vec3& origin) {
  startPotential_ = parameters.gravity * massTimesHeight(model, state);
  fallEnergy_ = parameters.gravity * rates.mass * rates.diagonal;
  roundingEnergy_ = roundingEnergyOf(model, rates, parameters, state, roundoff, origin);
  fingerprint_ = fingerprintOf(model, parameters, state);
  maxWindWork_ = maxWindWork(rates, parameters);
  const bool isFree = rates.pinnedLength == 0.0;
  airEnergy_ = isFree && maxWindWork_ > 0.0 ? 0.5 * rates.mass * parameters.air.wind.squaredNorm() : 0.0;
  translation_ = isFree ? translationEnergy(model, state) : 0.0;
  roundingEnergy_ += tuning.kineticRounding * roundoff * translation_;
  dissipates_ = parameters.material.damping != 0.0 || parameters.air.acts();
}

bool EnergyGuard::isStartEnergyKnown(const StepPlan& plan, const StepMemory& memory) const {
  return memory.fingerprint == fingerprint_ + fingerprintOf(plan);
}

bool EnergyGuard::levelsStoreTooMuch(const ClothModel& model, const ClothState& state, double levels,
                                     bool motionExplains) const {
  const double explained = fallEnergy_ + airEnergy_;
  return levels > explained && (!motionExplains || levels > explained + kineticEnergy(model, state));
}

bool EnergyGuard::isMeasurementDue(const StepPlan& plan, const StepMemory& memory) const {
  const int every = std::max(1, static_cast<int>(tuning.evaluationsPerMeasurement / plan.cost()));
  return memory.steps % every == 0 || maxWindWork_ > 0.0 || memory.retryLevel > 0 ||
         !isStartEnergyKnown(plan, memory) ||
         memory.energyDrift > tuning.calmDriftFraction * tuning.maxEnergyDrift * referenceEnergy(memory.energy, 1.0);
}

/// Kinetic and elastic energy without that of the motion as a whole, which a fall makes arbitrarily large, a fraction
/// of the energy of a fall, and the energy of rounding. For free cloth in wind also the kinetic energy relative to the
/// air, because the wind's work follows from the motion relative to it.
double EnergyGuard::referenceEnergy(double startEnergy, double fallFraction) const {
  return std::max(0.0, startEnergy - startPotential_ - translation_) + fallFraction * fallEnergy_ + airEnergy_ +
         roundingEnergy_;
}

bool EnergyGuard::hasGrown(const StepEnergy& energy, double work, bool isRetry, StepMemory& memory) const {
  const double growth = energy.last - energy.first - energy.contactWorkToLast;
  if (!std::isfinite(growth) || !std::isfinite(energy.end) || !std::isfinite(energy.contactWork)) {
    return true;
  }
  const double visibleReference = referenceEnergy(energy.start, 1.0);
  // A larger drift could not be removed from the motion. No retry can remove it either.
  const double removable = std::min(memory.energyDrift, tuning.maxEnergyDrift * visibleReference);
  if (energy.ends &&
      removable + energy.end - energy.start - energy.contactWork - work > tuning.maxRemovedEnergy * visibleReference) {
    return true;
  }
  // In an unstable step velocities alternate in sign, and v.v' becomes negative without bound.
  if (growth < -referenceEnergy(energy.first, 1.0) - std::max(work, maxWindWork_)) {
    return true;
  }
  if (growth <= 0.0) {
    memory.schemeEnergyDrift = std::max(0.0, memory.schemeEnergyDrift + growth);
    return false;
  }
  const double unexplained = growth - work;
  const double reference = referenceEnergy(energy.first, tuning.fallEnergyFraction);
  if (unexplained > (isRetry ? tuning.maxSchemeDriftOfRetry * reference
                             : tuning.maxSchemeDrift * reference - memory.schemeEnergyDrift)) {
    return true;
  }
  memory.schemeEnergyDrift = isRetry ? 0.0 : std::max(0.0, memory.schemeEnergyDrift + unexplained);
  return false;
}

void EnergyGuard::store(const ClothModel& model, const CommonParameters& parameters, const StepPlan& plan,
                        const StepEnergy& energy, double work, StepMemory& memory, ClothState& state) {
  const bool continues = memory.fingerprint - memory.planFingerprint == fingerprint_;
  const double visibleStart = continues && memory.planFingerprint != 0 ? memory.visibleEnergy : energy.visibleStart;
  const bool changesStiffness =
      continues && plan.softens && memory.planFingerprint != 0 && memory.planFingerprint != fingerprintOf(plan);
  memory.planFingerprint = fingerprintOf(plan);
  if (!energy.ends) {
    memory.fingerprint = fingerprintOf(model, parameters, state) + memory.planFingerprint;
    return;
  }
  memory.stiffeningEnergy += changesStiffness ? energy.start - memory.energy : 0.0;
  memory.stiffeningEnergy = plan.softens ? memory.stiffeningEnergy : 0.0;
  const double allowed = tuning.maxEnergyDrift * referenceEnergy(energy.start, 1.0);
  memory.energyDrift += energy.end - energy.start - energy.contactWork - work;
  if (memory.energyDrift < 0.0 && memory.stiffeningEnergy > 0.0) {
    const double paid = std::min(-memory.energyDrift, memory.stiffeningEnergy);
    memory.energyDrift += paid;
    memory.stiffeningEnergy -= paid;
  }
  if (dissipates_ || work > 0.0) {
    memory.energyDrift = std::max(0.0, memory.energyDrift);
  }
  const double excess = std::max(0.0, memory.energyDrift - allowed);
  const double removed =
      removeInnerMotion(model, pieces_.get(model, freePieces), excess + std::max(0.0, memory.stiffeningEnergy), state);
  memory.energyDrift -= std::min(excess, removed);
  memory.stiffeningEnergy -= std::max(0.0, removed - excess);
  memory.energy = energy.end - removed;
  if (plan.softens) {
    limitVisibleDrift(model, energy, visibleStart, work, removed, memory, state);
  }
  memory.fingerprint = fingerprintOf(model, parameters, state) + memory.planFingerprint;
}

/// Adds an accepted step to the drift of the energy with the full stiffness, and removes energy from the rates of
/// stretch while that drift is too large. @param start that energy at the start  @param removed the energy that was
/// removed from the motion since the end of the step [J]
void EnergyGuard::limitVisibleDrift(const ClothModel& model, const StepEnergy& energy, double start, double work,
                                    double removed, StepMemory& memory, ClothState& state) const {
  memory.visibleDrift += energy.visibleEnd - removed - start - energy.contactWork - work;
  if (dissipates_ || work > 0.0) {
    memory.visibleDrift = std::max(0.0, memory.visibleDrift);
  }
  const double excess = memory.visibleDrift - tuning.maxVisibleDrift * referenceEnergy(start, 1.0);
  const double fromStretch = excess > 0.0 ? removeStretchingMotion(model, excess, tuning.visibleSweeps, state) : 0.0;
  memory.visibleEnergy = energy.visibleEnd - removed - fromStretch;
  memory.visibleDrift -= fromStretch;
  memory.energy -= fromStretch;
  memory.energyDrift -= fromStretch;
  if (dissipates_) {
    memory.energyDrift = std::max(0.0, memory.energyDrift);
  }
}

}  // namespace drape::sim::adaptive
