#include "bench/slice_runner.hpp"

#include "bench/suite.hpp"
#include "sim/simd/slice_step.hpp"

#include <stdexcept>
#include <utility>

namespace drape::bench {

template <typename T>
SliceRunner<T>::SliceRunner(ModelPtr model, Method method, const sim::StepParameters& parameters)
    : model_(std::move(model)),
      method_(method),
      cloth_(*model_),
      step_(sim::simd::sliceStepOf<T>(parameters, parameters.jacobi)),
      start_(waving(*model_)),
      threads_(sim::simd::usefulThreads(cloth_.layout, cloth_.fabric.has_value(), parameters.threads)) {
  cloth_.prepare(threads_, step_.sweeps);
  restart();
}

template <typename T>
void SliceRunner<T>::restart() {
  cloth_.load(start_, sim::simd::shareOf(cloth_.layout, 1, 0, 1));
}

template <typename T>
void SliceRunner<T>::steps(int count) {
  team_.run(threads_, [&](int member) { phases(member, count); });
}

template <typename T>
void SliceRunner<T>::phases(int member, int count) {
  const int sweeps = method_ == Method::Verlet ? 1 : step_.sweeps;
  const sim::simd::StepShare share = sim::simd::shareOf(cloth_.layout, sweeps, member, threads_);
  const int last = threads_ == 1 ? 0 : sweeps;
  for (int i = 0; i < count; ++i) {
    for (int phase = 0; phase <= last; ++phase) {
      if (method_ == Method::Verlet) {
        sim::simd::verletPhase(cloth_, step_, step_.timeStep, share, phase);
      } else {
        sim::simd::oneIterationPhase(cloth_, step_, share, phase);
      }
      team_.arriveAndWait();
    }
  }
}

template <typename T>
void SliceRunner<T>::check() {
  sim::ClothState state = start_;
  cloth_.store(state, sim::simd::shareOf(cloth_.layout, 1, 0, 1));
  if (!sim::isFinite(state)) {
    throw std::runtime_error("the cloth that is measured has blown up");
  }
}

template <typename T>
double batchSeconds(SliceRunner<T>& runner, int count, bool wall) {
  runner.restart();
  const auto work = [&] { runner.steps(count); };
  const double seconds = wall ? wallSeconds(work) : threadSeconds(work);
  runner.check();
  return seconds;
}

template class SliceRunner<float>;
template class SliceRunner<double>;
template double batchSeconds(SliceRunner<float>& runner, int count, bool wall);
template double batchSeconds(SliceRunner<double>& runner, int count, bool wall);

}  // namespace drape::bench
