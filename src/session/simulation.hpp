#pragma once

#include "session/command.hpp"
#include "session/ghost.hpp"
#include "session/snapshot.hpp"
#include "session/work_budget.hpp"
#include "sim/contact/body_world.hpp"
#include "sim/stepper.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace drape {

/// A scene that runs: model, state, settings and solver, changed by commands and advanced by steps. It has no thread;
/// the viewer's thread, the headless program and the tests all use this same class.
class Simulation {
 public:
  explicit Simulation(std::shared_ptr<const Scene> scene);

  /// Takes effect at once; call between two steps. What a command asks wrongly (a value out of range, a triangle that
  /// is not there) changes nothing and becomes the message.
  void apply(const Command& command);

  /// Advances by one time step, paused or not. When the state stops being finite the simulation goes back to the last
  /// finite state, pauses and says so. A ghost that stops being finite is taken away, and the first cloth goes on.
  void step();

  /// When a stop is requested, a step that takes long throws StepStopped. The simulation is then of no more use.
  void setStopToken(std::stop_token token) { inputs_.stop = std::move(token); }
  /// The callback is called now and then within steps that take long. What it throws comes out of step(); the simulation
  /// is then of no more use.
  void setProgressCallback(std::function<void()> callback) { onProgress_ = std::move(callback); }

  /// Goes through a log that another simulation of the same scene wrote, taking the steps between its commands. The
  /// states are the same, bit for bit.
  void replay(const std::vector<LoggedCommand>& log);

  /// Fills `snapshot` with the present state, reusing its memory.
  void capture(Snapshot& snapshot) const;

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const ClothModel& model() const { return *model_; }
  [[nodiscard]] const ClothState& state() const { return state_; }
  [[nodiscard]] const BodyWorld& bodies() const { return bodies_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::int64_t stepIndex() const { return stepIndex_; }
  [[nodiscard]] bool paused() const { return paused_; }
  /// The second cloth, or nullptr.
  [[nodiscard]] const Ghost* ghost() const { return ghost_ ? &*ghost_ : nullptr; }
  /// True when the last step was undone because the state stopped being finite.
  [[nodiscard]] bool blewUp() const { return blewUp_; }
  /// What the last step cost, without the ghost's [s].
  [[nodiscard]] double lastStepSeconds() const { return stepSeconds_; }
  /// How the last step went.
  [[nodiscard]] const StepReport& lastStepReport() const { return stepReport_; }
  [[nodiscard]] const std::string& message() const { return message_.empty() ? overlapMessage_ : message_; }

  /// The commands since the scene was loaded, in order, each with the number of steps taken before it.
  [[nodiscard]] const std::vector<LoggedCommand>& log() const { return log_; }

  /// Steps taken since the scene was loaded, resets or not.
  [[nodiscard]] std::int64_t stepsTaken() const { return stepsTaken_; }

 private:
  void on(const SetSettingCommand& command);
  void on(const PauseCommand& command);
  void on(const SingleStepCommand& command);
  void on(const ResetCommand& command);
  void on(const GrabCommand& command);
  void on(const MoveGrabCommand& command);
  void on(const ReleaseGrabCommand& command);
  void on(const TogglePinCommand& command);
  void on(const MovePinsCommand& command);
  void on(const SwitchBodyCommand& command);
  void on(const SetSurfaceCommand& command);
  void on(const MoveBodyCommand& command);
  void on(const AllowWorkCommand& command);
  void on(const LoadSceneCommand& command);

  void useSolvers();
  void useBalance();
  void stepGhost();
  void keepBudget();

  /// What the hand holds; its stiffness and force come from the settings at each step.
  struct Held {
    int triangle = 0;
    Vec3 barycentric = Vec3::Zero();
    Vec3 target = Vec3::Zero();  ///< [m]
  };
  [[nodiscard]] std::optional<Grab> grabInForce() const;
  [[nodiscard]] std::size_t requireBody(int body) const;
  void captureBodies(Snapshot& snapshot) const;
  void tellOfOverlap();
  [[nodiscard]] Vec3 grabbedPoint() const;
  [[nodiscard]] int nearestCornerOfGrab() const;

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const ClothModel> model_;
  Settings settings_;
  std::unique_ptr<Stepper> stepper_;
  StepReport stepReport_;
  ClothState state_;
  ClothState lastFinite_;
  std::optional<Ghost> ghost_;
  std::optional<EnergyBalance> balance_;
  WorkBudget budget_;
  bool replaying_ = false;  // what the clock had to say stands in the log
  std::optional<Held> grab_;
  StepInputs inputs_;
  std::function<void()> onProgress_;
  BodyWorld bodies_;
  std::int64_t stepIndex_ = 0;   // since the last reset
  std::int64_t stepsTaken_ = 0;  // since the scene was loaded
  std::int64_t version_ = 0;
  bool paused_ = false;
  bool blewUp_ = false;
  std::string message_;
  std::string overlapMessage_;  // while some of the cloth is inside a body
  double lastOutside_ = 0.0;    // when it last was not [s]
  double stepSeconds_ = 0.0;
  std::vector<LoggedCommand> log_;
};

}  // namespace drape
