#pragma once

#include "dressing/piercing.hpp"
#include "session/snapshot.hpp"

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <vector>

namespace drape::app {

/// Finds bodies that pass through the cloth of a running simulation. It looks at the start of each scene, and later
/// only while contact reports cloth inside a body or between bodies, or while something was found, at most every two
/// seconds. The exact test runs on a thread of its own, so that neither steps nor pictures wait for it.
class PiercingWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// What the last look found.
  struct Found {
    std::vector<dressing::Piercing> piercings;  ///< empty: nothing
    bool isStart = true;                        ///< whether it looked at the start of the scene
  };

  PiercingWatch() = default;
  PiercingWatch(const PiercingWatch&) = delete;
  PiercingWatch& operator=(const PiercingWatch&) = delete;
  ~PiercingWatch() = default;

  /// Takes the result of a look that has ended, and begins the next one when it is due. Never waits. Call it for each
  /// picture.
  void follow(const session::Snapshot& snapshot, Clock::time_point now);

  /// Of the scene that it followed last.
  [[nodiscard]] const Found& found() const { return found_; }

  /// Whether it has looked at the start of this scene, or need not.
  [[nodiscard]] bool knowsStart() const { return knowsStart_; }

 private:
  void take(Clock::time_point now);
  void begin(std::vector<Vec3> positions, std::vector<dressing::PlacedBody> bodies, bool isStart);

  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const std::vector<Vec3>> placedStart_;
  std::shared_ptr<dressing::PiercingSearch> search_;  // of the scene; used by one look at a time
  Found found_;
  bool knowsStart_ = false;
  bool isStale_ = false;       // the running look belongs to another scene
  std::int64_t version_ = -1;  // of the snapshot that it looked at last
  Clock::time_point nextLook_{};
  std::future<Found> running_;  // last, since its destructor waits while the other members still exist
};

/// The bodies with an inside that are switched on, where a snapshot has them.
[[nodiscard]] std::vector<dressing::PlacedBody> bodiesOf(const session::Snapshot& snapshot);

}  // namespace drape::app
