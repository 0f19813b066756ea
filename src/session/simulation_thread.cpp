#include "session/simulation_thread.hpp"

#include "session/pacer.hpp"
#include "sim/model/seconds_since.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace drape::session {
namespace {

using Clock = std::chrono::steady_clock;

/// Longest time between two snapshots, and between two reads of the command queue, while many steps are due.
constexpr double longestBurst = 1.0 / 120.0;  // [s]
/// The cloth is still after this time without motion: the next motion wakes the window. Sleeping cloth sends snapshots
/// this far apart [s].
constexpr double longestStillness = 0.25;
/// Longest wait for a command while nothing moves. Sleeping cloth then takes the steps of this time together [s].
constexpr double longestWait = 0.1;

}  // namespace

SimulationThread::SimulationThread(std::shared_ptr<const scene::Scene> scene, bool paused)
    : simulation_(std::move(scene)) {
  simulation_.setAccuracyInBackground(true);
  simulation_.apply(PauseCommand{paused});
  simulation_.setStopToken(stop_.get_token());
  publish();
  thread_ = std::thread([this] {
    try {
      run();
    } catch (const sim::StepStopped&) {
      // The aborted step is not needed.
    }
  });
}

SimulationThread::~SimulationThread() {
  stop_.request_stop();
  queue_.wake();
  if (thread_.joinable()) {
    thread_.join();
  }
}

const Simulation& SimulationThread::finish() {
  finish_ = true;
  queue_.wake();
  if (thread_.joinable()) {
    thread_.join();
  }
  return simulation_;
}

void SimulationThread::post(Command command) {
  queue_.post(std::move(command));
}

void SimulationThread::inspect(std::function<void(const Simulation&)> look) {
  {
    const std::scoped_lock lock(inspectionLock_);
    inspections_.push_back(std::move(look));
  }
  queue_.wake();
}

void SimulationThread::answerInspections() {
  std::vector<std::function<void(const Simulation&)>> taken;
  {
    const std::scoped_lock lock(inspectionLock_);
    taken.swap(inspections_);
  }
  for (const auto& look : taken) {
    look(simulation_);
  }
}

const Snapshot& SimulationThread::latest() {
  return snapshots_.latest();
}

void SimulationThread::callOnMotion(std::function<void()> wake) {
  const std::scoped_lock lock(wakeLock_);
  wake_ = std::move(wake);
}

/// While the cloth sleeps, only its age changes. Nobody needs that often.
bool SimulationThread::isWorthPublishing() const {
  return simulation_.pictureVersion() != publishedPicture_ || sim::secondsSince(lastPublished_) > longestStillness;
}

void SimulationThread::publish() {
  Snapshot& snapshot = snapshots_.writeSlot();
  simulation_.capture(snapshot);
  snapshot.realTimeFactor = simulation_.paused() ? 0.0 : realTimeFactor_;
  snapshots_.publish();
  lastPublished_ = Clock::now();
  if (std::exchange(publishedPicture_, simulation_.pictureVersion()) != simulation_.pictureVersion()) {
    const bool wakes = sim::secondsSince(lastMotion_) > longestStillness;
    lastMotion_ = lastPublished_;
    if (wakes) {
      const std::scoped_lock lock(wakeLock_);
      wake_();
    }
  }
}

bool SimulationThread::drain(std::vector<Command>& commands) {
  queue_.drain(commands);
  for (const Command& command : commands) {
    simulation_.apply(command);
  }
  return !commands.empty();
}

void SimulationThread::run() {
  Pacer pacer;
  RealTimeFactor factor;
  std::vector<Command> commands;
  auto last = Clock::now();
  while (!stop_.stop_requested() && !finish_) {
    const bool wasPaused = simulation_.paused();  // while this thread waited
    const bool changed = drain(commands);
    answerInspections();
    const double elapsed = wasPaused ? 0.0 : sim::secondsSince(last);
    last = Clock::now();
    const settings::Settings& settings = simulation_.settings();
    double simulated = 0.0;
    if (simulation_.paused()) {
      pacer.forget();
      factor.reset();
    } else {
      pacer.collect(elapsed, settings.playback.speed);
      while (!simulation_.paused() && sim::secondsSince(last) < longestBurst &&
             pacer.takeStep(settings.step.timeStep)) {
        simulation_.step();
        simulated += settings.step.timeStep;
      }
      factor.add(elapsed, simulated);
    }
    if (changed || (simulated > 0.0 && isWorthPublishing())) {
      realTimeFactor_ = factor.value();
      publish();
    }
    const bool isStill = simulation_.paused() || sim::secondsSince(lastMotion_) > longestStillness;
    const double wait = isStill ? longestWait : pacer.untilNext(settings.step.timeStep, settings.playback.speed);
    queue_.await(std::chrono::duration<double>(std::min(wait, longestWait)));
  }
}

}  // namespace drape::session
