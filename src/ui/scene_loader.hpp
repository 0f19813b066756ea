#pragma once

#include "scene/scene.hpp"
#include "scene/scene_parts.hpp"
#include "session/command.hpp"

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace drape {

/// Opens and builds scenes beside the running program. One at a time; of those that wait only the newest is kept,
/// because it is what the user wants in the end. Destruction cancels the one in progress and waits for its end, which
/// takes a fraction of a second.
class SceneLoader {
 public:
  /// What a job was for.
  enum class Kind {
    Opened,   ///< another scene
    Rebuilt,  ///< the same scene under other settings
    Restored  ///< the same scene under its own settings
  };

  /// How a job ended: with a scene, or with the reason why there is none.
  struct Outcome {
    std::shared_ptr<const Scene> scene;
    std::string error;
    Kind kind = Kind::Opened;
  };

  SceneLoader() = default;
  SceneLoader(const SceneLoader&) = delete;
  SceneLoader& operator=(const SceneLoader&) = delete;
  ~SceneLoader();

  /// Opens another scene. `adjust` may change the scene's own settings before it is built.
  void open(const std::string& nameOrPath, std::function<void(Settings&)> adjust);
  /// The same for a scene that is put together from several files.
  void open(const SceneParts& parts, std::function<void(Settings&)> adjust);
  /// Builds a description again.
  void rebuild(const SceneDescription& description, const Settings& settings);
  /// Builds a description again under its own settings.
  void restore(const SceneDescription& description);

  /// Gives up what is being built and what waits. Its outcome never arrives. False when there was nothing.
  bool cancel();

  /// The outcome of a job that has ended since the last call. Never waits.
  [[nodiscard]] std::optional<Outcome> poll();

  /// What is being built and how far it is, for the user to read; empty when nothing is.
  [[nodiscard]] std::string activity() const;

 private:
  struct Job {
    std::string activity;
    std::function<std::shared_ptr<const Scene>(const ImportWatch& watch)> build;
    Kind kind = Kind::Opened;
  };

  void submit(Job job);
  void start(Job job);

  std::string activity_;
  bool cancelled_ = false;  // the running job is: nobody wants its outcome
  std::optional<Job> waiting_;
  std::atomic<int> percent_ = 0;  // of the running job
  std::stop_source stop_;         // of the running job
  std::future<Outcome> running_;  // last, because its end is waited for while the others are still there
};

/// Another scene keeps what the user changed about the view: `target`, the next scene's settings, takes each view
/// setting in which `current` differs from `own`, what the present scene came with.
void carryViewSettings(const Settings& current, const Settings& own, Settings& target);

/// The changes that bring `from` to `to` without building the scene again.
[[nodiscard]] std::vector<SetSettingCommand> runningChanges(const Settings& from, const Settings& to);

}  // namespace drape
