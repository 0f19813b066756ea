#pragma once

#include "session/command.hpp"
#include "session/command_queue.hpp"
#include "session/simulation.hpp"
#include "session/snapshot.hpp"
#include "session/triple_buffer.hpp"

#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

namespace drape {

/// A simulation on a thread of its own, paced by the clock. Commands go in, snapshots come out; nobody waits.
class SimulationThread {
 public:
  SimulationThread(std::shared_ptr<const Scene> scene, bool paused);
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;
  /// Stops and joins.
  ~SimulationThread();

  /// Hands a command over; it takes effect at the next step boundary. Any thread.
  void post(Command command);

  /// The newest snapshot. One thread only (the one that draws); valid until its next call.
  [[nodiscard]] const Snapshot& latest();

 private:
  void run();
  void publish();
  /// Applies what has been posted; true when there was anything.
  bool drain(std::vector<Command>& commands);

  Simulation simulation_;
  CommandQueue queue_;
  TripleBuffer<Snapshot> snapshots_;
  double realTimeFactor_ = 0.0;
  std::stop_source stop_;
  std::thread thread_;
};

}  // namespace drape
