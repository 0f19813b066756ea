#include "report/sections/cloth_with_reference.hpp"

#include "messages/error.hpp"
#include "sim/measures/measures.hpp"
#include "sim/model/sim_error.hpp"

#include <algorithm>
#include <limits>
#include <thread>

namespace drape::report::sections {
namespace {

/// The maximum cost of a run in the search for the reference, in springs times steps: some seconds at most.
/// @param resolution 0 for a mesh
double maxCost(int resolution, bool isFabric, bool quick) {
  constexpr int small = 17;
  constexpr int large = 33;
  if (quick) {
    return 1e8;
  }
  if (resolution == 0) {
    return isFabric ? 4e8 : 2.5e9;
  }
  return resolution <= small ? 2e8 : resolution <= large ? 1e9 : 2.5e9;
}

Watch watchOf(const std::function<void()>& checkStop) {
  Watch watch;
  watch.progress = [&checkStop](std::string_view, std::int64_t, std::int64_t) { checkStop(); };
  return watch;
}

}  // namespace

const scene::Scene& ClothWithReference::scene() {
  if (scene_ == nullptr) {
    std::vector<std::string> settings = material_.settings;
    settings.insert(settings.end(), {"time_step=1/150", "substeps=1", "precision=double", "threads=1"});
    scene_ = buildSetUp(setUp_, resolution_, settings);
  }
  return *scene_;
}

const scene::Scene& ClothWithReference::jitteredScene(int seed) {
  auto& scene = jittered_.at(static_cast<std::size_t>(seed) - 1);
  if (scene == nullptr) {
    scene = jittered(this->scene(), jitterLength, static_cast<unsigned>(seed));
  }
  return *scene;
}

const Reference* ClothWithReference::reference(const std::function<void()>& checkStop) {
  if (!tried_) {
    findReference(checkStop);
    tried_ = true;
  }
  return reference_ ? &*reference_ : nullptr;
}

double ClothWithReference::noiseFloor(int checkpoint, const std::function<void()>& checkStop) {
  if (reference(checkStop) == nullptr) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (floor_.empty()) {
    findFloor(checkStop);
  }
  const auto k = static_cast<std::size_t>(checkpoint);
  return k < floor_.size() ? floor_[k] : std::numeric_limits<double>::infinity();
}

void ClothWithReference::findReference(const std::function<void()>& checkStop) {
  ConvergenceTolerance tolerance;
  tolerance.absolute = quick_ ? 1e-5 : 1e-6;
  tolerance.takeAnyway = true;  // each row states the quality of its reference
  tolerance.maxCost = maxCost(resolution_, material_.isFabric(), quick_);
  // Nothing is timed here, and all threads give the same bits.
  settings::Settings settings = convergedSettings(scene().settings);
  settings.step.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  try {
    reference_ = convergedReference(scene(), settings, measuredCheckpoints, tolerance, watchOf(checkStop).progress);
  } catch (const messages::InputError&) {
    reference_.reset();
  } catch (const sim::SimError&) {
    reference_.reset();
  }
}

void ClothWithReference::findFloor(const std::function<void()>& checkStop) {
  // The growth of jitter is a property of the motion, so the first step of the halving is accurate enough.
  settings::Settings settings = reference_->settings;
  for (std::size_t i = 0; i < reference_->halvings.size(); ++i) {
    settings.step.timeStep *= 2.0;
  }
  const Watch watch = watchOf(checkStop);
  const Trajectory still = runTrajectory(scene(), settings, measuredCheckpoints, watch);
  floor_.assign(still.states.size(), 0.0);
  for (int seed = 1; seed <= seedCount; ++seed) {
    const Trajectory moved = runTrajectory(jitteredScene(seed), settings, measuredCheckpoints, watch);
    floor_.resize(std::min(floor_.size(), moved.states.size()));
    for (std::size_t k = 0; k < floor_.size(); ++k) {
      floor_[k] += sim::meanDistance(still.states[k].positions, moved.states[k].positions) / seedCount;
    }
  }
}

}  // namespace drape::report::sections
