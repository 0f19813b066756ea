#pragma once

#include "session/accuracy_check.hpp"
#include "session/command.hpp"
#include "session/cost_budget.hpp"
#include "session/ghost.hpp"
#include "session/snapshot.hpp"
#include "session/timeline.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/contact/exact/intersection_search.hpp"
#include "sim/stepping/sewn_cloth.hpp"
#include "sim/stepping/stepper.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace drape::session {

/// A running scene: model, state, settings and solver, changed by commands and advanced by steps. It has no thread; the
/// viewer's thread, drape-headless and the tests all use this class.
class Simulation {
 public:
  explicit Simulation(std::shared_ptr<const scene::Scene> scene);

  /// Takes effect at once; call it between two steps. An invalid command (a value out of range, a triangle that does
  /// not exist) changes nothing and sets the message.
  void apply(const Command& command);

  /// Advances by one time step, paused or not. When the state is no longer finite, the simulation returns to the last
  /// finite state, pauses and sets the message. An unstable ghost is removed; the first cloth continues.
  void step();

  /// Sets the token that cancels a long step: a requested stop makes step() throw StepStopped. The simulation must not
  /// be used after that.
  void setStopToken(std::stop_token token) { inputs_.stop = std::move(token); }

  /// Sets a function that long steps call from time to time. An exception from it leaves step(). The simulation must
  /// not be used after that.
  void setProgressCallback(std::function<void()> callback) { onProgress_ = std::move(callback); }

  /// Lets checks of the accuracy (settings `error_check`) run in a thread of their own. Off: they are part of step(),
  /// so that their results do not depend on the speed of the machine.
  void setAccuracyInBackground(bool inBackground);

  /// Runs the log of another simulation of the same scene, with the steps between its commands. The states are
  /// bit-identical.
  /// @param steps to take in all; after the last command the rest of them follow
  /// @param afterStep is called after each step
  void replay(const std::vector<LoggedCommand>& log, std::int64_t steps = 0,
              const std::function<void()>& afterStep = {});

  /// Continues from another state of this scene, `step` steps after the start. Bodies are where their motion has them
  /// at the time of the state; the energy balance starts anew.
  void continueFrom(sim::ClothState state, std::int64_t step);

  /// The present state, as the timeline keeps it.
  [[nodiscard]] RecordedState recorded() const;
  /// Returns to a state of this scene, with its ghost and the places of its bodies.
  void continueFrom(const RecordedState& recorded);

  /// Fills `snapshot` with the current state, reusing its memory.
  void capture(Snapshot& snapshot) const;

  [[nodiscard]] const scene::Scene& scene() const { return *scene_; }
  /// The cloth as it is now. It changes when a seam is welded.
  [[nodiscard]] const sim::ClothModel& model() const { return *model_; }
  /// The cloth and its seams.
  [[nodiscard]] const sim::SewnCloth& cloth() const { return cloth_; }
  [[nodiscard]] const sim::ClothState& state() const { return state_; }
  [[nodiscard]] const sim::contact::BodyWorld& bodies() const { return bodies_; }
  [[nodiscard]] const settings::Settings& settings() const { return settings_; }
  /// The seams and the elastic bands in force.
  [[nodiscard]] const scene::Sewing& sewing() const { return *sewing_; }
  [[nodiscard]] std::int64_t stepIndex() const { return stepIndex_; }
  [[nodiscard]] bool paused() const { return paused_; }
  /// Snapshot::pictureVersion.
  [[nodiscard]] std::int64_t pictureVersion() const { return pictureVersion_; }
  /// The second cloth, or nullptr.
  [[nodiscard]] const Ghost* ghost() const { return ghost_ ? &*ghost_ : nullptr; }
  /// Whether the last step was undone because the state was no longer finite.
  [[nodiscard]] bool blewUp() const { return blewUp_; }
  /// Duration of the last step, without the ghost's [s].
  [[nodiscard]] double lastStepSeconds() const { return stepSeconds_; }
  /// The report of the last step.
  [[nodiscard]] const sim::StepReport& lastStepReport() const { return stepReport_; }
  /// The last result of the check of the accuracy; empty: none.
  [[nodiscard]] std::optional<sim::Accuracy> accuracy() const { return accuracy_ ? accuracy_->latest() : std::nullopt; }
  [[nodiscard]] const text::Sentence& message() const { return message_.empty() ? overlapMessage_ : message_; }

  /// The commands since the scene was loaded, in order, each with the number of steps before it.
  [[nodiscard]] const std::vector<LoggedCommand>& log() const { return log_; }

  /// Steps since the scene was loaded; a reset does not clear them.
  [[nodiscard]] std::int64_t stepsTaken() const { return stepsTaken_; }

