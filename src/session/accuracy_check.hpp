#pragma once

#include "settings/settings.hpp"
#include "sim/measures/accuracy.hpp"
#include "sim/stepping/sewn_cloth.hpp"
#include "sim/stepping/stepper.hpp"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

namespace drape::session {

/// Checks now and then how accurate a motion is. Two copies of the cloth take the steps of the next `window` with the
/// solver `auto` in double, finer steps, the full stiffness and the full lift; the start of the second copy is
/// displaced by a micrometre. Both have the same bodies, attachment and settings, so air, lift and contact are part of
/// the error. The cloth itself is not affected.
///
/// A state that does not follow from the last step, as after a reset, ends a check without a result. The scene whose
/// bodies act must exist as long as the check.
class AccuracyCheck {
 public:
  static constexpr double window = 0.2;    ///< duration of the compared motion [s]
  static constexpr double interval = 5.0;  ///< from the start of a check to the start of the next one [s]

  /// @param inBackground whether the copies run in a thread of their own, or within `follow`
  explicit AccuracyCheck(bool inBackground);
  AccuracyCheck(const AccuracyCheck&) = delete;
  AccuracyCheck& operator=(const AccuracyCheck&) = delete;
  ~AccuracyCheck();

  /// Lets the copies take the step that has brought the cloth from `start` to `end`.
  /// @param inputs of this step. In the background its stop token and its progress callback are not used; elsewhere a
  /// requested stop throws StepStopped
  void follow(const sim::SewnCloth& cloth, const settings::Settings& settings, const sim::StepInputs& inputs,
              const sim::ClothState& start, const sim::ClothState& end);

  /// The last result since the last state that did not follow from a step; empty if there is none.
  [[nodiscard]] std::optional<sim::Accuracy> latest() const;

 private:
  /// A step of the cloth, with everything that the copies need to take it. It points to nothing that changes.
  struct CheckedStep;
  /// The two copies.
  class Copies;
  /// The end of a check.
  struct End {
    std::vector<Vec3> positions;  ///< of the cloth [m]
    double time = 0.0;            ///< [s]
    double seconds = 0.0;         ///< duration of the motion [s]
  };
  using Task = std::variant<std::shared_ptr<const CheckedStep>, End>;

  [[nodiscard]] bool followsLast(const sim::ClothState& start) const;
  [[nodiscard]] bool isDue(double time) const;
  void abandon();
  void post(Task task, const sim::StepInputs& inputs);
  void perform(const Task& task, const sim::StepInputs& inputs);
  void work(const std::stop_token& stop);

  bool inBackground_;
  std::vector<Vec3> lastPositions_;  // at the end of the last step [m]
  double lastTime_ = 0.0;            // likewise [s]
  bool checking_ = false;            // the copies take the present steps
  std::optional<double> lastStart_;  // of a check [s]; empty: none since the motion began
  std::unique_ptr<Copies> copies_;   // used by one thread only

  mutable std::mutex lock_;  // for all below but the thread
  std::condition_variable_any changed_;
  std::deque<Task> tasks_;
  bool busy_ = false;
  int abandoned_ = 0;  // number of checks that were abandoned, so that a late result of one is not used
  std::optional<sim::Accuracy> latest_;
  std::jthread worker_;
};

}  // namespace drape::session
