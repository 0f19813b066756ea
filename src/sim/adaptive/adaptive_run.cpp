#include "sim/adaptive/adaptive_run.hpp"

#include "sim/adaptive/lane_sum.hpp"
#include "sim/adaptive/slot_stiffness.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/seconds_since.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <span>

namespace drape::sim::adaptive {
namespace {

/// A kick and the drift after it, as fractions of the substep.
struct Stage {
  double kick;
  double drift;
};

constexpr std::array verletStages{Stage{1.0, 0.5}};
constexpr double verletStart = 0.5;

/// The position-extended Forest-Ruth-like scheme (Omelyan, Mryglod and Folk, 2002, eq. 20), with its xi, lambda, chi.
constexpr double xi = 0.1786178958448091;
constexpr double lambda = -0.2123418310626054;
constexpr double chi = -0.06626458266981849;
constexpr std::array pefrlStages{Stage{0.5 - lambda, chi}, Stage{lambda, 1.0 - 2.0 * (chi + xi)}, Stage{lambda, chi},
                                 Stage{0.5 - lambda, xi}};

std::span<const Stage> stagesOf(ExplicitScheme scheme) {
  return scheme == ExplicitScheme::Pefrl ? std::span<const Stage>(pefrlStages) : std::span<const Stage>(verletStages);
}

/// Number of substeps between two checks for a stop, with one thread. Several threads do not check: if one thread
/// stopped, the others would wait for it at the barrier without end.
constexpr int stopCheckInterval = 64;

/// The weight in a substep of a force that acts in the middle one of each `interval` substeps, with the impulse of all
/// of them. The sequence is the same backwards, so the scheme stays of second order and reversible.
int weightOf(int interval, int substep) {
  return substep % interval == interval / 2 ? interval : 0;
}

double startOf(ExplicitScheme scheme) {
  return scheme == ExplicitScheme::Pefrl ? xi : verletStart;
}

/// Kicks do not change the velocity of a pin, so it drifts evenly over the step.
template <typename T>
void setPinVelocities(const StepInputs& inputs, double timeStep, const simd::StepShare& share,
                      simd::SlicedCloth<T>& cloth) {
  if (inputs.movedPins == nullptr) {
    return;
  }
  for (const MovedPin& pin : *inputs.movedPins) {
    const int index = cloth.layout.indexOf[static_cast<std::size_t>(pin.vertex)];
    if (share.contains(index)) {
      const Vec3 velocity = pin.by / timeStep;
      cloth.velocity.set(static_cast<std::size_t>(index), static_cast<T>(velocity.x()), static_cast<T>(velocity.y()),
                         static_cast<T>(velocity.z()));
    }
  }
}

}  // namespace

template <typename T>
StepEnergy AdaptiveRun<T>::run(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                               const StepInputs& inputs, const StepPlan& plan, const ClothState& state,
                               EnergyRequest request) {
  cloth_ = &cloths_.get(model);
  step_ = simd::sliceStepOf<T>(parameters, {});
  // With so steep a slope the lift is that of eq. 20. At the jump it takes a value between those of both sides.
  constexpr double steep = 1e9;
  step_.liftRise = static_cast<T>((plan.fullLift ? steep : 1.0) * kernels::liftRise(parameters.air.density));
  const double substep = parameters.timeStep / plan.substeps;
  damping_ = {.timedDamping = static_cast<T>(substep * parameters.material.damping), .stages = plan.dampingStages};
  if (plan.dampingStages > 0) {
    prepareSplitDamping(model, rates);
  }
  clampStiffness(model, rates, parameters, plan);
  const auto lanes = static_cast<std::size_t>(cloth_->layout.slices()) * simd::sliceLanes;
  for (std::vector<T>* energy : {&firstEnergy_, &lastEnergy_, &startEnergy_, &endEnergy_}) {
    energy->resize(lanes);
  }
  visibleStart_.resize(request.start && plan.softens ? lanes : 0);
  visibleEnd_.resize(request.end && plan.softens ? lanes : 0);
  firstCoarse_ = lastCoarse_ = startCoarse_ = endCoarse_ = 0.0;
  contactWorkToLast_ = 0.0;
  const int threads = simd::usefulThreads(cloth_->layout, cloth_->fabric.has_value(), parameters.threads);
  cloth_->prepare(threads, 1);
  cloth_->chooseOrigin(state);
  contacts_.prepare(inputs, *cloth_);
  team_.run(threads, [&](int member) {
    const simd::StepShare share = simd::shareOf(cloth_->layout, 1, member, threads);
    cloth_->load(state, share);
    setPinVelocities(inputs, parameters.timeStep, share, *cloth_);
    contacts_.start(*cloth_, share);
    if (request.start) {
      team_.arriveAndWait();
      measure(plan, startEnergy_, startCoarse_, share);
      measureVisible(plan, visibleStart_, share);
    }
    move(model, inputs, plan, substep, share);
    if (request.end) {
      measure(plan, endEnergy_, endCoarse_, share);
      measureVisible(plan, visibleEnd_, share);
    }
  });
  const double ofOrigin = parameters.gravity * cloth_->origin.y() * model.totalMass();
  return {.first = sumOfLanes(firstEnergy_) + firstCoarse_ + ofOrigin,
          .last = sumOfLanes(lastEnergy_) + lastCoarse_ + ofOrigin,
          .start = request.start ? sumOfLanes(startEnergy_) + startCoarse_ + ofOrigin : 0.0,
          .end = request.end ? sumOfLanes(endEnergy_) + endCoarse_ + ofOrigin : 0.0,
          .ends = request.end,
          .visibleStart = visibleStart_.empty() ? 0.0 : sumOfLanes(visibleStart_) + ofOrigin,
          .visibleEnd = visibleEnd_.empty() ? 0.0 : sumOfLanes(visibleEnd_) + ofOrigin,
          .levels = startCoarse_,
          .contactWork = contacts_.work(),
          .contactWorkToLast = contactWorkToLast_};
}

/// The number of stages follows from the 99th percentile of the damping rates. The damping of faster springs, as at
/// slivers, is scaled down to what these stages allow.
template <typename T>
void AdaptiveRun<T>::prepareSplitDamping(const ClothModel& model, const LocalRates& rates) {
  step_.damping = T(0);
  step_.updatesVelocity = false;
  gain_.resize(cloth_->layout.slices(), false);
  damping_.gain = &gain_;
  const auto& scales = dampingScales_.get(model, [&](const ClothModel&) {
    std::vector<simd::SliceNumbers<T>> slots;
    const auto scaleOf = [&](double rate) { return std::min(1.0, rates.dampingPercentile99 / rate); };
    return fillSlots(*cloth_, rates.damping, scaleOf, slots) < 1.0 ? slots : std::vector<simd::SliceNumbers<T>>();
  });
  damping_.dampingScales = scales.empty() ? nullptr : scales.data();
}

template <typename T>
void AdaptiveRun<T>::clampStiffness(const ClothModel& model, const LocalRates& rates,
                                    const CommonParameters& parameters, const StepPlan& plan) {
  const double h = parameters.timeStep / plan.substeps;
  const StiffnessClamp wanted{plan.hOmegaLimit, h, parameters.material.stiffness, plan.usesCoarseLevels};
  StiffnessClamp& clamp = clamps_.get(model, [](const ClothModel&) { return StiffnessClamp{}; });
  if (!(clamp == wanted)) {
    double smallest = 1.0;
    if (plan.hOmegaLimit > 0.0) {
      const double maxRate = plan.hOmegaLimit * plan.hOmegaLimit / (h * h * parameters.material.stiffness);
      smallest = fillSlots(
          *cloth_, rates.frequencySquared, [&](double rate) { return std::min(1.0, maxRate / rate); },
          stiffnessScales_);
    }
    activeLevels_ = 0;
    if (plan.usesCoarseLevels) {
      motion_ = coarse_
                    .get(model,
                         [&](const ClothModel& own) {
                           return std::make_unique<CoarseMotion<T>>(buildCoarseLevels(own), own, *cloth_);
                         })
                    .get();
      activeLevels_ = motion_->setStiffness(parameters.material.stiffness,
                                            (1.0 - smallest) * parameters.material.stiffness, plan.hOmegaLimit, h);
    }
    clamp = wanted;
  }
  if (plan.hOmegaLimit > 0.0) {
    step_.stiffnessScales = stiffnessScales_.data();
  }
  if (activeLevels_ > 0) {
    step_.aggregates = motion_->aggregates();
    step_.aggregateAccelerations = &motion_->accelerations();
  }
}

/// All threads of the team run this together. The last drift of a substep and the first of the next are merged, unless
/// the attachment acts between them.
template <typename T>
void AdaptiveRun<T>::move(const ClothModel& model, const StepInputs& inputs, const StepPlan& plan, double substep,
                          const simd::StepShare& share) {
  const auto stages = stagesOf(plan.scheme);
  const double start = startOf(plan.scheme);
  double time = start * substep;  // of the positions
  simd::driftSlices(*cloth_, static_cast<T>(time), share);
  team_.arriveAndWait();
  for (int i = 0; i < plan.substeps; ++i) {
    if (share.first && share.last && i % stopCheckInterval == stopCheckInterval - 1) {
      checkStop(inputs);
    }
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const bool firstKick = i == 0 && s == 0;
      const bool lastKick = i + 1 == plan.substeps && s + 1 == stages.size();
      const bool between = s + 1 == stages.size() && !lastKick;
      const double drift = (stages[s].drift + (between ? start : 0.0)) * substep;
      simd::SliceStep<T> step = step_;
      step.timeStep = static_cast<T>(stages[s].kick * substep);
      step.airWeight = static_cast<T>(weightOf(plan.airInterval, i));
      step.bendingWeight = static_cast<T>(weightOf(plan.bendingInterval, i));
      step.energy = firstKick ? firstEnergy_.data() : lastKick ? lastEnergy_.data() : nullptr;
      kick(step, plan, static_cast<T>(inputs.attachment ? 0.0 : drift), firstKick ? &firstCoarse_ : &lastCoarse_,
           share);
      if (plan.dampingStages > 0 || inputs.attachment || !contacts_.any()) {
        team_.arriveAndWait();
      }
      if (plan.dampingStages > 0) {
        damp(inputs.attachment ? 0.0 : drift, share);
      }
      if (inputs.attachment) {
        if (share.member == 0) {
          simd::applyAttachmentImpulse(model, stages[s].kick * substep, *inputs.attachment, *cloth_);
        }
        team_.arriveAndWait();
        simd::driftSlices(*cloth_, static_cast<T>(drift), share);
        team_.arriveAndWait();
      }
      time += drift;
      resolveContacts(time, drift, lastKick, share);
    }
  }
}

