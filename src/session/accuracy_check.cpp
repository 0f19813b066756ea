#include "session/accuracy_check.hpp"

#include "sim/contact/bodies/substeps.hpp"
#include "sim/measures/measures.hpp"
#include "sim/model/sim_error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace drape::session {
namespace {

/// The solver of the copies.
constexpr const char* referenceSolver = "auto";

/// The parameters of the copies: those of the cloth with finer steps, without the errors that `auto` accepts by its
/// lift, by a lower stiffness and by float, and on one thread.
sim::StepParameters parametersOfCopies(const sim::StepParameters& parameters) {
  constexpr int refinement = 2;
  sim::StepParameters finer = parameters;
  finer.automatic.refinement = refinement;
  finer.automatic.fullLift = true;
  finer.automatic.soften = false;
  finer.automatic.strainLimit = 0.0;
  finer.precision = sim::Precision::Double;
  finer.threads = 1;
  return finer;
}

}  // namespace

struct AccuracyCheck::CheckedStep {
  CheckedStep(const sim::SewnCloth& cloth, const settings::Settings& settings, const sim::StepInputs& inputs,
              const sim::ClothState& before, bool isFirstOfCheck)
      : isFirst(isFirstOfCheck),
        start(before),
        model(cloth.model()),
        parameters(parametersOfCopies(cloth.acting(settings.step, before.time))),
        seams(cloth.openSeams().begin(), cloth.openSeams().end()),
        attachment(inputs.attachment) {
    if (inputs.movedPins != nullptr) {
      movedPins = *inputs.movedPins;
    }
    if (inputs.bodies != nullptr) {
      bodies_ = &bodySubsteps_.between(*inputs.bodies, 0.0, 1.0);
    }
  }
  CheckedStep(const CheckedStep&) = delete;  // bodies_ points into it
  CheckedStep& operator=(const CheckedStep&) = delete;

  /// The inputs of the copies. They point into this step.
  [[nodiscard]] sim::StepInputs inputs(const sim::StepInputs& outer) const {
    return {.attachment = attachment,
            .bodies = bodies_,
            .movedPins = movedPins.empty() ? nullptr : &movedPins,
            .stop = outer.stop,
            .onProgress = outer.onProgress};
  }

  bool isFirst;  // of its check
  sim::ClothState start;
  std::shared_ptr<const sim::ClothModel> model;
  sim::StepParameters parameters;
  std::vector<sim::Seam> seams;  // that are open
  std::optional<sim::Attachment> attachment;
  std::vector<sim::MovedPin> movedPins;

 private:
  sim::contact::BodySubsteps bodySubsteps_;  // with the vertices of deforming bodies, which change with the next step
  const std::vector<sim::contact::BodyStep>* bodies_ = nullptr;
};

class AccuracyCheck::Copies {
 public:
  void take(const CheckedStep& step, const sim::StepInputs& outer) {
    if (step.isFirst) {
      begin(step);
    }
    if (failed_) {
      return;
    }
    const sim::StepInputs inputs = step.inputs(outer);
    try {
      for (Copy& copy : copies_) {
        copy.stepper.drawTogether(step.seams);
        copy.stepper.step(*step.model, step.parameters, inputs, copy.state);
      }
    } catch (const sim::SimError&) {
      failed_ = true;
    }
  }

  /// Empty if a copy could not be simulated or is no longer finite.
  [[nodiscard]] std::optional<sim::Accuracy> compare(const End& end) const {
    const sim::ClothState& reference = copies_.front().state;
    const sim::ClothState& displaced = copies_.back().state;
    if (failed_ || !sim::isFinite(reference) || !sim::isFinite(displaced) ||
        reference.positions.size() != end.positions.size()) {
      return std::nullopt;
    }
    // The distance is 3/4 of the error of a second-order method (Richardson), and nearly the whole error of others.
    return sim::Accuracy{.time = end.time,
                         .seconds = end.seconds,
                         .error = sim::meanDistance(end.positions, reference.positions),
                         .spread = sim::meanDistance(reference.positions, displaced.positions)};
  }

 private:
  struct Copy {
    sim::Stepper stepper{referenceSolver};
    sim::ClothState state;
  };

  void begin(const CheckedStep& step) {
    failed_ = false;
    for (Copy& copy : copies_) {
      copy.state = step.start;
    }
    sim::displaceForTest(step.model->pinned, copies_.back().state.positions);
  }

  std::array<Copy, 2> copies_;
  bool failed_ = false;
};

AccuracyCheck::AccuracyCheck(bool inBackground) : inBackground_(inBackground), copies_(std::make_unique<Copies>()) {
  if (inBackground_) {
    worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  }
}

AccuracyCheck::~AccuracyCheck() = default;

bool AccuracyCheck::followsLast(const sim::ClothState& start) const {
  return start.time == lastTime_ && start.positions == lastPositions_;
}

bool AccuracyCheck::isDue(double time) const {
  const std::scoped_lock lock(lock_);
  return (!lastStart_ || time >= *lastStart_ + interval) && tasks_.empty() && !busy_;
}

void AccuracyCheck::abandon() {
  checking_ = false;
  lastStart_.reset();
  const std::scoped_lock lock(lock_);
  tasks_.clear();
  ++abandoned_;
  latest_.reset();
}

void AccuracyCheck::follow(const sim::SewnCloth& cloth, const settings::Settings& settings,
                           const sim::StepInputs& inputs, const sim::ClothState& start, const sim::ClothState& end) {
  constexpr double rounding = 1e-9;  // [s]
  if (!followsLast(start)) {
    abandon();
  }
  const bool isFirst = !checking_ && isDue(start.time);
  if (isFirst) {
    checking_ = true;
    lastStart_ = start.time;
  }
  if (checking_) {
    post(std::make_shared<const CheckedStep>(cloth, settings, inputs, start, isFirst), inputs);
    const double seconds = end.time - *lastStart_;
    if (seconds > window - rounding) {
      post(End{end.positions, end.time, seconds}, inputs);
      checking_ = false;
    }
  }
  lastPositions_ = end.positions;
  lastTime_ = end.time;
}

std::optional<sim::Accuracy> AccuracyCheck::latest() const {
  const std::scoped_lock lock(lock_);
  return latest_;
}

void AccuracyCheck::post(Task task, const sim::StepInputs& inputs) {
  if (!inBackground_) {
    perform(task, inputs);
    return;
  }
  {
    const std::scoped_lock lock(lock_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_one();
}

void AccuracyCheck::perform(const Task& task, const sim::StepInputs& inputs) {
  if (const auto* const step = std::get_if<std::shared_ptr<const CheckedStep>>(&task)) {
    copies_->take(**step, inputs);
    return;
  }
  const std::optional<sim::Accuracy> result = copies_->compare(std::get<End>(task));
  const std::scoped_lock lock(lock_);
  latest_ = result;
}

void AccuracyCheck::work(const std::stop_token& stop) {
  sim::StepInputs inputs;
  inputs.stop = stop;
  std::unique_lock lock(lock_);
  while (changed_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
    const Task task = std::move(tasks_.front());
    tasks_.pop_front();
    busy_ = true;
    const int abandoned = abandoned_;
    lock.unlock();
    try {
      perform(task, inputs);
    } catch (const sim::StepStopped&) {
      return;
    }
    lock.lock();
    busy_ = false;
    if (abandoned != abandoned_) {
      latest_.reset();
    }
  }
}

}  // namespace drape::session
