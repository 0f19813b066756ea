#pragma once

#include "sim/contact/bodies/world.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/seams.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace drape::session {

/// A simulation between two steps, as the timeline keeps it.
struct RecordedState {
  std::int64_t step = 0;  ///< since the scene was loaded or reset
  sim::ClothState state;
  std::optional<sim::ClothState> ghost;
  std::vector<sim::contact::BodyShift> bodies;                    ///< one a body
  std::shared_ptr<const std::vector<sim::Seam>> seams = nullptr;  ///< with the times of their starts; null: none
};

/// What the timeline holds, for the window.
struct TimelineStatus {
  double begin = 0.0;        ///< time of the oldest state [s]
  double end = 0.0;          ///< of the newest one [s]
  std::size_t states = 0;    ///< how many
  double megabytes = 0.0;    ///< their size [1e6 bytes]
  std::int64_t spacing = 1;  ///< steps between two states
};

/// The states of the last minute of simulated time, in bounded memory. A state holds everything that later steps depend
/// on, so playing from it repeats the motion to the last bit as long as nothing else changes.
///
/// States are a frame (1/60 s) apart at first. When they need more memory than allowed, every other one is removed, and
/// new ones come at twice the distance.
class Timeline {
 public:
  static constexpr double longest = 60.0;      ///< [s]
  static constexpr double frame = 1.0 / 60.0;  ///< [s]

  /// @param megabytes allowed memory; 0: nothing is recorded, and what was is forgotten
  void limit(double megabytes);
  void clear();

  /// Whether a state of that step should be recorded.
  [[nodiscard]] bool isDue(std::int64_t step, double timeStep) const;
  /// Records a state. States of the same and of later steps are removed: they belong to a future that is replaced.
  void record(RecordedState state);

  /// The last state at or before a step, or the first one; nullptr if there is none. Valid until the next change.
  [[nodiscard]] const RecordedState* at(std::int64_t step) const;
  [[nodiscard]] bool isOn() const { return maxBytes_ > 0; }
  /// Empty without states.
  [[nodiscard]] std::optional<TimelineStatus> status(double timeStep) const;
  /// The state whose time is nearest; the timeline must not be empty.
  [[nodiscard]] const RecordedState& nearest(double time) const;

 private:
  [[nodiscard]] std::int64_t spacing(double timeStep) const;
  void keepWithinLimits();

  std::vector<RecordedState> states_;  // by ascending step
  std::size_t maxBytes_ = 0;
  std::size_t bytesOfOne_ = 0;  // of a state, measured from time to time
  std::int64_t recorded_ = 0;   // states so far
  std::int64_t thinning_ = 1;   // factor on the spacing
};

}  // namespace drape::session
