#include "session/change_history.hpp"

#include <utility>

namespace drape::session {
namespace {

constexpr double patience = 0.3;  // for the simulation to take commands [s]
constexpr int maxAttempts = 3;

}  // namespace

void ChangeHistory::forget() {
  *this = ChangeHistory();
}

std::optional<UserState> ChangeHistory::observe(const UserState& present, bool settled, double now) {
  if (!state_) {
    state_ = present;
  } else if (awaited_ && areSame(present, *state_)) {
    awaited_ = false;
  } else if (awaited_) {
    if (!settled) {
      since_ = now;
    } else if (now - since_ > patience && attempts_ < maxAttempts) {
      ++attempts_;
      since_ = now;
      return state_;
    } else if (now - since_ > patience) {
      awaited_ = false;  // the simulation refuses a part of it
      state_ = present;
    }
  } else if (settled) {
    record(present);
  }
  return std::nullopt;
}

void ChangeHistory::record(const UserState& present) {
  if (!state_ || areSame(present, *state_)) {
    return;
  }
  past_.push_back(*std::exchange(state_, present));
  if (past_.size() > capacity) {
    past_.pop_front();
  }
  future_.clear();
}

void ChangeHistory::await(const UserState& state, double now) {
  state_ = state;
  awaited_ = true;
  attempts_ = 1;
  since_ = now;
}

std::optional<ChangeHistory::Step> ChangeHistory::undo(const UserState& present, double now) {
  if (!awaited_) {
    record(present);
  }
  if (past_.empty()) {
    return std::nullopt;
  }
  Step step{past_.back(), *state_};
  past_.pop_back();
  future_.push_back(step.after);
  await(step.before, now);
  return step;
}

std::optional<ChangeHistory::Step> ChangeHistory::redo(const UserState& present, double now) {
  if (!awaited_) {
    record(present);
  }
  if (future_.empty()) {
    return std::nullopt;
  }
  Step step{*state_, future_.back()};
  future_.pop_back();
  past_.push_back(step.before);
  await(step.after, now);
  return step;
}

}  // namespace drape::session
