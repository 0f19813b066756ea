#include "sim/solvers/conjugate_gradients_run.hpp"

#include "sim/simd/slice_step.hpp"

#include <cmath>

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
    StepReport report;
    const double first = std::sqrt(system_.squaredResidual());
    if (first > 0.0) {
      report = solve(parameters, first);
    }
    phase(simd::ConjugatePhase::Advance);
    return report;
  }

 private:
  StepReport solve(const StepParameters& parameters, double first) {
    StepReport report;
    report.residual = 1.0;
    double descent = system_.descent();
    while (report.iterations < parameters.iteration.maxIterations) {
      phase(simd::ConjugatePhase::Multiply);
      const double curvature = system_.curvature();
      if (!(curvature > 0.0)) {
        break;  // the matrix is indefinite: there is no minimum along this direction
      }
      phase(simd::ConjugatePhase::Descend, descent / curvature);
      ++report.iterations;
      report.residual = std::sqrt(system_.squaredResidual()) / first;
      if (report.residual <= parameters.iteration.tolerance) {
        break;
      }
      const double next = system_.descent();
      phase(simd::ConjugatePhase::Turn, next / descent);
      descent = next;
    }
    report.converged = report.residual <= parameters.iteration.tolerance;
    return report;
  }

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
  const int threads = simd::usefulThreads(cloth.layout, parameters.threads);
  cloth.prepare(threads, 0);
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
