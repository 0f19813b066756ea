#include "sim/adaptive/adaptive_run.hpp"

#include "sim/adaptive/lane_sum.hpp"
#include "sim/adaptive/slot_stiffness.hpp"
#include "sim/kernels.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace drape {
namespace {

/// A kick and the drift after it, as parts of the substep.
struct Stage {
  double kick;
  double drift;
};

constexpr std::array verletStages{Stage{1.0, 0.5}};
constexpr double verletStart = 0.5;

/// Position extended Forest-Ruth like, eq. 20 of the paper with its values of xi, lambda and chi.
constexpr double xi = 0.1786178958448091;
constexpr double lambda = -0.2123418310626054;
constexpr double chi = -0.06626458266981849;
constexpr std::array pefrlStages{Stage{0.5 - lambda, chi}, Stage{lambda, 1.0 - 2.0 * (chi + xi)}, Stage{lambda, chi},
                                 Stage{0.5 - lambda, xi}};

std::span<const Stage> stagesOf(ExplicitScheme scheme) {
  return scheme == ExplicitScheme::Pefrl ? std::span<const Stage>(pefrlStages) : std::span<const Stage>(verletStages);
}

/// A thread that is alone may be ended after so many substeps; several would wait for the one that was.
constexpr int askEvery = 64;

double startOf(ExplicitScheme scheme) {
  return scheme == ExplicitScheme::Pefrl ? xi : verletStart;
}

}  // namespace

template <typename T>
StepEnergy AdaptiveRun<T>::run(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                               const StepInputs& inputs, const StepPlan& plan, const ClothState& state,
                               EnergyLooks looks) {
  cloth_ = &cloths_.get(model);
  step_ = sliceStepOf<T>(parameters);
  step_.liftRise = static_cast<T>(kernels::liftRise(parameters.airDensity));
  const double substep = parameters.timeStep / plan.substeps;
  damping_ = {.timedDamping = static_cast<T>(substep * parameters.damping), .stages = plan.dampingStages};
  if (plan.dampingStages > 0) {
    dampBeside(model, rates);
  }
  hold(model, rates, parameters, plan);
  const auto places = static_cast<std::size_t>(cloth_->layout.slices()) * sliceLanes;
  for (std::vector<T>* energy : {&firstEnergy_, &lastEnergy_, &startEnergy_, &endEnergy_}) {
    energy->resize(places);
  }
  firstCoarse_ = lastCoarse_ = startCoarse_ = endCoarse_ = 0.0;
  const int threads = usefulThreads(cloth_->layout, parameters.threads);
  cloth_->prepare(threads, 1);
  team_.run(threads, [&](int member) {
    const StepShare share = shareOf(cloth_->layout, 1, member, threads);
    cloth_->load(state, share);
    if (looks.start) {
      team_.meet();
      measure(plan, startEnergy_, startCoarse_, share);
    }
    move(model, inputs, plan, substep, share);
    if (looks.end) {
      measure(plan, endEnergy_, endCoarse_, share);
    }
  });
  return {.first = sumOfLanes(firstEnergy_) + firstCoarse_,
          .last = sumOfLanes(lastEnergy_) + lastCoarse_,
          .start = looks.start ? sumOfLanes(startEnergy_) + startCoarse_ : 0.0,
          .end = looks.end ? sumOfLanes(endEnergy_) + endCoarse_ : 0.0,
          .ends = looks.end};
}

/// A few slivers slow nobody else down: they are damped as the stages bear that the others need.
template <typename T>
void AdaptiveRun<T>::dampBeside(const ClothModel& model, const LocalRates& rates) {
  step_.damping = T(0);
  step_.settles = false;
  gain_.resize(cloth_->layout.slices(), false);
  damping_.gain = &gain_;
  const auto& shares = dampingShares_.get(model, [&](const ClothModel&) {
    std::vector<SliceNumbers<T>> slots;
    const auto share = [&](double rate) { return std::min(1.0, rates.mostDamping / rate); };
    return fillSlots(*cloth_, rates.damping, share, slots) < 1.0 ? slots : std::vector<SliceNumbers<T>>();
  });
  damping_.shares = shares.empty() ? nullptr : shares.data();
}