/// Its threads do not wait for each other at the end.
template <typename T>
void AdaptiveRun<T>::kick(const simd::SliceStep<T>& step, const StepPlan& plan, T drift, double* coarseEnergy,
                          const simd::StepShare& share) {
  if (activeLevels_ > 0 && plan.usesCoarseLevels) {
    if (share.member == 0) {
      motion_->accelerate(*cloth_, step.energy != nullptr);
      if (step.energy != nullptr) {
        *coarseEnergy = motion_->energy();
      }
    }
    team_.arriveAndWait();
  }
  const int phases = share.first && share.last ? 1 : 2;
  for (int phase = 0; phase < phases; ++phase) {
    if (phase > 0) {
      team_.arriveAndWait();
    }
    simd::verletPhase(*cloth_, step, drift, share, phase);
  }
}

/// The damping stages and the drift after a kick that left its velocities in `start`.
template <typename T>
void AdaptiveRun<T>::damp(double drift, const simd::StepShare& share) {
  for (int stage = 1; stage <= damping_.stages; ++stage) {
    simd::dampingStage(*cloth_, damping_, stage, share);
    team_.arriveAndWait();
  }
  simd::driftSlices(*cloth_, static_cast<T>(drift), share);
  team_.arriveAndWait();
}

/// All threads of the team run this together, after a drift that ends at `time` after the start of the step [s].
template <typename T>
void AdaptiveRun<T>::resolveContacts(double time, double drift, bool isLast, const simd::StepShare& share) {
  if (!contacts_.any()) {
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  if (isLast) {
    if (share.member == 0) {
      contactWorkToLast_ = contacts_.work();
    }
    team_.arriveAndWait();
  }
  contacts_.applySingle(*cloth_, time, drift, share);
  team_.arriveAndWait();
  if (contacts_.anyCoupled()) {
    contacts_.applyCoupled(*cloth_, time, drift, share);
    team_.arriveAndWait();
  }
  contacts_.addWork(share);
  if (share.member == 0) {
    contactSeconds_ += secondsSince(begin);
  }
}

/// The energy of the present state, by a kick of zero duration, which changes nothing.
template <typename T>
void AdaptiveRun<T>::measure(const StepPlan& plan, std::vector<T>& energy, double& coarseEnergy,
                             const simd::StepShare& share) {
  simd::SliceStep<T> still = step_;
  still.timeStep = T(0);
  still.damping = still.drag = still.lift = T(0);
  still.updatesVelocity = true;
  if (!plan.softens) {
    still.stiffnessScales = nullptr;
  }
  still.energy = energy.data();
  kick(still, plan, T(0), &coarseEnergy, share);
  team_.arriveAndWait();
}

/// The energy that the present state would have with the full stiffness. @param energy empty if no springs are softened
template <typename T>
void AdaptiveRun<T>::measureVisible(StepPlan plan, std::vector<T>& energy, const simd::StepShare& share) {
  if (energy.empty()) {
    return;
  }
  simd::SliceStep<T> still = step_;
  still.timeStep = T(0);
  still.damping = still.drag = still.lift = T(0);
  still.updatesVelocity = true;
  still.stiffnessScales = nullptr;
  still.aggregates = nullptr;
  still.aggregateAccelerations = nullptr;
  still.energy = energy.data();
  plan.usesCoarseLevels = false;
  double none = 0.0;
  kick(still, plan, T(0), &none, share);
  team_.arriveAndWait();
}

template <typename T>
void AdaptiveRun<T>::store(ClothState& state) {
  cloth_->store(state, simd::shareOf(cloth_->layout, 1, 0, 1));
}

template <typename T>
void AdaptiveRun<T>::storeContacts(const StepInputs& inputs) const {
  if (inputs.contacts != nullptr) {
    contacts_.store(*inputs.contacts);
  }
}

template class AdaptiveRun<float>;
template class AdaptiveRun<double>;

}  // namespace drape::sim::adaptive
