#include "sim/simd/sliced_run.hpp"

namespace drape::sim::simd {

void SlicedRun::oneIteration(const ClothModel& model, const CommonParameters& parameters, const JacobiOptions& jacobi,
                             const StepInputs& inputs, int count, const std::vector<double>& weights,
                             ClothState& state) {
  if (parameters.precision == Precision::Float) {
    oneIteration(model, single_.get(model), parameters, jacobi, inputs, count, weights, state);
  } else {
    oneIteration(model, double_.get(model), parameters, jacobi, inputs, count, weights, state);
  }
}

void SlicedRun::verlet(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs, int count,
                       ClothState& state) {
  if (parameters.precision == Precision::Float) {
    verlet(model, single_.get(model), parameters, inputs, count, state);
  } else {
    verlet(model, double_.get(model), parameters, inputs, count, state);
  }
}

void SlicedRun::explicitEuler(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                              int count, ClothState& state) {
  SlicedCloth<double>& cloth = double_.get(model);
  SliceStep<double> step = sliceStepOf<double>(parameters, {});
  step.driftsByOldVelocity = true;
  const int threads = usefulThreads(cloth.layout, cloth.fabric.has_value(), parameters.threads);
  cloth.prepare(threads, 1);
  cloth.chooseOrigin(state);
  team_.run(threads, [&](int member) {
    const StepShare share = shareOf(cloth.layout, 1, member, threads);
    cloth.load(state, share);
    team_.arriveAndWait();
    for (int i = 0; i < count; ++i) {
      for (int phase = 0; phase < (threads == 1 ? 1 : 2); ++phase) {
        verletPhase(cloth, step, step.timeStep, share, phase);
        team_.arriveAndWait();
      }
      if (inputs.attachment) {
        if (member == 0) {
          applyAttachmentImpulse(model, parameters.timeStep, *inputs.attachment, cloth);
        }
        team_.arriveAndWait();
      }
    }
    cloth.store(state, share);
  });
  state.time += count * parameters.timeStep;
}

template <typename T>
void SlicedRun::oneIteration(const ClothModel& model, SlicedCloth<T>& cloth, const CommonParameters& parameters,
                             const JacobiOptions& jacobi, const StepInputs& inputs, int count,
                             const std::vector<double>& weights, ClothState& state) {
  SliceStep<T> step = sliceStepOf<T>(parameters, jacobi);
  const std::vector<T> ownWeights(weights.begin(), weights.end());
  step.weights = ownWeights.empty() ? nullptr : ownWeights.data();
  const int threads = usefulThreads(cloth.layout, cloth.fabric.has_value(), parameters.threads);
  const int phases = threads == 1 ? 1 : jacobi.sweeps + 1;
  cloth.prepare(threads, jacobi.sweeps);
  cloth.chooseOrigin(state);
  team_.run(threads, [&](int member) {
    const StepShare share = shareOf(cloth.layout, jacobi.sweeps, member, threads);
    cloth.load(state, share);
    team_.arriveAndWait();
    for (int i = 0; i < count; ++i) {
      if (inputs.attachment) {
        if (member == 0) {
          setAttachment(model, *inputs.attachment, cloth, step);
        }
        team_.arriveAndWait();
      }
      for (int phase = 0; phase < phases; ++phase) {
        oneIterationPhase(cloth, step, share, phase);
        team_.arriveAndWait();
      }
    }
    cloth.store(state, share);
  });
  state.time += count * parameters.timeStep;
}

template <typename T>
void SlicedRun::verlet(const ClothModel& model, SlicedCloth<T>& cloth, const CommonParameters& parameters,
                       const StepInputs& inputs, int count, ClothState& state) {
  const SliceStep<T> step = sliceStepOf<T>(parameters, {});
  const T half = step.timeStep / T(2);
  const int threads = usefulThreads(cloth.layout, cloth.fabric.has_value(), parameters.threads);
  cloth.prepare(threads, 1);
  cloth.chooseOrigin(state);
  team_.run(threads, [&](int member) {
    const StepShare share = shareOf(cloth.layout, 1, member, threads);
    cloth.load(state, share);
    driftSlices(cloth, half, share);
    team_.arriveAndWait();
    for (int i = 0; i < count; ++i) {
      // The second half of a drift and the first half of the next are merged, unless the attachment acts between them.
      const T next = i + 1 < count ? step.timeStep : half;
      for (int phase = 0; phase < (threads == 1 ? 1 : 2); ++phase) {
        verletPhase(cloth, step, inputs.attachment ? T(0) : next, share, phase);
        team_.arriveAndWait();
      }
      if (inputs.attachment) {
        if (member == 0) {
          applyAttachmentImpulse(model, parameters.timeStep, *inputs.attachment, cloth);
        }
        team_.arriveAndWait();
        driftSlices(cloth, next, share);
        team_.arriveAndWait();
      }
    }
    cloth.store(state, share);
  });
  state.time += count * parameters.timeStep;
}

}  // namespace drape::sim::simd