 private:
  void on(const SetSettingCommand& command);
  void on(const UseFabricCommand& command);
  void on(const SetOwnFabricsCommand& command);
  void on(const PauseCommand& command);
  void on(const SingleStepCommand& command);
  void on(const ResetCommand& command);
  void on(const AttachCommand& command);
  void on(const MoveAttachmentCommand& command);
  void on(const DetachCommand& command);
  void on(const TogglePinCommand& command);
  void on(const SetPinsCommand& command);
  void on(const PlacePinsCommand& command);
  void on(const MovePinsCommand& command);
  void on(const SetPinPathsCommand& command);
  void on(const SetSewingCommand& command);
  void on(const UntangleCommand& command);
  void on(const PlaceClothCommand& command);
  void on(const SwitchBodyCommand& command);
  void on(const SetSurfaceCommand& command);
  void on(const MoveBodyCommand& command);
  void on(const SetFigureCommand& command);
  void on(const SetCostBudgetCommand& command);
  void on(const ObserveCommand& command);
  void on(const GoToCommand& command);
  void on(const StepBackCommand& command);
  void on(const LoadSceneCommand& command);

  /// The pieces of the cloth with other pins, masses or materials.
  void changeCloth(std::shared_ptr<const sim::ClothModel> pieces);
  /// The seams of another sewing; those that stay keep their start. Throws InputError.
  [[nodiscard]] std::vector<sim::Seam> seamsFor(const scene::Sewing& sewing, const sim::ClothModel& pieces) const;
  /// Gives the seams other starts [s], one each.
  void startSeams(const std::function<double(const sim::Seam& seam)>& startOf);
  /// Takes the model for the state, which was replaced.
  void followState();
  void closeSeams();
  void useSettings(settings::Settings changed, settings::SettingEffect effect);
  void useSolvers();
  void noteChange();
  [[nodiscard]] bool isStill() const;
  void useBalance();
  void useAccuracyCheck();
  void checkAccuracy();
  void restAt(std::vector<Vec3> positions);
  void stepGhost();
  void updateCostBudget();

  void limitAttachment();
  [[nodiscard]] std::size_t requireVertex(int vertex) const;
  [[nodiscard]] std::size_t requireBody(int body) const;
  [[nodiscard]] std::shared_ptr<const figure::MovingFigure> figureAt(std::size_t body) const;
  void restartFigures();
  void captureBodies(Snapshot& snapshot) const;
  void captureContact(Snapshot& snapshot) const;
  void captureForFields(Snapshot& snapshot) const;
  /// Whether the snapshots have what fields need.
  [[nodiscard]] bool isObserved() const { return observed_ || settings_.view.colourMap != "off"; }
  void reportOverlap();

  std::shared_ptr<const scene::Scene> scene_;
  sim::SewnCloth cloth_;
  std::shared_ptr<const sim::ClothModel> model_;  // that of cloth_
  settings::Settings settings_;
  std::unique_ptr<sim::Stepper> stepper_;
  std::unique_ptr<sim::contact::IntersectionSearch> intersections_ =  // for drawing; never null
      std::make_unique<sim::contact::IntersectionSearch>();
  sim::StepReport stepReport_;
  sim::ClothState state_;
  sim::ClothState lastFinite_;
  std::shared_ptr<const std::vector<Vec3>> placedStart_;  // instead of the scene's start; null: none
  std::optional<Ghost> ghost_;
  std::optional<sim::EnergyBalance> balance_;
  std::unique_ptr<AccuracyCheck> accuracy_;  // null: off
  bool accuracyInBackground_ = false;
  CostBudget budget_;
  bool replaying_ = false;  // commands that depend on the clock come from the log
  sim::StepInputs inputs_;  // its attachment is the current one
  std::function<void()> onProgress_;
  sim::contact::BodyWorld bodies_;
  std::shared_ptr<const std::vector<scene::PinPath>> pinPaths_;  // never null
  std::shared_ptr<const scene::Sewing> sewing_;                  // never null
  std::vector<scene::ClothPart> cloths_;                         // those of the scene, with the bands of sewing_
  std::vector<sim::MovedPin> movedPins_;                         // in the next step
  std::int64_t stepIndex_ = 0;                                   // since the last reset
  std::int64_t stepsTaken_ = 0;                                  // since the scene was loaded
  std::int64_t version_ = 0;
  std::int64_t pictureVersion_ = 0;
  bool paused_ = false;
  bool observed_ = false;
  bool blewUp_ = false;
  Timeline timeline_;
  text::Sentence message_;
  text::Sentence overlapMessage_;  // while part of the cloth is inside a body
  double lastOutside_ = 0.0;       // last time without overlap [s]
  double stepSeconds_ = 0.0;
  std::vector<LoggedCommand> log_;
};

}  // namespace drape::session
