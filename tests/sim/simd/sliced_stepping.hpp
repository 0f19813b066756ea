#pragma once

#include "sim/simd/slice_step.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/simd/thread_team.hpp"

#include <algorithm>
#include <vector>

namespace drape::sim::testing {

using namespace simd;

/// Everything that a step can have, at once.
inline StepParameters everything() {
  StepParameters parameters;
  parameters.material.damping = 0.002;
  parameters.air.drag = 0.8;
  parameters.air.lift = 0.5;
  parameters.air.wind = Vec3(1.0, 0.2, -2.0);
  return parameters;
}

/// The orders in which the members of a team may come to do a phase, when one processor does the work of all.
enum class Turns { Forwards, Backwards, EveryOther };

inline std::vector<int> membersBy(Turns turns, int members) {
  std::vector<int> order;
  for (int m = 0; m < members; ++m) {
    order.push_back(m);
  }
  if (turns == Turns::Backwards) {
    std::reverse(order.begin(), order.end());
  }
  if (turns == Turns::EveryOther) {
    std::stable_partition(order.begin(), order.end(), [](int m) { return m % 2 == 1; });
  }
  return order;
}

/// Takes steps of the one-iteration method or of Verlet share by share and phase by phase, on the calling thread.
template <typename T>
class SteppingByHand {
 public:
  SteppingByHand(const ClothModel& model, const StepParameters& parameters, int members, Turns turns)
      : model_(model),
        parameters_(parameters),
        cloth_(model),
        step_(sliceStepOf<T>(parameters, parameters.jacobi)),
        order_(membersBy(turns, members)) {
    cloth_.prepare(members, parameters.jacobi.sweeps);
  }

  /// Of Chebyshev's acceleration, one a sweep.
  void accelerateBy(const std::vector<T>& weights) {
    weights_ = weights;
    step_.weights = weights_.data();
  }

  void oneIteration(const StepInputs& inputs, int steps, ClothState& state) {
    eachMember(1, [&](const StepShare& share) { cloth_.load(state, share); });
    for (int i = 0; i < steps; ++i) {
      if (inputs.attachment) {
        setAttachment(model_, *inputs.attachment, cloth_, step_);
      }
      for (int phase = 0; phase <= parameters_.jacobi.sweeps; ++phase) {
        eachMember(parameters_.jacobi.sweeps,
                   [&](const StepShare& share) { oneIterationPhase(cloth_, step_, share, phase); });
      }
    }
    eachMember(1, [&](const StepShare& share) { cloth_.store(state, share); });
  }

  void verlet(int steps, ClothState& state) {
    const T half = step_.timeStep / T(2);
    eachMember(1, [&](const StepShare& share) { cloth_.load(state, share); });
    eachMember(1, [&](const StepShare& share) { driftSlices(cloth_, half, share); });
    for (int i = 0; i < steps; ++i) {
      for (int phase = 0; phase < 2; ++phase) {
        eachMember(1, [&](const StepShare& share) {
          verletPhase(cloth_, step_, i + 1 < steps ? step_.timeStep : half, share, phase);
        });
      }
    }
    eachMember(1, [&](const StepShare& share) { cloth_.store(state, share); });
  }

 private:
  template <typename Visit>
  void eachMember(int sweeps, Visit&& visit) {
    for (const int member : order_) {
      visit(shareOf(cloth_.layout, sweeps, member, static_cast<int>(order_.size())));
    }
  }

  const ClothModel& model_;
  StepParameters parameters_;
  SlicedCloth<T> cloth_;
  SliceStep<T> step_;
  std::vector<int> order_;
  std::vector<T> weights_;
};

/// Steps of the one-iteration method by a team of threads, however many cores there are.
template <typename T>
void oneIterationByTeam(const ClothModel& model, const StepParameters& parameters, int steps, ClothState& state) {
  SlicedCloth<T> cloth(model);
  const SliceStep<T> step = sliceStepOf<T>(parameters, parameters.jacobi);
  cloth.prepare(parameters.threads, parameters.jacobi.sweeps);
  ThreadTeam team;
  team.run(parameters.threads, [&](int member) {
    const StepShare share = shareOf(cloth.layout, parameters.jacobi.sweeps, member, parameters.threads);
    cloth.load(state, share);
    team.arriveAndWait();
    for (int i = 0; i < steps; ++i) {
      for (int phase = 0; phase <= parameters.jacobi.sweeps; ++phase) {
        oneIterationPhase(cloth, step, share, phase);
        team.arriveAndWait();
      }
    }
    cloth.store(state, share);
  });
}

}  // namespace drape::sim::testing
