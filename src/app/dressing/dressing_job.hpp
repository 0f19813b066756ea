#pragma once

#include "app/dressing/dressing_text.hpp"
#include "session/command.hpp"

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace drape::app {

/// One way to dress a body.
struct DressingAttempt {
  std::vector<Vec3> start;  ///< of the garment [m]
  sim::ClothMesh body;      ///< in the scene [m]
  dressing::PlacementRule rule = dressing::PlacementRule::Auto;
  bool isStart = true;    ///< whether the result is a start of the scene, see PlaceClothCommand
  bool isByHand = false;  ///< whether the user placed the garment
};

/// What a DressingJob does.
struct DressingOrder {
  WearNames names;
  std::shared_ptr<const sim::ClothModel> model;  ///< never null; its pins are released
  std::vector<DressingAttempt> attempts;         ///< at least one; in this order, until one leaves nothing wrong
  dressing::DressingOptions options;             ///< without rule and progress
  bool onlyPlaces = false;                       ///< by the first attempt; the intersections stay
};

/// Dresses a body on its own thread.
class DressingJob {
 public:
  struct Progress {
    dressing::Stage stage = dressing::Stage::Shrinking;
    double share = 0.0;  ///< of the stage, from 0 to 1
  };

  /// How it ended.
  struct Outcome {
    text::Sentence message;  ///< what was done, or why it could not be done
    bool hasFailed = false;
    /// The garment on the body. Empty if it was cancelled or cannot be worn; otherwise also where something is wrong
    /// with the result.
    std::optional<session::PlaceClothCommand> placed;
    std::optional<sim::contact::Pose> pose;  ///< of the garment after its start, if the order only places it
  };

  explicit DressingJob(DressingOrder order);
  DressingJob(const DressingJob&) = delete;
  DressingJob& operator=(const DressingJob&) = delete;
  /// Cancels.
  ~DressingJob();

  [[nodiscard]] Progress progress() const { return {stage_, share_}; }
  [[nodiscard]] const WearNames& names() const { return order_.names; }
  [[nodiscard]] bool onlyPlaces() const { return order_.onlyPlaces; }

  /// Ends the job soon.
  void cancel() { stop_.request_stop(); }

  /// The outcome once the job has ended; only once. Never waits.
  [[nodiscard]] std::optional<Outcome> poll();

 private:
  [[nodiscard]] Outcome run();
  [[nodiscard]] Outcome dressFirstThatFits();
  [[nodiscard]] Outcome placeOnly();
  [[nodiscard]] dressing::DressingOptions optionsFor(const DressingAttempt& attempt);
  [[nodiscard]] dressing::Dressed dressBy(const sim::ClothModel& model, const DressingAttempt& attempt);

  DressingOrder order_;
  std::stop_source stop_;
  std::atomic<dressing::Stage> stage_ = dressing::Stage::Shrinking;
  std::atomic<double> share_ = 0.0;
  std::future<Outcome> running_;  // last, since its destructor waits while the other members still exist
};

}  // namespace drape::app
