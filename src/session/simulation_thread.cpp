#include "session/simulation_thread.hpp"

#include "session/pacer.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace drape::session {
namespace {

using Clock = std::chrono::steady_clock;

/// Longest time between two snapshots, and between two reads of the command queue, while many steps are due.
constexpr double longestBurst = 1.0 / 120.0;  // [s]
/// Longest sleep: the maximum delay of a command while nothing moves.
constexpr double longestSleep = 0.004;  // [s]

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

SimulationThread::SimulationThread(std::shared_ptr<const scene::Scene> scene, bool paused)
    : simulation_(std::move(scene)) {
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
  if (thread_.joinable()) {
    thread_.join();
  }
}

const Simulation& SimulationThread::finish() {
  finish_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
  return simulation_;
}

void SimulationThread::post(Command command) {
  queue_.post(std::move(command));
}

void SimulationThread::inspect(std::function<void(const Simulation&)> look) {
  const std::scoped_lock lock(inspectionLock_);
  inspections_.push_back(std::move(look));
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

void SimulationThread::publish() {
  Snapshot& snapshot = snapshots_.writeSlot();
  simulation_.capture(snapshot);
  snapshot.realTimeFactor = simulation_.paused() ? 0.0 : realTimeFactor_;
  snapshots_.publish();
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
    const bool changed = drain(commands);
    answerInspections();
    const double elapsed = secondsSince(last);
    last = Clock::now();
    const settings::Settings& settings = simulation_.settings();
    double simulated = 0.0;
    if (simulation_.paused()) {
      pacer.forget();
      factor.reset();
    } else {
      pacer.collect(elapsed, settings.playback.speed);
      while (!simulation_.paused() && secondsSince(last) < longestBurst && pacer.takeStep(settings.step.timeStep)) {
        simulation_.step();
        simulated += settings.step.timeStep;
      }
      factor.add(elapsed, simulated);
    }
    if (changed || simulated > 0.0) {
      realTimeFactor_ = factor.value();
      publish();
    }
    const double wait =
        simulation_.paused() ? longestSleep : pacer.untilNext(settings.step.timeStep, settings.playback.speed);
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(wait, longestSleep)));
  }
}

}  // namespace drape::session
