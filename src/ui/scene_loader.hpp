#pragma once

#include "scene/scene.hpp"
#include "scene/scene_parts.hpp"

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace drape::ui {

/// Opens and builds scenes in the background, one at a time. Of the waiting requests only the newest is kept, since it
/// is the one that the user wants. Destruction cancels the running job and waits for its end, which takes a fraction of
/// a second.
class SceneLoader {
 public:
  /// The purpose of a job.
  enum class Kind {
    Opened,   ///< another scene
    Rebuilt,  ///< the same scene with other settings
    Placed,   ///< the same scene with other placements
    Restored  ///< the same scene with its own settings
  };

  /// The result of a job: a scene, or the reason of the failure.
  struct Outcome {
    std::shared_ptr<const scene::Scene> scene;
    text::Sentence error;
    Kind kind = Kind::Opened;
  };

  SceneLoader() = default;
  SceneLoader(const SceneLoader&) = delete;
  SceneLoader& operator=(const SceneLoader&) = delete;
  ~SceneLoader();

  /// Opens another scene. `adjust` may change the scene's own settings before it is built.
  /// @param own the user's fabrics
  void open(const scene::SceneParts& parts, std::function<void(settings::Settings&)> adjust,
            const settings::OwnFabrics& own = {});
  /// Builds a description again with these settings.
  void rebuild(const scene::SceneDescription& description, const settings::Settings& settings,
               Kind kind = Kind::Rebuilt);

  /// Cancels the running job and the waiting one. Their results never arrive. False when there was none.
  bool cancel();

  /// The result of a job that ended since the last call. Never waits.
  [[nodiscard]] std::optional<Outcome> poll();

  /// The running job and its progress, in words; empty when there is none.
  [[nodiscard]] text::Sentence activity() const;

 private:
  struct Job {
    text::Sentence activity;
    std::function<std::shared_ptr<const scene::Scene>(const io::ImportWatch& watch)> build;
    Kind kind = Kind::Opened;
  };

  void submit(Job job);
  void start(Job job);

  text::Sentence activity_;
  bool cancelled_ = false;  // whether the running job is cancelled
  std::optional<Job> waiting_;
  std::atomic<int> percent_ = 0;  // of the running job
  std::stop_source stop_;         // of the running job
  std::future<Outcome> running_;  // last, since its destructor waits while the other members still exist
};

/// The limit on the strain of fabrics in the window [-]; less is invisible.
inline constexpr double visibleStrain = 0.01;

/// Sets what begins differently in the window than in the other programs: a strain limit of 1 % (auto.strain) where a
/// scene leaves it at 0, so that stiff fabrics keep real time, and as many threads as there are cores beside the one
/// that draws, unless the scene sets more. With four or more cores it also checks the error.
void useWindowDefaults(settings::Settings& settings);

/// Another scene keeps the user's changes of the view: `target`, the settings of the next scene, takes each view
/// setting that differs between `current` and `own`, the present scene's original settings.
void carryViewSettings(const settings::Settings& current, const settings::Settings& own, settings::Settings& target);

}  // namespace drape::ui
