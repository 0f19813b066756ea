#pragma once

#include "scene/scene.hpp"
#include "settings/settings.hpp"
#include "sim/measures/error_sources.hpp"
#include "text/sentence.hpp"

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace drape::app {

/// Compares the sources of error of a scene on its own thread (report::measureErrorSources).
class ErrorComparison {
 public:
  /// How it ended.
  struct Outcome {
    std::vector<sim::ErrorSources> sources;  ///< at ascending times; empty if it was cancelled or failed
    text::Sentence failure;                  ///< why it failed; empty if it did not
  };

  /// @param scene of which the description is used  @param settings of the cloth now
  ErrorComparison(std::shared_ptr<const scene::Scene> scene, settings::Settings settings);
  ErrorComparison(const ErrorComparison&) = delete;
  ErrorComparison& operator=(const ErrorComparison&) = delete;
  /// Cancels.
  ~ErrorComparison();

  [[nodiscard]] double share() const { return share_; }  ///< of the work, from 0 to 1

  /// Ends it soon.
  void cancel() { stop_.request_stop(); }

  /// The outcome once it has ended; only once. Never waits.
  [[nodiscard]] std::optional<Outcome> poll();

 private:
  [[nodiscard]] Outcome run();

  std::shared_ptr<const scene::Scene> scene_;
  settings::Settings settings_;
  std::stop_source stop_;
  std::atomic<double> share_ = 0.0;
  std::future<Outcome> running_;  // last, since its destructor waits while the other members still exist
};

}  // namespace drape::app
