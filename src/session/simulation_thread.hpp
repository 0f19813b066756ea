#pragma once

#include "session/command.hpp"
#include "session/command_queue.hpp"
#include "session/simulation.hpp"
#include "session/snapshot.hpp"
#include "session/triple_buffer.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace drape::session {

/// A simulation on its own thread, in real time. Commands go in, snapshots come out; neither side waits.
class SimulationThread {
 public:
  SimulationThread(std::shared_ptr<const scene::Scene> scene, bool paused);
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;
  /// Stops and joins.
  ~SimulationThread();

  /// Posts a command; it takes effect at the next step boundary. Any thread may call it.
  void post(Command command);

  /// Posts a function that the thread calls at the next step boundary. Any thread may call it. The function is dropped
  /// when the thread ends first.
  void inspect(std::function<void(const Simulation&)> look);

  /// Sets a function that the thread calls when the picture changes after it was still for a while.
  void callOnMotion(std::function<void()> wake);

  /// Ends the thread after the step in progress and returns its simulation.
  [[nodiscard]] const Simulation& finish();

  /// The newest snapshot. Only the drawing thread may call it; the result is valid until its next call.
  [[nodiscard]] const Snapshot& latest();

 private:
  void run();
  void publish();
  [[nodiscard]] bool isWorthPublishing() const;
  void answerInspections();
  /// Applies the posted commands; whether there were any.
  bool drain(std::vector<Command>& commands);

  Simulation simulation_;
  CommandQueue queue_;
  std::mutex inspectionLock_;  // of the next line
  std::vector<std::function<void(const Simulation&)>> inspections_;
  TripleBuffer<Snapshot> snapshots_;
  double realTimeFactor_ = 0.0;
  std::int64_t publishedPicture_ = -1;                   // Snapshot::pictureVersion
  std::chrono::steady_clock::time_point lastPublished_;  // any snapshot
  std::chrono::steady_clock::time_point lastMotion_;     // a snapshot with another picture
  std::mutex wakeLock_;                                  // of the next line
  std::function<void()> wake_ = [] {};
  std::atomic<bool> finish_{false};  // after the step in progress
  std::stop_source stop_;            // at once
  std::thread thread_;
};

}  // namespace drape::session
