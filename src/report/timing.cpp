#include "report/timing.hpp"

#include "sim/model/seconds_since.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace drape::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Bytes that all threads of the program have allocated, from the C library's statistics. Eigen does not use `new`, so
/// counting there would miss most. Sanitizer allocators and other C libraries have no statistics.
double allocatedBytes() {
#ifdef __GLIBC__
  const struct mallinfo2 info = mallinfo2();
  const std::size_t bytes = info.uordblks + info.hblkhd;
  return bytes == 0 ? none : static_cast<double>(bytes);
#else
  return none;
#endif
}

}  // namespace

double secondsOf(const std::function<void()>& call) {
  const auto begin = std::chrono::steady_clock::now();
  call();
  return sim::secondsSince(begin);
}

double quantileOf(std::vector<double> values, double share) {
  if (values.empty()) {
    return none;
  }
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, values.size()) - 1);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double medianOf(std::vector<double> values) {
  return quantileOf(std::move(values), 0.5);
}

double fittedExponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  double sumX = 0.0;
  double sumY = 0.0;
  double sumXX = 0.0;
  double sumXY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double logX = std::log(x[i]);
    const double logY = std::log(y.at(i));
    sumX += logX;
    sumY += logY;
    sumXX += logX * logX;
    sumXY += logX * logY;
  }
  const double spread = count * sumXX - sumX * sumX;
  return x.size() > 1 && spread > 0.0 ? (count * sumXY - sumX * sumY) / spread : none;
}

StepTiming timeSteps(const scene::Scene& scene, const settings::Settings& settings, const TimingBudget& budget,
                     const std::function<void()>& checkStop) {
  StepTiming timing;
  sim::ClothState state = scene.start;
  const double before = allocatedBytes();
  sim::Stepper stepper(settings.solver.name);
  const auto step = [&] {
    checkStop();
    return secondsOf([&] { stepper.step(*scene.model, settings.step, {}, state); });
  };
  const double first = step();
  // The state's vectors existed before; the difference belongs to the solver.
  timing.memoryBytes = std::max(0.0, allocatedBytes() - before);
  timing.memoryBytes = std::isnan(before) ? none : timing.memoryBytes;
  for (double spent = 0.0; static_cast<int>(timing.stepSeconds.size()) < budget.maxSteps &&
                           (spent < budget.seconds || static_cast<int>(timing.stepSeconds.size()) < budget.minSteps);
       spent += timing.stepSeconds.back()) {
    if (!sim::isFinite(state)) {
      timing.finite = false;
      state = scene.start;
    }
    timing.stepSeconds.push_back(step());
  }
  timing.setupSeconds = std::max(0.0, first - medianOf(timing.stepSeconds));
  return timing;
}

}  // namespace drape::report
