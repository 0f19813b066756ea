#include "sim/solvers/conjugate_gradients_run.hpp"

#include "sim/simd/slice_step.hpp"
#include "sim/solvers/conjugate_gradients_loop.hpp"

namespace drape::sim {
namespace {

/// The work of one thread in some steps. All threads run the same phases, wait for each other between them, and make
/// the same decisions from the same sums.
template <typename T>
class ConjugateMember {
 public:
  ConjugateMember(simd::SlicedCloth<T>& cloth, simd::ConjugateGradients<T>& system, const simd::SliceStep<T>& step,
                  const simd::StepShare& share, simd::ThreadTeam& team)
      : cloth_(cloth), system_(system), step_(step), share_(share), team_(team) {}

  /// The iteration starts from zero. The dv of the last step would be a better guess, but the residual of a stopped
  /// iteration would then accumulate from step to step, and the cloth blows up.
  StepReport step(const StepParameters& parameters) {
    phase(simd::ConjugatePhase::Start);
    const StepReport report = conjugateGradients(*this, parameters.iteration);
    phase(simd::ConjugatePhase::Advance);
    return report;
  }

  // The vectors, as conjugateGradients asks for them.
  [[nodiscard]] double squaredResidual() const { return system_.squaredResidual(); }
  [[nodiscard]] double descent() const { return system_.descent(); }
  double multiply() {
    phase(simd::ConjugatePhase::Multiply);
    return system_.curvature();
  }
  void descend(double length) { phase(simd::ConjugatePhase::Descend, length); }
  void turn(double factor) { phase(simd::ConjugatePhase::Turn, factor); }

 private:
  void phase(simd::ConjugatePhase phase, double factor = 0.0) {
    simd::conjugatePhase(cloth_, system_, step_, share_, phase, static_cast<T>(factor));
    team_.arriveAndWait();
  }

  simd::SlicedCloth<T>& cloth_;
  simd::ConjugateGradients<T>& system_;
  const simd::SliceStep<T>& step_;
  const simd::StepShare& share_;
  simd::ThreadTeam& team_;
};

}  // namespace

StepReport ConjugateGradientsRun::steps(const ClothModel& model, const StepParameters& parameters,
                                        const StepInputs& inputs, int count, ClothState& state) {
  return parameters.precision == Precision::Float ? steps(model, parameters, inputs, count, single_, state)
                                                  : steps(model, parameters, inputs, count, double_, state);
}

template <typename T>
StepReport ConjugateGradientsRun::steps(const ClothModel& model, const StepParameters& parameters,
                                        const StepInputs& inputs, int count, Memory<T>& memory, ClothState& state) {
  simd::SlicedCloth<T>& cloth = memory.cloths.get(model);
  simd::ConjugateGradients<T>& system =
      memory.systems.get(model, [&](const ClothModel&) { return simd::ConjugateGradients<T>(cloth.layout); });
  simd::SliceStep<T> step = simd::sliceStepOf<T>(parameters, {});
  const int threads = simd::usefulThreads(cloth.layout, cloth.fabric.has_value(), parameters.threads);
  cloth.prepare(threads, 0);
  cloth.chooseOrigin(state);
  StepReport report;
  team_.run(threads, [&](int member) {
    const simd::StepShare share = simd::blockShareOf(cloth.layout, member, threads);
    ConjugateMember<T> part(cloth, system, step, share, team_);
    cloth.load(state, share);
    team_.arriveAndWait();
    for (int i = 0; i < count; ++i) {
      if (inputs.attachment) {
        if (member == 0) {
          simd::setAttachment(model, *inputs.attachment, cloth, step);
        }
        team_.arriveAndWait();
      }
      const StepReport one = part.step(parameters);
      if (member == 0) {
        report.add(one);
      }
    }
    cloth.store(state, share);
  });
  state.time += count * parameters.timeStep;
  return report;
}

}  // namespace drape::sim
