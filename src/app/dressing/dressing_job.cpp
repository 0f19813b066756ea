#include "app/dressing/dressing_job.hpp"

#include "messages/error.hpp"
#include "messages/sim_error_text.hpp"
#include "session/take_if_ready.hpp"

#include <exception>
#include <utility>

namespace drape::app {
namespace {

struct Cancelled {};

bool isRight(const dressing::Dressed& result) {
  return result.fits && result.after.all() == 0 && result.faults.empty();
}

constexpr const char* advice = "Move the body or the garment, or scale one of them.";

}  // namespace

DressingJob::DressingJob(DressingOrder order) : order_(std::move(order)) {
  running_ = std::async(std::launch::async, [this] { return run(); });
}

DressingJob::~DressingJob() {
  cancel();
}

std::optional<DressingJob::Outcome> DressingJob::poll() {
  return session::takeIfReady(running_);
}

DressingJob::Outcome DressingJob::run() {
  try {
    return order_.onlyPlaces ? placeOnly() : dressFirstThatFits();
  } catch (const Cancelled&) {
    return {text::Sentence(order_.onlyPlaces ? "Placing was cancelled" : "Dressing was cancelled"), false, std::nullopt,
            std::nullopt};
  } catch (const std::bad_alloc&) {
    return {text::Sentence("Not enough memory to dress the body. Use smaller meshes."), true, std::nullopt,
            std::nullopt};
  } catch (const std::exception& error) {
    return {messages::sentenceOf(error), true, std::nullopt, std::nullopt};
  }
}

/// The result of the first attempt that leaves nothing wrong. Else the last one that can be worn, or the reason why
/// none can.
DressingJob::Outcome DressingJob::dressFirstThatFits() {
  const auto model = sim::withPins(*order_.model, std::vector<bool>(order_.model->pinned.size(), false));
  std::optional<Outcome> worn;
  text::Sentence refusal;
  for (const DressingAttempt& attempt : order_.attempts) {
    requireDressable(order_.names, {attempt.start, model->triangles}, attempt.body);
    dressing::Dressed result = dressBy(*model, attempt);
    if (!result.fits) {
      refusal = refusalOf(result, order_.names.garment).append(" ", text::Sentence(advice));
      continue;
    }
    const bool right = isRight(result);
    const WearNames& names = order_.names;
    const text::Sentence summary = summaryOf(result, attempt.isByHand);
    Outcome outcome{right ? text::Sentence("Dressed {} on {}: {}", names.garment, names.body, summary)
                          : text::Sentence("Not all is right with {} on {}: {}. {}", names.garment, names.body, summary,
                                           text::Sentence(advice)),
                    !right, session::PlaceClothCommand{std::move(result.positions), attempt.isStart}, std::nullopt};
    if (right) {
      return outcome;
    }
    worn = std::move(outcome);
  }
  return worn ? *std::move(worn) : Outcome{refusal, true, std::nullopt, std::nullopt};
}

DressingJob::Outcome DressingJob::placeOnly() {
  const DressingAttempt& attempt = order_.attempts.front();
  requireDressable(order_.names, {attempt.start, order_.model->triangles}, attempt.body);
  const dressing::Placement placement =
      dressing::placeOn(*order_.model, attempt.start, attempt.body, optionsFor(attempt));
  return {text::Sentence("Put {} on {}, {}. Move, turn or scale it, then press Dress", order_.names.garment,
                         order_.names.body, inWords(placement.rule)),
          false, std::nullopt, placement.pose};
}

dressing::DressingOptions DressingJob::optionsFor(const DressingAttempt& attempt) {
  dressing::DressingOptions options = order_.options;
  options.rule = attempt.rule;
  options.progress = [this](dressing::Stage stage, double share) {
    if (stop_.stop_requested()) {
      throw Cancelled();
    }
    stage_ = stage;
    share_ = share;
  };
  return options;
}

dressing::Dressed DressingJob::dressBy(const sim::ClothModel& model, const DressingAttempt& attempt) {
  return dressing::dress(model, attempt.start, attempt.body, optionsFor(attempt));
}

}  // namespace drape::app