template <typename T>
void AdaptiveRun<T>::hold(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                          const StepPlan& plan) {
  const double h = parameters.timeStep / plan.substeps;
  const Holding wanted{plan.carried, h, parameters.stiffness, plan.levels};
  Holding& holding = holdings_.get(model, [](const ClothModel&) { return Holding{}; });
  if (!(holding == wanted)) {
    double smallest = 1.0;
    if (plan.carried > 0.0) {
      const double most = plan.carried * plan.carried / (h * h * parameters.stiffness);
      smallest = fillSlots(
          *cloth_, rates.unit, [&](double rate) { return std::min(1.0, most / rate); }, shares_);
    }
    levelsAtWork_ = 0;
    if (plan.levels) {
      motion_ = coarse_
                    .get(model,
                         [&](const ClothModel& own) {
                           return std::make_unique<CoarseMotion<T>>(buildCoarseLevels(own), own, *cloth_);
                         })
                    .get();
      levelsAtWork_ =
          motion_->setStiffness(parameters.stiffness, (1.0 - smallest) * parameters.stiffness, plan.carried, h);
    }
    holding = wanted;
  }
  if (plan.carried > 0.0) {
    step_.shares = shares_.data();
  }
  if (levelsAtWork_ > 0) {
    step_.groups = motion_->groups();
    step_.pushes = &motion_->pushes();
  }
}

/// All members of the team go through this together. The second part of a drift and the first of the next are one,
/// unless the hand comes in between.
template <typename T>
void AdaptiveRun<T>::move(const ClothModel& model, const StepInputs& inputs, const StepPlan& plan, double substep,
                          const StepShare& share) {
  const auto stages = stagesOf(plan.scheme);
  const double start = startOf(plan.scheme);
  driftSlices(*cloth_, static_cast<T>(start * substep), share);
  team_.meet();
  for (int i = 0; i < plan.substeps; ++i) {
    if (inputs.mayStop != nullptr && share.first && share.last && i % askEvery == askEvery - 1) {
      (*inputs.mayStop)();
    }
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const bool firstKick = i == 0 && s == 0;
      const bool lastKick = i + 1 == plan.substeps && s + 1 == stages.size();
      const bool between = s + 1 == stages.size() && !lastKick;
      const double drift = (stages[s].drift + (between ? start : 0.0)) * substep;
      SliceStep<T> step = step_;
      step.timeStep = static_cast<T>(stages[s].kick * substep);
      step.energy = firstKick ? firstEnergy_.data() : lastKick ? lastEnergy_.data() : nullptr;
      kick(step, plan, static_cast<T>(inputs.attachment ? 0.0 : drift), firstKick ? &firstCoarse_ : &lastCoarse_,
           share);
      if (plan.dampingStages > 0) {
        damp(inputs.attachment ? 0.0 : drift, share);
      }
      if (inputs.attachment) {
        if (share.member == 0) {
          applyAttachmentImpulse(model, stages[s].kick * substep, *inputs.attachment, *cloth_);
        }
        team_.meet();
        driftSlices(*cloth_, static_cast<T>(drift), share);
        team_.meet();
      }
    }
  }
}

template <typename T>
void AdaptiveRun<T>::kick(const SliceStep<T>& step, const StepPlan& plan, T drift, double* coarseEnergy,
                          const StepShare& share) {
  if (levelsAtWork_ > 0 && plan.levels) {
    if (share.member == 0) {
      motion_->accelerate(*cloth_, step.energy != nullptr);
      if (step.energy != nullptr) {
        *coarseEnergy = motion_->energy();
      }
    }
    team_.meet();
  }
  const int phases = share.first && share.last ? 1 : 2;
  for (int phase = 0; phase < phases; ++phase) {
    verletPhase(*cloth_, step, drift, share, phase);
    team_.meet();
  }
}

/// After a kick that has not settled.
template <typename T>
void AdaptiveRun<T>::damp(double drift, const StepShare& share) {
  for (int stage = 1; stage <= damping_.stages; ++stage) {
    dampingStage(*cloth_, damping_, stage, share);
    team_.meet();
  }
  driftSlices(*cloth_, static_cast<T>(drift), share);
  team_.meet();
}

/// A kick that lasts no time changes nothing and tells the energy of the cloth as it stands.
template <typename T>
void AdaptiveRun<T>::measure(const StepPlan& plan, std::vector<T>& energy, double& coarseEnergy,
                             const StepShare& share) {
  SliceStep<T> still = step_;
  still.timeStep = T(0);
  still.damping = still.drag = still.lift = T(0);
  still.settles = true;
  if (!plan.softens) {
    still.shares = nullptr;
  }
  still.energy = energy.data();
  kick(still, plan, T(0), &coarseEnergy, share);
}

template <typename T>
void AdaptiveRun<T>::store(ClothState& state) {
  cloth_->store(state, shareOf(cloth_->layout, 1, 0, 1));
}

template class AdaptiveRun<float>;
template class AdaptiveRun<double>;

}  // namespace drape
